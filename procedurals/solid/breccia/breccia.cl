// SPDX-License-Identifier: GPL-3.0-or-later
// Breccia: broken stones of several sizes in a cement with bands around them, and veins where it
// was fractured again. Needs grains.cl and hewn.cl.

#define BRECCIA_MAX_VEINS 2

// Veins along the borders of otherwise invisible cells.
typedef struct {
    Cells cells;
    float half_width; // in cells
    float share;      // of the vein colour in a vein
    float mean;       // share of space covered by veins: measured
    Triple color;
} CellVeins;

typedef struct {
    Warp warp;
    Grains grains;
    Triple cement;
    Triple band;     // colour of the bands around the largest stones
    float band_rate; // bands per cell length
    float bands;     // share of the band colour; 0: no bands
    float cloudy;    // change of the cement's brightness per unit of D
    CellVeins veins[BRECCIA_MAX_VEINS];
    float relief; // height of the stones above the cement [m]
    float edge;   // standard deviation of the position of their edges, in cells
    Hewn hewn;
    float roughness;
    float cement_roughness;
    int filtered;
} Breccia;

static inline float veins_share(global const CellVeins* veins, WarpedPoint at, Seeds* seeds) {
    const CellView view = cell_view(&veins->cells, at);
    if (cells_blur(view.width) >= 1.0f)
        return veins->mean;
    const float margin = veins->half_width + border_margin(view);
    gather_seeds(view, veins->cells.jitter, CELLS_REACH, margin, 0.0f, seeds);
    Triple inwards;
    const float border = border_distance(seeds, 1e3f, &inwards);
    const float sigma = deviation_along(view, inwards) + 1e-9f;
    const float share = normal_cdf((veins->half_width - border) / sigma) -
                        normal_cdf((-veins->half_width - border) / sigma);
    // A wide filter covers more borders than the nearest one.
    return lerp(share, veins->mean, smooth(0.12f, 0.5f, 0.28867513f * view.width));
}

static inline SolidSample breccia_part(Field field, global const Breccia* breccia, Triple position,
                                       Triple across, Triple along, float random) {
    const WarpedPoint at = warp_point(field, &breccia->warp, position, across, along, random);
    global const GrainLayer* first = &breccia->grains.layer[0];
    // The largest stones, then the smaller stones and the cement between them.
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
        cement = lerp3(cement, breccia->band, breccia->bands * (0.5f + 0.5f * wave));
    }
    sample.color = plus(sample.color, scaled(cement, 1.0f - covered));
    sample.roughness += breccia->cement_roughness * (1.0f - covered);
    sample.color = plus(stones.color, scaled(sample.color, 1.0f - stones.share));
    sample.roughness = stones.roughness + sample.roughness * (1.0f - stones.share);
    sample.value = stones.share + covered * (1.0f - stones.share);
    for (int i = 0; i < BRECCIA_MAX_VEINS; ++i) {
        if (!(breccia->veins[i].share > 0.0f))
            continue;
        const float share = breccia->veins[i].share * veins_share(&breccia->veins[i], at, &seeds);
        sample.color = lerp3(sample.color, breccia->veins[i].color, share);
        sample.value *= 1.0f - share;
    }
    if (breccia->relief > 0.0f) {
        const float sigma =
            sqrt(square(breccia->edge) + square(deviation_along(view, stones.inwards)));
        const float z = (stones.border - gap) / sigma;
        const float blur = cells_blur(view.width);
        sample.height = breccia->relief * lerp(normal_cdf(z), first->whole, blur);
        const Triple inwards =
            gradient_before_warp(at, gradient_of_cells(&first->cells, stones.inwards));
        sample.slope =
            scaled(minus(inwards, scaled(at.field_slope, first->gap * first->gap_by_field)),
                   breccia->relief * (1.0f - blur) * normal_pdf(z) / sigma);
    }
    hew(field, &breccia->hewn, position, across, along, random, &sample);
    return sample;
}

static inline SolidSample breccia_at(Field field, global const Breccia* breccia, SolidPoint point) {
    MEAN_OF_PARTS(breccia_part, field, breccia, point)
}
