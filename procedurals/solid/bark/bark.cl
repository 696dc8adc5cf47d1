// SPDX-License-Identifier: GPL-3.0-or-later
// Bark: ridges and plates between fissures along the trunk, overlapping flakes, and bands, pores
// and scars across the trunk, warped by the fractal field. Needs creases.cl, beds.cl, spots.cl and
// hewn.cl.

#define BARK_MAX_FISSURES 3

typedef struct {
    Warp warp;
    Triple axis;
    float start;     // [m]
    Triple color[2]; // flakes have colours between these two
    Triple fissure;
    Creases fissures[BARK_MAX_FISSURES];
    float depth[BARK_MAX_FISSURES]; // [m]
    float dark[BARK_MAX_FISSURES];  // share of the fissure colour in a fissure
    Creases flakes;
    float flake_height; // of the highest above the lowest [m]
    float flake_edge;   // share of the fissure colour along their edges
    Beds bands;         // across the trunk
    Triple band;
    float band_share;
    Spots pores;
    Spots scars;
    Triple pore;
    Triple scar;
    float pore_height; // [m]; negative: recessed
    float scar_height;
    Triple lichen;
    float lichen_share;
    float fibre; // change of brightness per unit of the stretched field of `hewn`
    Hewn hewn;
    float roughness;
    int filtered;
} Bark;

static inline void add_fissures(global const Bark* bark, WarpedPoint at, Seeds* seeds,
                                SolidSample* sample, float* lost) {
    float clear = 1.0f;
    for (int i = 0; i < BARK_MAX_FISSURES; ++i) {
        if (bark->depth[i] == 0.0f)
            continue;
        global const Cells* cells = &bark->fissures[i].cells;
        const Crease crease =
            crease_at(cell_view(cells, at), cells->jitter, bark->fissures[i].softness, seeds);
        sample->height -= bark->depth[i] * crease.value;
        sample->slope = minus(
            sample->slope, scaled(gradient_before_warp(at, gradient_of_cells(cells, crease.slope)),
                                  bark->depth[i]));
        *lost += square(bark->depth[i]) * crease.lost * cells->squares.x;
        clear *= 1.0f - bark->dark[i] * fmin(crease.value, 1.0f);
    }
    sample->value *= clear;
    sample->color = lerp3(bark->fissure, sample->color, clear);
}

static inline void add_flakes(global const Bark* bark, WarpedPoint at, Seeds* seeds,
                              SolidSample* sample, float* lost) {
    global const Cells* cells = &bark->flakes.cells;
    const Crease flake =
        crease_at(cell_view(cells, at), cells->jitter, bark->flakes.softness, seeds);
    sample->color = lerp3(bark->color[0], bark->color[1], flake.level);
    sample->height = bark->flake_height * flake.level;
    sample->slope = scaled(gradient_before_warp(at, gradient_of_cells(cells, flake.level_slope)),
                           bark->flake_height);
    // Relative to a crease: the levels on both sides of a border differ by 1/6 in mean square, and
    // a crease has two slopes.
    *lost = square(bark->flake_height) * flake.lost * cells->squares.x * 0.05f;
    sample->value = 1.0f - bark->flake_edge * fmin(flake.value, 1.0f);
    sample->color = lerp3(bark->fissure, sample->color, sample->value);
}

static inline void add_marks(global const Spots* spots, WarpedPoint at, Triple color, float height,
                             Seeds* seeds, SolidSample* sample) {
    const SpotSample spot = spots_at(spots, at, seeds);
    sample->color = lerp3(sample->color, color, spot.share);
    sample->value *= 1.0f - spot.share;
    sample->height += height * spot.share;
    sample->slope = plus(sample->slope, scaled(spot.slope, height));
}

static inline SolidSample bark_part(Field field, global const Bark* bark, Triple position,
                                    Triple across, Triple along, float random) {
    const WarpedPoint at = warp_point(field, &bark->warp, position, across, along, random);
    SolidSample sample = no_sample();
    Seeds seeds;
    float lost;
    add_flakes(bark, at, &seeds, &sample, &lost);
    if (bark->bands.share > 0.0f) {
        const float sigma = sqrt(filter_variance(bark->axis, at.across, at.along) + at.variance);
        const BedSample band =
            beds_at(&bark->bands, 0U, dot3(bark->axis, at.position) - bark->start, sigma);
        sample.color = lerp3(sample.color, bark->band, bark->band_share * band.value);
    }
    if (bark->lichen_share > 0.0f)
        sample.color =
            lerp3(sample.color, bark->lichen, bark->lichen_share * smooth(-0.2f, 1.6f, at.field));
    add_marks(&bark->pores, at, bark->pore, bark->pore_height, &seeds, &sample);
    add_fissures(bark, at, &seeds, &sample, &lost);
    add_marks(&bark->scars, at, bark->scar, bark->scar_height, &seeds, &sample);
    sample.roughness = roughened(bark->roughness, lost);
    const float before = sample.height;
    hew(field, &bark->hewn, position, across, along, random, &sample);
    if (bark->fibre > 0.0f && bark->hewn.height > 0.0f)
        sample.color =
            scaled(sample.color,
                   fmax(1.0f + bark->fibre * (sample.height - before) / bark->hewn.height, 0.0f));
    return sample;
}

static inline SolidSample bark_at(Field field, global const Bark* bark, SolidPoint point) {
    MEAN_OF_PARTS(bark_part, field, bark, point)
}
