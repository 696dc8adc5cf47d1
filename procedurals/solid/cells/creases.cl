// SPDX-License-Identifier: GPL-3.0-or-later
// Soft creases between cells. Each seed has a share of a place proportional to
// exp(-distance^2 / softness). The sum of the squared shares is 1 inside a cell and 1/2 on a border
// between two, so its difference from 1 is a smooth furrow along the borders, deeper where several
// cells meet. Needs cells.cl.

typedef struct {
    Cells cells;
    float softness; // of a crease [square of a cell]: 0.02 gives cracks, 0.3 hills
} Creases;

// Filtered creases: 0 far from borders, 1 on a border, up to 1.5 where four cells meet.
typedef struct {
    float value;
    Triple slope;       // gradient in the grid's coordinates
    float lost;         // mean squared slope that the filter removes
    float level;        // a random number of each cell in [0, 1), with equally soft transitions
    Triple level_slope; // its gradient
} Crease;

// The means over space of the value and of its squared slope: fits within 2% of measurements for
// softnesses up to 0.35 and any jitter.
static inline float crease_mean(float softness) {
    const float t = softness;
    return 2.0f - 2.0f * exp(-t * (3.25f + t * (3.0f - 3.5f * t)));
}
static inline float crease_mean_slope(float softness) {
    return 3.2f / softness * exp(-softness * (2.2f + 13.0f * softness));
}

static inline Crease crease_at(CellView view, float jitter, float softness, Seeds* seeds) {
    // The profile across a border is the derivative of a logistic function. Filtering adds the
    // filter's variance to its own, which is modelled by a larger softness, and keeps the mean.
    const float variance =
        (dot3(view.across, view.across) + dot3(view.along, view.along)) * (1.0f / 24.0f) +
        (view.variance.x + view.variance.y + view.variance.z) * (1.0f / 3.0f);
    const float wide = sqrt(square(softness) + variance);
    const float kept = softness / wide;
    Crease crease;
    crease.value = crease_mean(softness);
    crease.slope = triple(0.0f, 0.0f, 0.0f);
    crease.lost = crease_mean_slope(softness);
    crease.level = 0.5f;
    crease.level_slope = crease.slope;
    const float blur = smooth(0.25f, 0.5f, wide);
    if (blur >= 1.0f)
        return crease;
    gather_seeds(view, jitter, CELLS_REACH, 0.0f, 9.2f * wide, seeds);
    const float nearest = far_square(seeds->seed[0]);
    float sum = 0.0f;
    for (int i = 0; i < seeds->count; ++i) {
        seeds->share[i] = exp((nearest - far_square(seeds->seed[i])) / wide);
        sum += seeds->share[i];
    }
    float squares = 0.0f, level = 0.0f;
    Triple mean = crease.slope, weighted = crease.slope, levelled = crease.slope;
    for (int i = 0; i < seeds->count; ++i) {
        const Triple away = seeds->seed[i].away;
        const float share = seeds->share[i] / sum,
                    height = share * seed_uniform(seeds->seed[i], 3U);
        squares += square(share);
        level += height;
        mean = plus(mean, scaled(away, share));
        weighted = plus(weighted, scaled(away, square(share)));
        levelled = plus(levelled, scaled(away, height));
    }
    const float scale = kept * (1.0f - blur);
    crease.value += scale * (2.0f * (1.0f - squares) - crease_mean(wide));
    crease.slope = scaled(minus(weighted, scaled(mean, squares)), -8.0f / wide * scale);
    crease.level = lerp(level, 0.5f, blur);
    crease.level_slope = scaled(minus(levelled, scaled(mean, level)), 2.0f / wide * (1.0f - blur));
    crease.lost -= square(scale) * crease_mean_slope(wide);
    return crease;
}
