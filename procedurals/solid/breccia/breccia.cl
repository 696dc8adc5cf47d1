// SPDX-License-Identifier: GPL-3.0-or-later
// Breccia: broken stones of several sizes in a cement that is banded around them, and veins where
// it broke again. Needs grains.cl and hewn.cl.

#define BRECCIA_MOST_VEINS 2

// Veins along the borders of cells that have nothing else to show.
typedef struct {
    Cells cells;
    float half_width; // in cells
    float share;      // of the colour in a vein
    float mean;       // of space: measured
    Triple color;
} CellVeins;

typedef struct {
    Push push;
    Grains grains;
    Triple cement;
    Triple band;     // colour of the bands about the largest stones
    float band_rate; // of them in a cell's length
    float bands;     // share of the colour; 0: none
    float cloudy;    // of the cement's brightness by D
    CellVeins veins[BRECCIA_MOST_VEINS];
    float relief; // the stones stand out so far [m]
    float edge;   // deviation of the place of their edges, in cells
    Hewn hewn;
    float roughness;
    float cement_roughness;
    int filtered;
} Breccia;

static inline float veins_share(global const CellVeins* veins, Pushed at, Seeds* seeds) {
    const CellView view = cell_view(&veins->cells, at);
    if (cells_blur(view.width) >= 1.0f)
        return veins->mean;
    const float margin = veins->half_width + border_margin(view);
    gather_seeds(view, veins->cells.jitter, CELLS_REACH, margin, 0.0f, seeds);
    Triple inwards;
    const float border = border_distance(seeds, 1e3f, &inwards);
    const float sigma = deviation_along(view, inwards) + 1e-9f;
    const float share = normal_share((veins->half_width - border) / sigma) -
                        normal_share((-veins->half_width - border) / sigma);
    // It sees more borders than the nearest when it is wide.
    return mixed(share, veins->mean, smooth(0.12f, 0.5f, 0.28867513f * view.width));
}

static inline SolidSample breccia_part(Field field, global const Breccia* breccia, Triple position,
                                       Triple across, Triple along, float random) {
    const Pushed at = pushed(field, &breccia->push, position, across, along, random);
    global const GrainLayer* first = &breccia->grains.layer[0];
    // The largest stones, and what is between them.
    const CellView view = cell_view(&first->cells, at);
    const float gap = grain_gap(first, at);
    const float asked = fmax(gap, 0.0f) + 4.0f * breccia->edge;
    Seeds seeds;
    const GrainShare stones = grain_layer(field, &breccia->grains, first, at, asked, &seeds);
    float covered;
    SolidSample sample = all_grains(field, &breccia->grains, 1, at, &seeds, &covered);
    Triple cement = scaled(breccia->cement, fmax(1.0f + breccia->cloudy * at.field, 0.0f));
    if (breccia->bands > 0.0f) {
        const float k = 6.2831853f * breccia->band_rate;
        const float sigma = k * deviation_along(view, stones.inwards);
        const float wave =
            cos(k * stones.border) * exp(-0.5f * square(sigma)) * (1.0f - cells_blur(view.width));
        cement = mixed3(cement, breccia->band, breccia->bands * (0.5f + 0.5f * wave));
    }
    sample.color = plus(sample.color, scaled(cement, 1.0f - covered));
    sample.roughness += breccia->cement_roughness * (1.0f - covered);
    sample.color = plus(stones.color, scaled(sample.color, 1.0f - stones.share));
    sample.roughness = stones.roughness + sample.roughness * (1.0f - stones.share);
    sample.value = stones.share + covered * (1.0f - stones.share);
    for (int i = 0; i < BRECCIA_MOST_VEINS; ++i) {
        if (!(breccia->veins[i].share > 0.0f))
            continue;
        const float share = breccia->veins[i].share * veins_share(&breccia->veins[i], at, &seeds);
        sample.color = mixed3(sample.color, breccia->veins[i].color, share);
        sample.value *= 1.0f - share;
    }
    if (breccia->relief > 0.0f) {
        const float sigma =
            sqrt(square(breccia->edge) + square(deviation_along(view, stones.inwards)));
        const float z = (stones.border - gap) / sigma;
        const float blur = cells_blur(view.width);
        sample.height = breccia->relief * mixed(normal_share(z), first->whole, blur);
        const Triple inwards =
            gradient_before(at, gradient_of_cells(&first->cells, stones.inwards));
        sample.slope =
            scaled(minus(inwards, scaled(at.field_slope, first->gap * first->gap_by_field)),
                   breccia->relief * (1.0f - blur) * normal_density(z) / sigma);
    }
    hew(field, &breccia->hewn, position, across, along, random, &sample);
    return sample;
}

static inline SolidSample breccia_at(Field field, global const Breccia* breccia, SolidPoint point) {
    MEAN_OF_PARTS(breccia_part, field, breccia, point)
}
