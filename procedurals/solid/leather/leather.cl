// SPDX-License-Identifier: GPL-3.0-or-later
// Leather grain: hills between soft creases, on several scales, and pores. The fractal field warps
// the creases and varies the colour. Needs creases.cl, spots.cl and hewn.cl.

#define LEATHER_MAX_CREASES 3

typedef struct {
    Warp warp;
    Creases creases[LEATHER_MAX_CREASES];
    float depth[LEATHER_MAX_CREASES]; // of a crease between two hills [m]
    float dye[LEATHER_MAX_CREASES];   // share of the crease colour in a crease
    Spots pores;
    float pore_depth; // [m]; negative: knobs
    float pore_dye;   // share of the pore colour in a pore
    Hewn hewn;
    Triple color;
    Triple crease;
    Triple pore;
    float stain; // change of brightness per unit of D
    float roughness;
    float crease_roughness;
    int filtered;
} Leather;

static inline SolidSample leather_part(Field field, global const Leather* leather, Triple position,
                                       Triple across, Triple along, float random) {
    const WarpedPoint at = warp_point(field, &leather->warp, position, across, along, random);
    Seeds seeds;
    SolidSample sample = no_sample();
    float lost = 0.0f, clear = 1.0f;
    for (int i = 0; i < LEATHER_MAX_CREASES; ++i) {
        if (leather->depth[i] == 0.0f)
            continue;
        global const Cells* cells = &leather->creases[i].cells;
        const Crease crease =
            crease_at(cell_view(cells, at), cells->jitter, leather->creases[i].softness, &seeds);
        sample.height -= leather->depth[i] * crease.value;
        sample.slope = minus(
            sample.slope, scaled(gradient_before_warp(at, gradient_of_cells(cells, crease.slope)),
                                 leather->depth[i]));
        lost += square(leather->depth[i]) * crease.lost * cells->squares.x;
        clear *= fmax(1.0f - leather->dye[i] * fmax(crease.value * (1.0f / 1.5f), 0.0f), 0.0f);
    }
    const SpotSample pore = spots_at(&leather->pores, at, &seeds);
    sample.height -= leather->pore_depth * pore.share;
    sample.slope = minus(sample.slope, scaled(pore.slope, leather->pore_depth));
    sample.value = clear;
    sample.color = scaled(lerp3(lerp3(leather->crease, leather->color, clear), leather->pore,
                                leather->pore_dye * pore.share),
                          fmax(1.0f + leather->stain * at.field, 0.0f));
    sample.roughness = roughened(lerp(leather->crease_roughness, leather->roughness, clear), lost);
    hew(field, &leather->hewn, position, across, along, random, &sample);
    return sample;
}

static inline SolidSample leather_at(Field field, global const Leather* leather, SolidPoint point) {
    MEAN_OF_PARTS(leather_part, field, leather, point)
}
