// SPDX-License-Identifier: GPL-3.0-or-later
// Beds of sediment: a step function of random amounts along one direction. Convolved with a
// Gaussian filter it is a sum of normal distribution functions. Needs cells.cl.

typedef struct {
    float rate; // 1 / mean thickness [1/m]
    float offset;
    uint key;
    float share;    // of beds with an amount above 0
    float softness; // standard deviation of the blur between adjacent beds, in beds
    float mean;     // mean amount
} Beds;

// The filtered amount from 0 to 1, and its slope along the direction [1/m].
typedef struct {
    float value;
    float slope;
} BedSample;

static inline uint bed_bits(uint key, int bed) { return scramble(key + (uint)bed * 0x9e3779b9U); }

static inline float bed_amount(float share, uint bits) {
    const float u = uniform_of(bits);
    return u < share ? 0.3f + 0.7f * uniform_of(scramble(bits + 1U)) : 0.0f;
}

// The coordinate at which a bed begins, in beds.
static inline float bed_floor(uint key, int bed) {
    return (float)bed + 0.9f * (uniform_of(scramble(bed_bits(key, bed) + 2U)) - 0.5f);
}

static inline float beds_place(global const Beds* beds, float z) {
    return clamped(z * beds->rate + beds->offset, -1e9f, 1e9f);
}

// The beds at z along the direction [m], filtered with the standard deviation `sigma` [m].
// `more_key` distinguishes sets of beds with the same recipe.
static inline BedSample beds_at(global const Beds* beds, uint more_key, float z, float sigma) {
    BedSample found;
    found.value = beds->mean;
    found.slope = 0.0f;
    const float wide = sqrt(square(sigma * beds->rate) + square(beds->softness)) + 1e-9f;
    const float blur = smooth(0.6f, 1.2f, wide);
    if (blur >= 1.0f)
        return found;
    const uint key = beds->key ^ more_key;
    const float p = beds_place(beds, z);
    const int middle = (int)floor(p), reach = 1 + (int)(2.5f * wide + 0.45f);
    // The amount below all beds in reach, then a step at the floor of each.
    float below = bed_amount(beds->share, bed_bits(key, middle - reach - 1));
    float value = below, slope = 0.0f;
    for (int bed = middle - reach; bed <= middle + reach; ++bed) {
        const float amount = bed_amount(beds->share, bed_bits(key, bed));
        const float t = (p - bed_floor(key, bed)) / wide;
        value += (amount - below) * (t > 4.0f ? 1.0f : t < -4.0f ? 0.0f : normal_cdf(t));
        slope += fabs(t) < 4.0f ? (amount - below) * normal_pdf(t) / wide : 0.0f;
        below = amount;
    }
    found.value = lerp(value, beds->mean, blur);
    found.slope = slope * beds->rate * (1.0f - blur);
    return found;
}

// The number of the bed that contains a coordinate, both in beds.
static inline int bed_of(uint key, float p) {
    const int bed = (int)floor(p);
    return bed_floor(key, bed) > p ? bed - 1 : bed_floor(key, bed + 1) <= p ? bed + 1 : bed;
}
