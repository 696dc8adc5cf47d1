// SPDX-License-Identifier: GPL-3.0-or-later
// Sedimentary and metamorphic stone: sequences of beds, warped by the fractal field, with grains,
// shells and holes. Needs beds.cl, grains.cl, spots.cl and hewn.cl.

#define STONE_MAX_BEDS 3
#define STONE_MAX_HOLES 2

typedef struct {
    Warp warp;
    Triple axis; // normal of the beds
    Triple side; // a direction in their plane
    float start; // [m]
    Triple color;
    Beds beds[STONE_MAX_BEDS];
    Triple bed_color[STONE_MAX_BEDS];
    float bed_share[STONE_MAX_BEDS];  // of the bed colour in a full bed
    float bed_height[STONE_MAX_BEDS]; // of a full bed [m]
    float cross;    // slope of the finer beds within those of the first kind: cross-bedding
    Cells speckle;  // sand grains
    float speckled; // variation of brightness between sand grains: the factor is 1 +- this
    float cloudy;   // change of brightness per unit of D
    Grains grains;  // shells and pebbles
    Spots holes[STONE_MAX_HOLES];
    float hole_beds;  // 1: holes are only in full beds of the first kind
    float hole_depth; // [m]
    float hole_share; // of the hole colour in a hole
    Triple hole;
    Hewn hewn;
    float roughness;
    int filtered;
} Stone;

// The finer beds of a set (a bed of the first kind), inclined by cross-bedding.
static inline BedSample set_beds(global const Stone* stone, int i, int set, Triple place,
                                 Triple across, Triple along, float variance, Triple* direction) {
    const uint bits = bed_bits(stone->beds[0].key ^ 0x51ed270bU, set);
    const float slant = stone->cross * (uniform_of(bits) - 0.35f);
    *direction = plus(stone->axis, scaled(stone->side, slant));
    const float sigma = sqrt(filter_variance(*direction, across, along) + variance);
    return beds_at(&stone->beds[i], bits, dot3(*direction, place) - stone->start, sigma);
}

static inline void add_beds(global const Stone* stone, WarpedPoint at, SolidSample* sample) {
    const float z = dot3(stone->axis, at.position) - stone->start;
    const float sigma = sqrt(filter_variance(stone->axis, at.across, at.along) + at.variance);
    // The set that contains the point, and the share of the filter in the adjacent set.
    int set = 0, other = 0;
    float other_share = 0.0f;
    if (stone->cross > 0.0f) {
        const uint key = stone->beds[0].key;
        const float p = beds_place(&stone->beds[0], z);
        const float wide = sigma * stone->beds[0].rate + 1e-9f;
        set = bed_of(key, p);
        const float down = p - bed_floor(key, set), up = bed_floor(key, set + 1) - p;
        other = down < up ? set - 1 : set + 1;
        other_share = normal_cdf(-fmin(down, up) / wide);
    }
    for (int i = 0; i < STONE_MAX_BEDS; ++i) {
        if (!(stone->beds[i].share > 0.0f))
            continue;
        BedSample found;
        Triple slope;
        if (i == 0 || !(stone->cross > 0.0f)) {
            found = beds_at(&stone->beds[i], 0U, z, sigma);
            slope = scaled(stone->axis, found.slope);
        } else {
            Triple direction;
            found =
                set_beds(stone, i, set, at.position, at.across, at.along, at.variance, &direction);
            slope = scaled(direction, found.slope);
            if (other_share > 0.01f) {
                const BedSample beyond = set_beds(stone, i, other, at.position, at.across, at.along,
                                                  at.variance, &direction);
                found.value = lerp(found.value, beyond.value, other_share);
                slope = plus(scaled(slope, 1.0f - other_share),
                             scaled(direction, beyond.slope * other_share));
            }
        }
        sample->color =
            lerp3(sample->color, stone->bed_color[i], found.value * stone->bed_share[i]);
        sample->value = 1.0f - (1.0f - sample->value) * (1.0f - found.value * stone->bed_share[i]);
        sample->height += stone->bed_height[i] * found.value;
        sample->slope =
            plus(sample->slope, scaled(gradient_before_warp(at, slope), stone->bed_height[i]));
    }
}

static inline float speckle_at(global const Stone* stone, WarpedPoint at, Seeds* seeds) {
    if (!(stone->speckled > 0.0f))
        return 1.0f;
    const CellView view = cell_view(&stone->speckle, at);
    const float blur = cells_blur(view.width);
    if (blur >= 1.0f)
        return 1.0f;
    gather_seeds(view, stone->speckle.jitter, CELLS_REACH, border_margin(view), 0.0f, seeds);
    cell_shares(view, seeds);
    float sum = 0.0f;
    for (int i = 0; i < seeds->count; ++i)
        sum += seeds->share[i] * (2.0f * seed_uniform(seeds->seed[i], 3U) - 1.0f);
    return 1.0f + stone->speckled * (1.0f - blur) * sum;
}

// Holes, which may be limited to full beds of the first kind.
static inline SpotSample holes_at(global const Stone* stone, global const Spots* holes,
                                  WarpedPoint at, Seeds* seeds) {
    SpotSample sum = no_spot();
    global const Cells* cells = &holes->cells;
    global const Beds* beds = &stone->beds[0];
    const CellView view = cell_view(cells, at);
    const float blur = cells_blur(view.width);
    if (blur < 1.0f) {
        const Triple normal = filter_normal(view);
        const float reach = spots_reach(holes, view);
        gather_seeds(view, cells->jitter, reach, CELLS_REACH, 0.0f, seeds);
        const float z = dot3(stone->axis, at.position) - stone->start;
        const Triple climb = triple(dot3(stone->axis, cells->rows[0]) / cells->squares.x,
                                    dot3(stone->axis, cells->rows[1]) / cells->squares.y,
                                    dot3(stone->axis, cells->rows[2]) / cells->squares.z);
        for (int i = 0; i < seeds->count; ++i) {
            const Seed seed = seeds->seed[i];
            const int bed = bed_of(beds->key, beds_place(beds, z + dot3(climb, seed.away)));
            const float full = bed_amount(beds->share, bed_bits(beds->key, bed)) > 0.0f;
            if (seed_uniform(seed, 4U) < holes->share * lerp(1.0f, full, stone->hole_beds))
                add_spot(&sum, ball_part(view, seed, spot_radius(holes, seed), holes->edge, reach,
                                         normal));
        }
    }
    sum.share = lerp(sum.share, holes->mean * lerp(1.0f, beds->share, stone->hole_beds), blur);
    sum.slope = gradient_before_warp(at, gradient_of_cells(cells, scaled(sum.slope, 1.0f - blur)));
    return sum;
}

static inline SolidSample stone_part(Field field, global const Stone* stone, Triple position,
                                     Triple across, Triple along, float random) {
    const WarpedPoint at = warp_point(field, &stone->warp, position, across, along, random);
    Seeds seeds;
    SolidSample sample = no_sample();
    sample.color = stone->color;
    add_beds(stone, at, &sample);
    sample.color = scaled(sample.color, speckle_at(stone, at, &seeds) *
                                            fmax(1.0f + stone->cloudy * at.field, 0.0f));
    sample.roughness = stone->roughness;
    if (stone->grains.layers > 0) {
        float covered;
        const SolidSample grains = all_grains(field, &stone->grains, 0, at, &seeds, &covered);
        sample.color = plus(scaled(sample.color, 1.0f - covered), grains.color);
        sample.roughness = sample.roughness * (1.0f - covered) + grains.roughness;
    }
    for (int i = 0; i < STONE_MAX_HOLES; ++i) {
        if (!(stone->holes[i].share > 0.0f))
            continue;
        const SpotSample hole = holes_at(stone, &stone->holes[i], at, &seeds);
        sample.color = lerp3(sample.color, stone->hole, stone->hole_share * hole.share);
        sample.height -= stone->hole_depth * hole.share;
        sample.slope = minus(sample.slope, scaled(hole.slope, stone->hole_depth));
    }
    hew(field, &stone->hewn, position, across, along, random, &sample);
    return sample;
}

static inline SolidSample stone_at(Field field, global const Stone* stone, SolidPoint point) {
    MEAN_OF_PARTS(stone_part, field, stone, point)
}
