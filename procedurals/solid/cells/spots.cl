// SPDX-License-Identifier: GPL-3.0-or-later
// Balls around some seeds: pores and knobs, flattened or elongated in stretched cells. Needs
// cells.cl.

typedef struct {
    Cells cells;
    float share;    // of seeds that have a spot
    float smallest; // radius, in cells
    float largest;
    float edge; // standard deviation of the blur of its edge; above 0 the edge has a slope
    float mean; // share of space covered by spots
} Spots;

// The share of the filter covered by spots, and its gradient.
typedef struct {
    float share;
    Triple slope; // in the grid's coordinates
} SpotSample;

// The share of the filter covered by one ball: for a small filter the normal distribution function
// of the distance from its edge; for a filter as wide as the ball, the overlap of a disk with a
// two-dimensional Gaussian. Fades to 0 at the limit of the search.
static inline SpotSample ball_part(CellView view, Seed seed, float radius, float edge, float reach,
                                   Triple normal) {
    SpotSample part;
    const float away = length_of(seed.away) + 1e-9f;
    const float blur = deviation_along(view, seed.away) / away;
    const float sigma = sqrt(square(blur) + square(edge)) + 1e-9f;
    const float z = (radius - away) / sigma;
    part.share = z > 4.0f ? 1.0f : z < -4.0f ? 0.0f : normal_cdf(z);
    part.slope = scaled(seed.away, fabs(z) < 4.0f ? normal_pdf(z) / (sigma * away) : 0.0f);
    const float wide = smooth(0.35f, 0.9f, 0.28867513f * view.width / radius);
    if (wide > 0.0f) {
        const float height = dot3(normal, seed.away);
        const float disk = fmax(square(radius) - square(height), 0.0f);
        const Triple flat = minus(seed.away, scaled(normal, height));
        const float u = dot3(flat, view.across), v = dot3(flat, view.along);
        const float uu = dot3(view.across, view.across) + 1e-12f;
        const float vv = dot3(view.along, view.along) + 1e-12f;
        const float spread_u = disk + uu * (1.0f / 6.0f), spread_v = disk + vv * (1.0f / 6.0f);
        const float soft =
            disk / sqrt(spread_u * spread_v + 1e-20f) *
            exp(-u * u / (uu * spread_u + 1e-20f) - v * v / (vv * spread_v + 1e-20f));
        part.share = lerp(part.share, soft, wide);
        part.slope = plus(scaled(part.slope, 1.0f - wide),
                          scaled(plus(scaled(view.across, u / (uu * spread_u + 1e-20f)),
                                      scaled(view.along, v / (vv * spread_v + 1e-20f))),
                                 2.0f * soft * wide));
    }
    const float kept = smooth(reach, 0.85f * reach, away);
    part.share *= kept;
    part.slope = scaled(part.slope, kept);
    return part;
}

static inline float spot_radius(global const Spots* spots, Seed seed) {
    return lerp(spots->smallest, spots->largest, square(seed_uniform(seed, 5U)));
}

static inline SpotSample no_spot(void) {
    SpotSample none;
    none.share = 0.0f;
    none.slope = triple(0.0f, 0.0f, 0.0f);
    return none;
}

// Adds the share of a ball, assuming that it is independent of the others.
static inline void add_spot(SpotSample* sum, SpotSample part) {
    sum->slope = plus(scaled(sum->slope, 1.0f - part.share), scaled(part.slope, 1.0f - sum->share));
    sum->share = 1.0f - (1.0f - sum->share) * (1.0f - part.share);
}

// The search radius for seeds.
static inline float spots_reach(global const Spots* spots, CellView view) {
    return fmin(1.2f * (spots->largest + 3.0f * spots->edge) + 2.5f * 0.28867513f * view.width,
                CELLS_REACH);
}

static inline Triple filter_normal(CellView view) {
    const Triple u = view.across, v = view.along;
    const Triple n = triple(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    return scaled(n, 1.0f / (length_of(n) + 1e-20f));
}

static inline SpotSample spots_at(global const Spots* spots, WarpedPoint at, Seeds* seeds) {
    SpotSample sum = no_spot();
    if (!(spots->share > 0.0f))
        return sum;
    const CellView view = cell_view(&spots->cells, at);
    const float blur = cells_blur(view.width);
    if (blur < 1.0f) {
        const Triple normal = filter_normal(view);
        const float reach = spots_reach(spots, view);
        gather_seeds(view, spots->cells.jitter, reach, CELLS_REACH, 0.0f, seeds);
        for (int i = 0; i < seeds->count; ++i) {
            const Seed seed = seeds->seed[i];
            if (seed_uniform(seed, 4U) < spots->share)
                add_spot(&sum, ball_part(view, seed, spot_radius(spots, seed), spots->edge, reach,
                                         normal));
        }
    }
    sum.share = lerp(sum.share, spots->mean, blur);
    sum.slope =
        gradient_before_warp(at, gradient_of_cells(&spots->cells, scaled(sum.slope, 1.0f - blur)));
    return sum;
}
