// SPDX-License-Identifier: GPL-3.0-or-later
// Leather's grain: hills between soft creases, large ones with small ones on them, and pores; the
// fractal field bends the creases and stains the skin. Needs creases.cl, spots.cl and hewn.cl.

#define LEATHER_MOST_CREASES 3

typedef struct {
    Push push;
    Creases creases[LEATHER_MOST_CREASES];
    float depth[LEATHER_MOST_CREASES]; // of a crease between two hills [m]
    float dye[LEATHER_MOST_CREASES];   // share of the crease's colour there
    Spots pores;
    float pore_depth; // [m]; below 0: knobs
    float pore_dye;   // share of their colour
    Hewn hewn;
    Triple color;
    Triple crease;
    Triple pore;
    float stain; // of brightness by D
    float roughness;
    float crease_roughness;
    int filtered;
} Leather;

static inline SolidSample leather_part(Field field, global const Leather* leather, Triple position,
                                       Triple across, Triple along, float random) {
    const Pushed at = pushed(field, &leather->push, position, across, along, random);
    Seeds seeds;
    SolidSample sample = no_sample();
    float lost = 0.0f, clear = 1.0f;
    for (int i = 0; i < LEATHER_MOST_CREASES; ++i) {
        if (leather->depth[i] == 0.0f)
            continue;
        global const Cells* cells = &leather->creases[i].cells;
        const Crease crease =
            crease_at(cell_view(cells, at), cells->jitter, leather->creases[i].softness, &seeds);
        sample.height -= leather->depth[i] * crease.value;
        sample.slope =
            minus(sample.slope, scaled(gradient_before(at, gradient_of_cells(cells, crease.slope)),
                                       leather->depth[i]));
        lost += square(leather->depth[i]) * crease.lost * cells->squares.x;
        clear *= fmax(1.0f - leather->dye[i] * fmax(crease.value * (1.0f / 1.5f), 0.0f), 0.0f);
    }
    const Spotted pore = spots_at(&leather->pores, at, &seeds);
    sample.height -= leather->pore_depth * pore.share;
    sample.slope = minus(sample.slope, scaled(pore.slope, leather->pore_depth));
    sample.value = clear;
    sample.color = scaled(mixed3(mixed3(leather->crease, leather->color, clear), leather->pore,
                                 leather->pore_dye * pore.share),
                          fmax(1.0f + leather->stain * at.field, 0.0f));
    sample.roughness = roughened(mixed(leather->crease_roughness, leather->roughness, clear), lost);
    hew(field, &leather->hewn, position, across, along, random, &sample);
    return sample;
}

static inline SolidSample leather_at(Field field, global const Leather* leather, SolidPoint point) {
    MEAN_OF_PARTS(leather_part, field, leather, point)
}
