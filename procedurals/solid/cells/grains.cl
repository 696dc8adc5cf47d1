// SPDX-License-Identifier: GPL-3.0-or-later
// Stone composed of grains: layers of cells of decreasing size, each cell filled by a mineral or
// left empty, so that smaller grains are visible there. Needs cells.cl.

#define GRAINS_MAX_KINDS 12
#define GRAINS_MAX_LAYERS 6

typedef struct {
    Triple color;
    float value;     // the sample's value in it
    float roughness; // negative: that of the material
    float variation; // of brightness between grains: the factor is 1 +- this
    float facet;     // of brightness across a grain
    float mottle;    // change of brightness per unit of D
    float until;     // upper bound of the normal variates of grains of this kind
} GrainKind;

typedef struct {
    Cells cells;
    Triple cluster_offset;
    float clusters;          // correlation of a grain's normal variate with D at its seed
    float cluster_scale;     // length of a cell in lattice cubes
    float cluster_deviation; // standard deviation of the levels of D that are used
    float gap;               // width left empty along borders, in cells; negative: none
    float gap_by_field;      // relative change of the gap per unit of D
    float radius;            // maximum distance of a grain from its seed, in cells
    float rim;               // thickness of the rim of a grain, in cells
    float rim_share;         // of the rim colour in the rim
    Triple rim_color;
    float whole; // share of space inside gap and radius, if all cells have grains: measured
    float core;  // the same without the rims
    int first;   // index of its first kind
    int end;     // one beyond its last kind
} GrainLayer;

typedef struct {
    int layers;
    GrainLayer layer[GRAINS_MAX_LAYERS];
    GrainKind kind[GRAINS_MAX_KINDS];
} Grains;

// A layer's contribution to the filter: colour, value and roughness are weighted by its share.
typedef struct {
    Triple color;
    float value;
    float roughness;
    float share;
    float border;   // distance to the nearest border, in cells, if requested
    Triple inwards; // unit vector away from it, in the grid's coordinates
} GrainShare;

static inline void add_grain(GrainShare* sum, global const GrainKind* kind, float brightness,
                             float share) {
    sum->color = plus(sum->color, scaled(kind->color, fmax(brightness, 0.0f) * share));
    sum->value += kind->value * share;
    sum->roughness += kind->roughness * share;
    sum->share += share;
}

// The first levels of D only, by a single look-up.
#define GRAINS_CLUSTER_LEVEL 3

static inline float coarse_field(Field field, Triple place) {
    global const Lattice* lattice = field.lattice;
    const Triple p = into_domain(lattice, place);
    if (is_stored(lattice, p) && lattice->levels >= GRAINS_CLUSTER_LEVEL)
        return stored_field(lattice, field.nodes16, field.nodes32, GRAINS_CLUSTER_LEVEL, p).value;
    return fluctuation(lattice, field.nodes16, field.nodes32, place,
                       1.41422f / (float)(1 << GRAINS_CLUSTER_LEVEL))
        .value;
}

// The normal variate of a grain, correlated with D at its seed, so that minerals form clusters.
static inline float grain_number(Field field, global const GrainLayer* layer, CellView view,
                                 Seed seed) {
    const float independent = normal_variate(seed_bits(seed, 1U));
    const float r = layer->clusters;
    if (r == 0.0f)
        return independent;
    const Triple place =
        plus(scaled(plus(view.place, seed.away), layer->cluster_scale), layer->cluster_offset);
    return r * coarse_field(field, place) / layer->cluster_deviation +
           sqrt(1.0f - r * r) * independent;
}

// The kind of a cell's grain; -1: the cell is empty.
static inline int grain_kind(global const Grains* grains, global const GrainLayer* layer,
                             float number) {
    for (int i = layer->first; i < layer->end; ++i)
        if (number < grains->kind[i].until)
            return i;
    return -1;
}

// Adds the mean over space: grains cover the share `whole`, divided among the kinds by their parts
// of the normal distribution.
static inline void add_mean_grains(global const Grains* grains, global const GrainLayer* layer,
                                   float share, GrainShare* sum) {
    float below = 0.0f;
    const float rims = layer->rim_share * (layer->whole - layer->core);
    for (int i = layer->first; i < layer->end; ++i) {
        global const GrainKind* kind = &grains->kind[i];
        const float until = normal_cdf(kind->until);
        const float part = share * (until - below);
        add_grain(sum, kind, 1.0f, part * layer->whole);
        sum->color = plus(sum->color, scaled(minus(layer->rim_color, kind->color), part * rims));
        below = until;
    }
}

// The share of a cell that its grain covers, which lies at least `gap` from the borders and within
// `radius` of the seed. Within the filter it is estimated from the plane between this cell and the
// most important other one.
static inline float grain_inside(CellView view, const Seeds* seeds, int i, float border,
                                 Triple inwards, float gap, float radius, float whole) {
    const float wide = smooth(0.12f, 0.5f, 0.28867513f * view.width);
    if (wide >= 1.0f)
        return whole;
    if (i > 0)
        border = -plane_distance(seeds, i, &inwards);
    const float sigma = deviation_along(view, inwards) + 1e-9f;
    const Triple to_seed = seeds->seed[i].away;
    const float away = length_of(to_seed) + 1e-12f;
    const float z = (radius - away) / (deviation_along(view, to_seed) / away + 1e-9f);
    float inside = z > 4.0f ? 1.0f : z < -4.0f ? 0.0f : normal_cdf(z);
    if (border < gap + 4.0f * sigma)
        inside *=
            fmin(normal_cdf((border - gap) / sigma) / (normal_cdf(border / sigma) + 1e-9f), 1.0f);
    return lerp(inside, whole, wide);
}

static inline float grain_brightness(global const GrainKind* kind, Seed seed, float d) {
    const uint bits = seed_bits(seed, 2U);
    const Triple way = triple((float)(bits & 1023U) - 512.0f,
                              (float)((bits >> 10) & 1023U) - 512.0f, (float)(bits >> 22) - 512.0f);
    const float slant = clamped(dot3(way, seed.away) * (1.0f / 512.0f), -1.0f, 1.0f);
    return fmax(1.0f + kind->variation * (2.0f * seed_uniform(seed, 3U) - 1.0f) +
                    kind->facet * slant + kind->mottle * d,
                0.0f);
}

// The gap, modulated by D.
static inline float grain_gap(global const GrainLayer* layer, WarpedPoint at) {
    return layer->gap * (1.0f + layer->gap_by_field * at.field);
}

// The filtered layer. `asked` is the distance up to which the caller needs borders, in cells.
static inline GrainShare grain_layer(Field field, global const Grains* grains,
                                     global const GrainLayer* layer, WarpedPoint at, float asked,
                                     Seeds* seeds) {
    GrainShare sum;
    sum.color = sum.inwards = triple(0.0f, 0.0f, 0.0f);
    sum.value = sum.roughness = sum.share = 0.0f;
    sum.border = asked;
    const CellView view = cell_view(&layer->cells, at);
    const float blur = cells_blur(view.width);
    if (blur > 0.0f)
        add_mean_grains(grains, layer, blur, &sum);
    if (blur >= 1.0f)
        return sum;
    const bool outlined = layer->gap >= 0.0f;
    const float gap = grain_gap(layer, at);
    const float depth = outlined ? fmax(gap + layer->rim, 0.0f) : 0.0f;
    const float margin = fmax(depth + border_margin(view), asked);
    gather_seeds(view, layer->cells.jitter, CELLS_REACH, margin, 0.0f, seeds);
    if (outlined || asked > 0.0f)
        sum.border = border_distance(seeds, margin, &sum.inwards);
    cell_shares(view, seeds);
    for (int i = 0; i < seeds->count; ++i) {
        const float share = seeds->share[i] * (1.0f - blur);
        const Seed seed = seeds->seed[i];
        const int k = grain_kind(grains, layer, grain_number(field, layer, view, seed));
        if (k < 0)
            continue;
        global const GrainKind* kind = &grains->kind[k];
        const float brightness = grain_brightness(kind, seed, at.field);
        if (!outlined) {
            add_grain(&sum, kind, brightness, share);
            continue;
        }
        const float inside =
            grain_inside(view, seeds, i, sum.border, sum.inwards, gap, layer->radius, layer->whole);
        add_grain(&sum, kind, brightness, share * inside);
        if (layer->rim_share > 0.0f) {
            const float core =
                grain_inside(view, seeds, i, sum.border, sum.inwards, gap + layer->rim,
                             layer->radius - layer->rim, layer->core);
            sum.color =
                plus(sum.color, scaled(minus(layer->rim_color, scaled(kind->color, brightness)),
                                       layer->rim_share * share * fmax(inside - core, 0.0f)));
        }
    }
    return sum;
}

// All layers from `from` composited; `covered` is the share of the filter that they cover.
static inline SolidSample all_grains(Field field, global const Grains* grains, int from,
                                     WarpedPoint at, Seeds* seeds, float* covered) {
    SolidSample sample = no_sample();
    float clear = 1.0f;
    for (int i = from; i < grains->layers && clear > 1e-3f; ++i) {
        const GrainShare found = grain_layer(field, grains, &grains->layer[i], at, 0.0f, seeds);
        sample.color = plus(sample.color, scaled(found.color, clear));
        sample.value += clear * found.value;
        sample.roughness += clear * found.roughness;
        clear *= 1.0f - fmin(found.share, 1.0f);
    }
    *covered = 1.0f - clear;
    return sample;
}
