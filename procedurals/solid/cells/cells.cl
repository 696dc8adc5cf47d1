// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi cells around jittered seeds (Worley 1996, "A cellular texture basis function") in a
// domain warped by the fractal field, and the share of a pixel's filter that each cell covers.
// There is one seed in each cube of a grid; lengths are in units of these cubes. Needs solid.cl.

#define CELLS_MAX_SEEDS 40
// The search radius for seeds; the nearest is never farther than a cube's diagonal, sqrt(3). Five
// cubes along each axis cover it: they hold 22 seeds within it on average, and never more than 40.
#define CELLS_REACH 1.75f

// Domain warping: three uncorrelated parts of one fractal lattice displace a point along x, y and
// z.
typedef struct {
    Placement placement;
    float length; // displacement per unit of D [m]
} Warp;

typedef struct {
    Triple position;    // the warped position of the filter's centre [m]
    Triple gradient[3]; // rows of the Jacobian: gradients of its x, y, z in object space
    Triple across;      // the sides of the filter after warping [m]
    Triple along;
    float variance;     // of the position by unresolved levels, in addition to the sides [m^2]
    float field;        // D of the x displacement, which also drives shades of colour
    Triple field_slope; // its gradient [1/m]
    uint instance;      // key of the instance
} WarpedPoint;

// A grid of cubes: place = rows * position + offset.
typedef struct {
    Triple rows[3];
    Triple offset;
    Triple squares; // squared lengths of the rows, which are orthogonal
    uint key;
    float jitter; // 0: seeds in the centres of their cubes, 1: anywhere in them
} Cells;

// The filter in the coordinates of a grid.
typedef struct {
    Triple place;
    Triple across;
    Triple along;
    Triple variance; // along the grid's axes, in addition to the sides
    float width;     // of a box filter with the same total variance
    uint key;
} CellView;

typedef struct {
    Triple away; // vector from the place to the seed
    uint bits;   // the seed's random bits
} Seed;

// The seeds that affect a filter, the nearest first, and the share of the filter in each cell. A
// texture uses one such list for all its look-ups, since devices have little private memory.
typedef struct {
    int count;
    Seed seed[CELLS_MAX_SEEDS + 1];
    float share[CELLS_MAX_SEEDS];
} Seeds;

static inline WarpedPoint warp_point(Field field, global const Warp* warp, Triple position,
                                     Triple across, Triple along, float random) {
    const Placement placement = warp->placement;
    Triple place = plus(multiply(placement.rows, position), placement.offset);
    WarpedPoint found;
    found.instance = 0U;
    if (placement.vary > 0.0f) {
        place = plus(place, triple(random * 47.31f, random * 23.17f, random * 91.73f));
        found.instance = scramble((uint)as_int(random) + 1U);
    }
    // Levels that are not stored are too fine to affect the shape of a cell.
    const int levels = field.lattice->levels;
    const float width =
        fmax(filter_width(&placement, across, along), 1.41422f / (float)(1 << levels));
    const float k = warp->length;
    const Fluctuation x = fluctuation(field.lattice, field.nodes16, field.nodes32, place, width);
    const Fluctuation y = fluctuation(field.lattice, field.nodes16, field.nodes32,
                                      plus(place, triple(0.37f, 0.71f, 0.19f)), width);
    const Fluctuation z = fluctuation(field.lattice, field.nodes16, field.nodes32,
                                      plus(place, triple(0.83f, 0.29f, 0.57f)), width);
    found.position = plus(position, triple(k * x.value, k * y.value, k * z.value));
    found.field = x.value;
    found.field_slope = multiply_transposed(placement.rows, x.gradient);
    Triple* g = found.gradient;
    g[0] = plus(triple(1.0f, 0.0f, 0.0f), scaled(found.field_slope, k));
    g[1] =
        plus(triple(0.0f, 1.0f, 0.0f), scaled(multiply_transposed(placement.rows, y.gradient), k));
    g[2] =
        plus(triple(0.0f, 0.0f, 1.0f), scaled(multiply_transposed(placement.rows, z.gradient), k));
    found.across = multiply(g, across);
    found.along = multiply(g, along);
    found.variance = square(k) * fmax(x.variance - field.lattice->residual_variance[levels], 0.0f);
    return found;
}

// Transforms a gradient with respect to the warped position to one in object space.
static inline Triple gradient_before_warp(WarpedPoint place, Triple gradient) {
    return multiply_transposed(place.gradient, gradient);
}

static inline CellView cell_view(global const Cells* cells, WarpedPoint at) {
    Triple rows[3];
    for (int i = 0; i < 3; ++i)
        rows[i] = cells->rows[i];
    const float limit = 1e9f; // within the range of int
    const Triple p = plus(multiply(rows, at.position), cells->offset);
    CellView view;
    view.place = triple(clamped(p.x, -limit, limit), clamped(p.y, -limit, limit),
                        clamped(p.z, -limit, limit));
    view.across = multiply(rows, at.across);
    view.along = multiply(rows, at.along);
    const Triple s = cells->squares;
    view.variance = scaled(s, at.variance);
    view.width = sqrt(fmax(dot3(view.across, view.across), dot3(view.along, view.along)) +
                      12.0f * at.variance * fmax(s.x, fmax(s.y, s.z)));
    view.key = cells->key ^ at.instance;
    return view;
}

// Transforms a gradient with respect to the place in the grid to one by the warped position.
static inline Triple gradient_of_cells(global const Cells* cells, Triple gradient) {
    return plus(plus(scaled(cells->rows[0], gradient.x), scaled(cells->rows[1], gradient.y)),
                scaled(cells->rows[2], gradient.z));
}

// Further random bits of a seed, one set for each use.
static inline uint seed_bits(Seed seed, uint use) {
    return scramble(seed.bits + use * 0x9e3779b9U);
}
static inline float seed_uniform(Seed seed, uint use) { return uniform_of(seed_bits(seed, use)); }

// The five cubes along an axis from near to far: their steps and squared distances.
static inline void nearest_cubes(float share, float* far, int* step) {
    const int side = share < 0.5f ? -1 : 1;
    const float near = share < 0.5f ? share : 1.0f - share;
    for (int i = 0; i < 5; ++i) {
        const int ring = (i + 1) / 2;
        const int towards = i % 2 == 1;
        step[i] = towards ? ring * side : -ring * side;
        far[i] = i == 0 ? 0.0f : square((towards ? near : 1.0f - near) + (float)(ring - 1));
    }
}

static inline float far_square(Seed seed) { return dot3(seed.away, seed.away); }

static inline Seed seed_in(int x, int y, int z, uint bits, float jitter) {
    const float low = 0.5f - 0.5f * jitter, unit = jitter * (1.0f / 2048.0f);
    Seed seed;
    seed.bits = bits;
    seed.away = triple((float)x + low + unit * ((float)(bits >> 21) + 0.5f),
                       (float)y + low + unit * ((float)((bits >> 10) & 2047U) + 0.5f),
                       (float)z + low + 2.0f * unit * ((float)(bits & 1023U) + 0.5f));
    return seed;
}

// Finds the seeds within `reach` whose distance exceeds that of the nearest by at most 2 `margin`,
// or whose squared distance exceeds it by at most `soft`, whichever is more. The distance of a
// border is at least half the difference of the distances of its two seeds, so all cells within
// `margin` are found.
static inline void gather_seeds(CellView view, float jitter, float reach, float margin, float soft,
                                Seeds* seeds) {
    const Triple cube = triple(floor(view.place.x), floor(view.place.y), floor(view.place.z));
    const Triple in = minus(view.place, cube);
    float x_far[5], y_far[5], z_far[5];
    int x_step[5], y_step[5], z_step[5];
    nearest_cubes(in.x, x_far, x_step);
    nearest_cubes(in.y, y_far, y_step);
    nearest_cubes(in.z, z_far, z_step);
    float limit = square(reach), nearest = 1e30f;
    int count = 0;
    for (int k = 0; k < 5 && z_far[k] < limit; ++k)
        for (int j = 0; j < 5 && z_far[k] + y_far[j] < limit; ++j) {
            const uint row = scramble(view.key + (uint)((int)cube.y + y_step[j]) * 0x9e3779b9U +
                                      (uint)((int)cube.z + z_step[k]) * 0x85ebca6bU);
            const uint other = row * 0x2c1b3c6dU;
            for (int i = 0;
                 i < 5 && z_far[k] + y_far[j] + x_far[i] < limit && count < CELLS_MAX_SEEDS; ++i) {
                Seed seed = seed_in(x_step[i], y_step[j], z_step[k],
                                    node_bits(row, other, (uint)((int)cube.x + x_step[i])), jitter);
                seed.away = minus(seed.away, in);
                const float far = far_square(seed);
                const int counts = far < limit ? 1 : 0;
                // Written unconditionally and counted without a branch, which would be
                // unpredictable.
                seeds->seed[count] = seed;
                if (far < nearest) {
                    nearest = far;
                    limit = fmin(limit, fmax(square(sqrt(far) + 2.0f * margin), far + soft));
                    seeds->seed[count] = seeds->seed[0];
                    seeds->seed[0] = seed;
                }
                count += counts;
            }
        }
    // Removes seeds that were accepted before the nearest one narrowed the limit.
    seeds->count = count > 0 ? 1 : 0;
    for (int i = 1; i < count; ++i) {
        const Seed seed = seeds->seed[i];
        seeds->seed[seeds->count] = seed;
        seeds->count += far_square(seed) < limit ? 1 : 0;
    }
}

// Standard deviation of the filter along a vector, times the length of the vector.
static inline float deviation_along(CellView view, Triple v) {
    return sqrt((square(dot3(v, view.across)) + square(dot3(v, view.along))) * (1.0f / 12.0f) +
                v.x * v.x * view.variance.x + v.y * v.y * view.variance.y +
                v.z * v.z * view.variance.z);
}

// A box filter covers no border beyond this many standard deviations. Seeds are farther than the
// nearest by at most twice the largest margin.
#define CELLS_DEVIATIONS 1.9f
#define CELLS_MARGIN 0.45f

// Above 0 for unfiltered points too: a point without a border in reach must lie clearly beyond the
// gap along borders, not on its edge.
static inline float border_margin(CellView view) {
    return clamped(CELLS_DEVIATIONS * 0.28867513f * view.width, 1e-5f, CELLS_MARGIN);
}

// Blend factor towards the mean of space for filters wider than some cells, from 0 to 1.
static inline float cells_blur(float width) { return smooth(1.2f, 2.4f, width); }

// The ratio of the filter's share in the second cell to that in the first, by the plane between
// them; the second seed is the farther one. For a plane z standard deviations from the centre of a
// box filter, the ratio lies between those of a box parallel to the plane and of a box standing on
// a corner, and reaches 0 where these do.
static inline float cell_odds(CellView view, Seed first, Seed second) {
    const float z = 0.5f * (far_square(second) - far_square(first)) /
                    (deviation_along(view, minus(second.away, first.away)) + 1e-12f);
    return z < CELLS_DEVIATIONS ? fmax(exp(-z * (1.25f + 0.1f * z * z)) - 0.0469f, 0.0f) * 1.0492f
                                : 0.0f;
}

// Computes the share of the filter in each cell: the normalised ratios to the nearest cell. Where
// the second nearest seed is almost as near, they are blended with the ratios to that one, so that
// the result is continuous where the two swap.
static inline void cell_shares(CellView view, Seeds* seeds) {
    const Seed first = seeds->seed[0];
    const float away = sqrt(far_square(first));
    float sum = 1.0f;
    seeds->share[0] = 1.0f;
    int kept = 1, second = 0;
    for (int i = 1; i < seeds->count; ++i) {
        const Seed seed = seeds->seed[i];
        // Fades to 0 at the limit of the search.
        const float share =
            cell_odds(view, first, seed) *
            smooth(2.0f * CELLS_MARGIN, 1.2f * CELLS_MARGIN, sqrt(far_square(seed)) - away);
        if (!(share > 0.0f))
            continue;
        if (second == 0 || far_square(seed) < far_square(seeds->seed[second]))
            second = kept;
        seeds->seed[kept] = seed;
        seeds->share[kept++] = share;
        sum += share;
    }
    seeds->count = kept;
    const float tied = kept > 2 ? 0.5f * smooth(0.6f, 1.0f, seeds->share[second]) : 0.0f;
    if (tied > 0.0f) {
        const Seed rival = seeds->seed[second];
        float rival_sum = 1.0f + 1.0f / seeds->share[second];
        for (int i = 1; i < kept; ++i)
            rival_sum += i == second ? 0.0f : cell_odds(view, rival, seeds->seed[i]);
        for (int i = 0; i < kept; ++i) {
            const float odds = i == 0        ? 1.0f / seeds->share[second]
                               : i == second ? 1.0f
                                             : cell_odds(view, rival, seeds->seed[i]);
            seeds->share[i] = lerp(seeds->share[i] / sum, odds / rival_sum, tied);
        }
        return;
    }
    for (int i = 0; i < kept; ++i)
        seeds->share[i] /= sum;
}

// The plane between the cell of the nearest seed and that of seed `i`: its distance, and the unit
// vector away from it.
static inline float plane_distance(const Seeds* seeds, int i, Triple* inwards) {
    const Triple between = minus(seeds->seed[i].away, seeds->seed[0].away);
    const float span = length_of(between) + 1e-12f;
    *inwards = scaled(between, -1.0f / span);
    return 0.5f * (far_square(seeds->seed[i]) - far_square(seeds->seed[0])) / span;
}

// Distance to the nearest border of the cell, if all seeds within a margin of that distance are
// known; `none` if there is no other seed.
static inline float border_distance(const Seeds* seeds, float none, Triple* inwards) {
    float distance = none;
    *inwards = triple(0.0f, 0.0f, 0.0f);
    for (int i = 1; i < seeds->count; ++i) {
        Triple away;
        const float d = plane_distance(seeds, i, &away);
        if (d < distance) {
            distance = d;
            *inwards = away;
        }
    }
    return distance;
}
