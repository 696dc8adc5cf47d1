// SPDX-License-Identifier: GPL-3.0-or-later
// Marble: layers of veins displaced by the fractal field (Okada et al. 1987, eqs. 7-9 and 12).
// Needs solid.cl.

#define MARBLE_MAX_VEINS 32
#define MARBLE_MAX_LAYERS 4
#define PROFILE_POINTS 8192 // of the unfiltered profile; a power of 2
#define PROFILE_LEVELS 11   // filtered profiles, each with half the points of the one before
#define PROFILE_FINEST 1.5f // standard deviation of a level's filter, in steps of its points

// A planar layer of impurity: constant within its half width, with exponential decay outside.
typedef struct {
    float centre;     // along the axis [m]
    float half_width; // [m]
    float rate;       // alpha: 1 / diffusion length [1/m]
} Vein;

typedef struct {
    Placement placement;
    Triple axis;          // the veins' common normal, unit
    float start;          // the coordinate along the axis is dot3(axis, position) - start [m]
    float displacement;   // k: displacement along the axis per unit of D [m]
    float period;         // [m]; 0: the veins are not periodic
    float start_of_table; // along the axis [m]
    float length;         // of the table: the period, or three times the extent of all veins [m]
    float mean;           // of the profile over that length
    float strength;       // share of the colour where the profile is 1
    int iterations;       // of the inversion of the displacement; 0: first order
    int veins;
    Triple color;
    Vein vein[MARBLE_MAX_VEINS];
    // The profile at equal steps, then convolved with Gaussians, each with twice the standard
    // deviation of the one before.
    float table[3 * PROFILE_POINTS];
} VeinLayer;

typedef struct {
    Placement cloud_placement;
    Triple filler;
    Triple cloud;
    float cloudiness;       // maximum share of the cloud colour
    float depth;            // height of the veins [m]; negative: recessed
    float filler_roughness; // negative: that of the material
    float vein_roughness;
    int filtered;
    int layers;
    VeinLayer layer[MARBLE_MAX_LAYERS];
} Marble;

// G of a point: the sum of all veins at z along the axis, at most 1 (eq. 8). Sets its slope.
static inline float veins_sum(global const VeinLayer* layer, float z, float* slope) {
    const float period = layer->period;
    float sum = 0.0f, steepness = 0.0f;
    for (int i = 0; i < layer->veins; ++i) {
        const Vein vein = layer->vein[i];
        float x = z - vein.centre;
        if (period > 0.0f)
            x -= period * floor(x / period + 0.5f);
        const float d = fabs(x) - vein.half_width;
        const float g = d <= 0.0f ? 1.0f : exp(-vein.rate * d);
        sum += g;
        if (d > 0.0f)
            steepness += x > 0.0f ? -vein.rate * g : vein.rate * g;
    }
    *slope = sum < 1.0f ? steepness : 0.0f;
    return fmin(sum, 1.0f);
}

// `share` times a level of the table, interpolated at `place` in [0, 1); adds `share` times its
// slope.
static inline float table_row(global const float* row, int points, float place, float share,
                              float* slope) {
    const float at = place * (float)points;
    const int i = (int)at;
    const float low = row[i & (points - 1)], high = row[(i + 1) & (points - 1)];
    *slope += share * (high - low) * (float)points;
    return share * (low + (high - low) * (at - (float)i));
}

// G convolved with a Gaussian, from the layer's table; interpolated between its levels by the
// standard deviation.
static inline float veins_table(global const VeinLayer* layer, float z, float sigma, float* slope) {
    const float turns = (z - layer->start_of_table) / layer->length;
    if (layer->period == 0.0f && !(turns >= 0.0f && turns < 1.0f))
        return 0.0f;
    const float place = turns - floor(turns);
    const float wide = sigma / layer->length * ((float)PROFILE_POINTS / PROFILE_FINEST);
    float steepness = 0.0f, value;
    if (wide < 1.0f) { // variances add
        const float share = wide * wide;
        value = table_row(layer->table, PROFILE_POINTS, place, 1.0f - share, &steepness) +
                table_row(layer->table + PROFILE_POINTS, PROFILE_POINTS, place, share, &steepness);
    } else {
        const int bits = as_int(wide); // 2^level (1 + share), as IEEE 754 has it
        const int level = (bits >> 23) - 127;
        if (level >= PROFILE_LEVELS - 1)
            return layer->mean;
        const float share = as_float((bits & 0x7fffff) | 0x3f800000) - 1.0f;
        const int points = PROFILE_POINTS >> level;
        global const float* row = layer->table + 3 * PROFILE_POINTS - 2 * points;
        value = table_row(row, points, place, 1.0f - share, &steepness) +
                table_row(row + points, points >> 1, place, share, &steepness);
    }
    *slope = steepness / layer->length;
    return value;
}

// G' of one layer at a point, and its slope in the object's frame.
static inline float layer_value(Field field, global const VeinLayer* layer, Triple position,
                                Triple across, Triple along, float random, Triple* slope) {
    const Placement placement = layer->placement;
    const Triple axis = layer->axis;
    // The material at Q was displaced from the P with P + k D(P) axis = Q. To first order
    // P = Q - k D(Q) axis; fixed-point iterations P = Q - k D(P) axis improve it.
    Triple p = position, u = across, v = along, gradient = axis;
    float variance = 0.0f;
    for (int i = 0; i <= layer->iterations; ++i) {
        const Fluctuation d =
            fluctuation_at(field, &placement, p, filter_width(&placement, u, v), random);
        const float shift = layer->displacement * d.value;
        gradient = minus(axis, scaled(d.gradient, layer->displacement));
        u = minus(across, scaled(axis, layer->displacement * dot3(d.gradient, u)));
        v = minus(along, scaled(axis, layer->displacement * dot3(d.gradient, v)));
        p = minus(position, scaled(axis, shift));
        variance = square(layer->displacement) * d.variance;
    }
    variance += (square(dot3(axis, u)) + square(dot3(axis, v))) * (1.0f / 12.0f);
    float steepness = 0.0f;
    const float z = dot3(axis, p) - layer->start;
    const float sigma = sqrt(variance);
    const float value =
        sigma > 0.0f ? veins_table(layer, z, sigma, &steepness) : veins_sum(layer, z, &steepness);
    *slope = scaled(gradient, steepness);
    return value;
}

static inline SolidSample marble_part(Field field, global const Marble* marble, Triple position,
                                      Triple across, Triple along, float random) {
    SolidSample sample = no_sample();
    sample.color = marble->filler;
    if (marble->cloudiness > 0.0f) {
        const Placement placement = marble->cloud_placement;
        // Clouds are soft: levels that are not stored would not be visible.
        const float d = fluctuation_at(field, &placement, position,
                                       fmax(filter_width(&placement, across, along),
                                            1.0f / (float)(1 << field.lattice->levels)),
                                       random)
                            .value;
        sample.color =
            lerp3(sample.color, marble->cloud, marble->cloudiness * smooth(-1.2f, 1.2f, d));
    }
    float clear = 1.0f; // transparency of all veins so far
    for (int i = 0; i < marble->layers; ++i) {
        global const VeinLayer* layer = &marble->layer[i];
        Triple slope;
        const float value = layer_value(field, layer, position, across, along, random, &slope);
        sample.color = lerp3(sample.color, layer->color, value * layer->strength);
        sample.slope = plus(scaled(sample.slope, 1.0f - value), scaled(slope, clear));
        clear *= 1.0f - value;
    }
    sample.value = 1.0f - clear;
    sample.height = marble->depth * sample.value;
    sample.slope = scaled(sample.slope, marble->depth);
    sample.roughness = lerp(marble->filler_roughness, marble->vein_roughness, sample.value);
    return sample;
}

static inline SolidSample marble_at(Field field, global const Marble* marble, SolidPoint point) {
    MEAN_OF_PARTS(marble_part, field, marble, point)
}
