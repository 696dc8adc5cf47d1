// SPDX-License-Identifier: GPL-3.0-or-later
// Bark: ridges and plates between fissures along the trunk, flakes one over another, bands, pores
// and scars across it, bent by the fractal field. Needs creases.cl, beds.cl, spots.cl and hewn.cl.

#define BARK_MOST_FISSURES 3

typedef struct {
    Push push;
    Triple axis;
    float start;     // [m]
    Triple color[2]; // of flakes, which lie between them
    Triple fissure;
    Creases fissures[BARK_MOST_FISSURES];
    float depth[BARK_MOST_FISSURES]; // [m]
    float dark[BARK_MOST_FISSURES];  // share of the fissure's colour in one
    Creases flakes;
    float flake_height; // of the highest above the lowest [m]
    float flake_edge;   // share of the fissure's colour along their edges
    Beds bands;         // across the trunk
    Triple band;
    float band_share;
    Spots pores;
    Spots scars;
    Triple pore;
    Triple scar;
    float pore_height; // [m]; below 0: they lie deeper
    float scar_height;
    Triple lichen;
    float lichen_share;
    float fibre; // of brightness by D drawn out along the trunk
    Hewn hewn;
    float roughness;
    int filtered;
} Bark;

static inline void add_fissures(global const Bark* bark, Pushed at, Seeds* seeds,
                                SolidSample* sample, float* lost) {
    float clear = 1.0f;
    for (int i = 0; i < BARK_MOST_FISSURES; ++i) {
        if (bark->depth[i] == 0.0f)
            continue;
        global const Cells* cells = &bark->fissures[i].cells;
        const Crease crease =
            crease_at(cell_view(cells, at), cells->jitter, bark->fissures[i].softness, seeds);
        sample->height -= bark->depth[i] * crease.value;
        sample->slope =
            minus(sample->slope, scaled(gradient_before(at, gradient_of_cells(cells, crease.slope)),
                                        bark->depth[i]));
        *lost += square(bark->depth[i]) * crease.lost * cells->squares.x;
        clear *= 1.0f - bark->dark[i] * fmin(crease.value, 1.0f);
    }
    sample->value *= clear;
    sample->color = mixed3(bark->fissure, sample->color, clear);
}

static inline void add_flakes(global const Bark* bark, Pushed at, Seeds* seeds, SolidSample* sample,
                              float* lost) {
    global const Cells* cells = &bark->flakes.cells;
    const Crease flake =
        crease_at(cell_view(cells, at), cells->jitter, bark->flakes.softness, seeds);
    sample->color = mixed3(bark->color[0], bark->color[1], flake.level);
    sample->height = bark->flake_height * flake.level;
    sample->slope = scaled(gradient_before(at, gradient_of_cells(cells, flake.level_slope)),
                           bark->flake_height);
    // Across a border levels differ by a sixth in squares; a crease goes up and down again.
    *lost = square(bark->flake_height) * flake.lost * cells->squares.x * 0.05f;
    sample->value = 1.0f - bark->flake_edge * fmin(flake.value, 1.0f);
    sample->color = mixed3(bark->fissure, sample->color, sample->value);
}

static inline void add_marks(global const Spots* spots, Pushed at, Triple color, float height,
                             Seeds* seeds, SolidSample* sample) {
    const Spotted spot = spots_at(spots, at, seeds);
    sample->color = mixed3(sample->color, color, spot.share);
    sample->value *= 1.0f - spot.share;
    sample->height += height * spot.share;
    sample->slope = plus(sample->slope, scaled(spot.slope, height));
}

static inline SolidSample bark_part(Field field, global const Bark* bark, Triple position,
                                    Triple across, Triple along, float random) {
    const Pushed at = pushed(field, &bark->push, position, across, along, random);
    SolidSample sample = no_sample();
    Seeds seeds;
    float lost;
    add_flakes(bark, at, &seeds, &sample, &lost);
    if (bark->bands.share > 0.0f) {
        const float sigma = sqrt(filter_variance(bark->axis, at.across, at.along) + at.variance);
        const Bedded band =
            beds_at(&bark->bands, 0U, inner(bark->axis, at.position) - bark->start, sigma);
        sample.color = mixed3(sample.color, bark->band, bark->band_share * band.value);
    }
    if (bark->lichen_share > 0.0f)
        sample.color =
            mixed3(sample.color, bark->lichen, bark->lichen_share * smooth(-0.2f, 1.6f, at.field));
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
