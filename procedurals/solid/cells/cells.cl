// SPDX-License-Identifier: GPL-3.0-or-later
// Cells around scattered seeds (Worley 1996, "A cellular texture basis function"), in a place that
// the fractal field has pushed about, and how much of a pixel's filter each of them has. One seed
// lies in each cube of a grid; lengths are counted in such cubes. Needs solid.cl.

#define CELLS_MOST 40
// Seeds are looked for within; the nearest is never farther than a cube's diagonal. Five cubes
// along each axis hold all of them: 22 on the average, and never more than 40.
#define CELLS_REACH 1.75f

// Three fields, far apart in one lattice, move the place along x, y and z.
typedef struct {
    Placement placement;
    float length; // per unit of D [m]
} Push;

typedef struct {
    Triple position;    // where the filter's middle was pushed from [m]
    Triple gradient[3]; // of its x, y and z by the object's place
    Triple across;      // the filter there [m]
    Triple along;
    float variance;     // of the place within it, beside its sides [m^2]
    float field;        // the first D, which also drives shades of colour
    Triple field_slope; // [1/m]
    uint instance;      // key
} Pushed;

// place = rows * position + offset.
typedef struct {
    Triple rows[3];
    Triple offset;
    Triple squares; // of the rows' lengths, which are at right angles
    uint key;
    float jitter; // 1: seeds lie anywhere in their cubes
} Cells;

// The filter as a grid of cells sees it.
typedef struct {
    Triple place;
    Triple across;
    Triple along;
    Triple variance; // along the grid's axes, beside the sides
    float width;     // of all that together; a box's
    uint key;
} CellView;

typedef struct {
    Triple away; // from the place to the seed
    uint bits;   // random, of the seed
} Seed;

// Those that matter to a filter, the nearest first, and how much of it each has. There is one such
// list for all that a texture looks up, since devices have little memory of a point's own.
typedef struct {
    int count;
    Seed seed[CELLS_MOST + 1];
    float share[CELLS_MOST];
} Seeds;

static inline Pushed pushed(Field field, global const Push* push, Triple position, Triple across,
                            Triple along, float random) {
    const Placement placement = push->placement;
    Triple place = plus(turned(placement.rows, position), placement.offset);
    Pushed found;
    found.instance = 0U;
    if (placement.vary > 0.0f) {
        place = plus(place, triple(random * 47.31f, random * 23.17f, random * 91.73f));
        found.instance = scramble((uint)as_int(random) + 1U);
    }
    // What is not stored is finer than what shapes a cell.
    const int levels = field.lattice->levels;
    const float width =
        fmax(filter_width(&placement, across, along), 1.41422f / (float)(1 << levels));
    const float k = push->length;
    const Fluctuation x = fluctuation(field.lattice, field.nodes16, field.nodes32, place, width);
    const Fluctuation y = fluctuation(field.lattice, field.nodes16, field.nodes32,
                                      plus(place, triple(0.37f, 0.71f, 0.19f)), width);
    const Fluctuation z = fluctuation(field.lattice, field.nodes16, field.nodes32,
                                      plus(place, triple(0.83f, 0.29f, 0.57f)), width);
    found.position = plus(position, triple(k * x.value, k * y.value, k * z.value));
    found.field = x.value;
    found.field_slope = turned_back(placement.rows, x.gradient);
    Triple* g = found.gradient;
    g[0] = plus(triple(1.0f, 0.0f, 0.0f), scaled(found.field_slope, k));
    g[1] = plus(triple(0.0f, 1.0f, 0.0f), scaled(turned_back(placement.rows, y.gradient), k));
    g[2] = plus(triple(0.0f, 0.0f, 1.0f), scaled(turned_back(placement.rows, z.gradient), k));
    found.across = turned(g, across);
    found.along = turned(g, along);
    found.variance = square(k) * fmax(x.variance - field.lattice->left_out[levels], 0.0f);
    return found;
}

// The gradient by the object's place of what has this one by the pushed place.
static inline Triple gradient_before(Pushed place, Triple gradient) {
    return turned_back(place.gradient, gradient);
}

static inline CellView cell_view(global const Cells* cells, Pushed at) {
    Triple rows[3];
    for (int i = 0; i < 3; ++i)
        rows[i] = cells->rows[i];
    const float most = 1e9f; // what integers can count
    const Triple p = plus(turned(rows, at.position), cells->offset);
    CellView view;
    view.place =
        triple(limited(p.x, -most, most), limited(p.y, -most, most), limited(p.z, -most, most));
    view.across = turned(rows, at.across);
    view.along = turned(rows, at.along);
    const Triple s = cells->squares;
    view.variance = scaled(s, at.variance);
    view.width = sqrt(fmax(inner(view.across, view.across), inner(view.along, view.along)) +
                      12.0f * at.variance * fmax(s.x, fmax(s.y, s.z)));
    view.key = cells->key ^ at.instance;
    return view;
}

// The gradient by the pushed place of what has this one by the cells' place.
static inline Triple gradient_of_cells(global const Cells* cells, Triple gradient) {
    return plus(plus(scaled(cells->rows[0], gradient.x), scaled(cells->rows[1], gradient.y)),
                scaled(cells->rows[2], gradient.z));
}

// Another random number of a seed.
static inline uint seed_bits(Seed seed, uint use) {
    return scramble(seed.bits + use * 0x9e3779b9U);
}
static inline float seed_unit(Seed seed, uint use) { return unit_of(seed_bits(seed, use)); }

// The five cubes along an axis from near to far, and the squares of how far they are.
static inline void cubes_from(float share, float* far, int* step) {
    const int side = share < 0.5f ? -1 : 1;
    const float near = share < 0.5f ? share : 1.0f - share;
    for (int i = 0; i < 5; ++i) {
        const int ring = (i + 1) / 2;
        const int towards = i % 2 == 1;
        step[i] = towards ? ring * side : -ring * side;
        far[i] = i == 0 ? 0.0f : square((towards ? near : 1.0f - near) + (float)(ring - 1));
    }
}

static inline float far_square(Seed seed) { return inner(seed.away, seed.away); }

static inline Seed seed_in(int x, int y, int z, uint bits, float jitter) {
    const float low = 0.5f - 0.5f * jitter, unit = jitter * (1.0f / 2048.0f);
    Seed seed;
    seed.bits = bits;
    seed.away = triple((float)x + low + unit * ((float)(bits >> 21) + 0.5f),
                       (float)y + low + unit * ((float)((bits >> 10) & 2047U) + 0.5f),
                       (float)z + low + 2.0f * unit * ((float)(bits & 1023U) + 0.5f));
    return seed;
}

// Finds the seeds within `reach`, and not farther than the nearest by 2 `margin`, or, if that is
// more, by `soft` in squares. A border is nearer than half the difference of the distances of two
// seeds, so that all cells that come within `margin` are among them.
static inline void gather_seeds(CellView view, float jitter, float reach, float margin, float soft,
                                Seeds* seeds) {
    const Triple cube = triple(floor(view.place.x), floor(view.place.y), floor(view.place.z));
    const Triple in = minus(view.place, cube);
    float x_far[5], y_far[5], z_far[5];
    int x_step[5], y_step[5], z_step[5];
    cubes_from(in.x, x_far, x_step);
    cubes_from(in.y, y_far, y_step);
    cubes_from(in.z, z_far, z_step);
    float limit = square(reach), nearest = 1e30f;
    int count = 0;
    for (int k = 0; k < 5 && z_far[k] < limit; ++k)
        for (int j = 0; j < 5 && z_far[k] + y_far[j] < limit; ++j) {
            const uint row = scramble(view.key + (uint)((int)cube.y + y_step[j]) * 0x9e3779b9U +
                                      (uint)((int)cube.z + z_step[k]) * 0x85ebca6bU);
            const uint other = row * 0x2c1b3c6dU;
            for (int i = 0; i < 5 && z_far[k] + y_far[j] + x_far[i] < limit && count < CELLS_MOST;
                 ++i) {
                Seed seed = seed_in(x_step[i], y_step[j], z_step[k],
                                    node_bits(row, other, (uint)((int)cube.x + x_step[i])), jitter);
                seed.away = minus(seed.away, in);
                const float far = far_square(seed);
                const int counts = far < limit ? 1 : 0;
                // Written first and counted then: no processor foresees which seeds count.
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
    // The limit was wider before the nearest was found.
    seeds->count = count > 0 ? 1 : 0;
    for (int i = 1; i < count; ++i) {
        const Seed seed = seeds->seed[i];
        seeds->seed[seeds->count] = seed;
        seeds->count += far_square(seed) < limit ? 1 : 0;
    }
}

// Deviation of the filter along a vector, times the vector's length.
static inline float deviation_along(CellView view, Triple v) {
    return sqrt((square(inner(v, view.across)) + square(inner(v, view.along))) * (1.0f / 12.0f) +
                v.x * v.x * view.variance.x + v.y * v.y * view.variance.y +
                v.z * v.z * view.variance.z);
}

// A filter is a box, which sees no border beyond so many deviations; nor are seeds looked for that
// are farther than the nearest by two of the largest margin.
#define CELLS_DEVIATIONS 1.9f
#define CELLS_MARGIN 0.45f

// It is more than 0 for a point too: what no border was found for lies well beyond the gap along
// borders, not on its edge.
static inline float border_margin(CellView view) {
    return limited(CELLS_DEVIATIONS * 0.28867513f * view.width, 1e-5f, CELLS_MARGIN);
}

// Beyond some cells' width a filter sees nothing but means: 0 to 1.
static inline float cells_blur(float width) { return smooth(1.2f, 2.4f, width); }

// How much larger the second cell's part of the filter is than the first's, from the plane between
// them; for one whose seed is farther away. The odds that z deviations of a box leave lie between
// those of one that is parallel to the plane and those of one that stands on a corner, and end at 0
// where those end.
static inline float cell_odds(CellView view, Seed first, Seed second) {
    const float z = 0.5f * (far_square(second) - far_square(first)) /
                    (deviation_along(view, minus(second.away, first.away)) + 1e-12f);
    return z < CELLS_DEVIATIONS ? fmax(exp(-z * (1.25f + 0.1f * z * z)) - 0.0469f, 0.0f) * 1.0492f
                                : 0.0f;
}

// How much of the filter each cell has: the odds of all against the nearest, put together. Where
// the second is almost as near, those against it count as much, so that nothing jumps as the two
// change places.
static inline void cell_shares(CellView view, Seeds* seeds) {
    const Seed first = seeds->seed[0];
    const float away = sqrt(far_square(first));
    float sum = 1.0f;
    seeds->share[0] = 1.0f;
    int kept = 1, second = 0;
    for (int i = 1; i < seeds->count; ++i) {
        const Seed seed = seeds->seed[i];
        // Where the search ends a share does too.
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
            seeds->share[i] = mixed(seeds->share[i] / sum, odds / rival_sum, tied);
        }
        return;
    }
    for (int i = 0; i < kept; ++i)
        seeds->share[i] /= sum;
}

// The plane between the nearest seed's cell and another's: how far it is, and the unit vector away
// from it.
static inline float plane_distance(const Seeds* seeds, int i, Triple* inwards) {
    const Triple between = minus(seeds->seed[i].away, seeds->seed[0].away);
    const float span = length_of(between) + 1e-12f;
    *inwards = scaled(between, -1.0f / span);
    return 0.5f * (far_square(seeds->seed[i]) - far_square(seeds->seed[0])) / span;
}

// Distance to the nearest border of the nearest seed's cell, if all seeds within a margin of that
// distance are known; `none` where there is no other.
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
