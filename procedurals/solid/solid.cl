// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by all solid textures: points and samples, the fractal field D placed in the object, and
// analytic filtering, which replaces supersampling. Needs lattice.cl.

typedef struct {
    Triple position; // in the object's frame [m]
    Triple across;   // the filter's two perpendicular sides [m]: see ShadingPoint
    Triple along;
    float random; // of the instance, in [0, 1)
} SolidPoint;

typedef struct {
    Triple color;
    Triple slope;    // of the bump height
    float height;    // [m]
    float roughness; // negative: that of the material
    float value;
} SolidSample;

// The placement of a lattice in the object: place = rows * position + offset, in unit cubes.
typedef struct {
    Triple rows[3];
    Triple offset;
    float vary; // 1: every instance uses another part of the lattice
} Placement;

// The lattice of a texture and its nodes.
typedef struct {
    global const Lattice* lattice;
    global const short* nodes16;
    global const float* nodes32;
} Field;

static inline Triple multiply(const Triple* rows, Triple v) {
    return triple(dot3(rows[0], v), dot3(rows[1], v), dot3(rows[2], v));
}

static inline Triple multiply_transposed(const Triple* rows, Triple v) {
    return plus(plus(scaled(rows[0], v.x), scaled(rows[1], v.y)), scaled(rows[2], v.z));
}

static inline float square(float v) { return v * v; }
static inline float length_of(Triple v) { return sqrt(dot3(v, v)); }
static inline Triple lerp3(Triple a, Triple b, float share) {
    return plus(scaled(a, 1.0f - share), scaled(b, share));
}

// Smoothstep: 0 below `low`, 1 above `high`, with a continuous derivative.
static inline float smooth(float low, float high, float v) {
    const float t = clamped((v - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// floor(v) as an int, clamped to the range of int.
static inline int floor_to_int(float v) { return (int)floor(clamped(v, -1e9f, 1e9f)); }

// A uniform number in [0, 1) from random bits.
static inline float uniform_of(uint bits) { return (float)(bits >> 8) * 0x1p-24f; }

// The width of a filter with the given sides, in unit cubes.
static inline float filter_width(const Placement* placement, Triple across, Triple along) {
    return fmax(length_of(multiply(placement->rows, across)),
                length_of(multiply(placement->rows, along)));
}

// D at a position in object space, filtered with a width in unit cubes; its gradient is in object
// space [1/m].
static inline Fluctuation fluctuation_at(Field field, const Placement* placement, Triple position,
                                         float width, float random) {
    Triple place = plus(multiply(placement->rows, position), placement->offset);
    if (placement->vary > 0.0f) // shifts incommensurable with the period of the lattice
        place = plus(place, triple(random * 47.31f, random * 23.17f, random * 91.73f));
    Fluctuation found = fluctuation(field.lattice, field.nodes16, field.nodes32, place, width);
    found.gradient = multiply_transposed(placement->rows, found.gradient);
    return found;
}

// Variance of a linear function with the given gradient over the box filter.
static inline float filter_variance(Triple gradient, Triple across, Triple along) {
    return (square(dot3(gradient, across)) + square(dot3(gradient, along))) * (1.0f / 12.0f);
}

// exp(x^2) erfc(x) for x >= 0 within 1.5e-7 exp(x^2) (Hastings 1955; Abramowitz & Stegun 7.1.26).
static inline float scaled_erfc(float x) {
    const float t = 1.0f / (1.0f + 0.3275911f * x);
    return t * (0.254829592f +
                t * (-0.284496736f + t * (1.421413741f + t * (-1.453152027f + t * 1.061405429f))));
}

// The standard normal distribution function and density.
static inline float normal_cdf(float x) {
    const float tail = 0.5f * scaled_erfc(fabs(x) * 0.70710678f) * exp(-0.5f * x * x);
    return x < 0.0f ? tail : 1.0f - tail;
}
static inline float normal_pdf(float x) { return 0.39894228f * exp(-0.5f * x * x); }

// The number of parts into which an elongated filter is divided so that each is about isotropic.
// One evaluation of the whole would be limited by its long side and lose detail that its short side
// resolves.
static inline int filter_parts(Triple across, Triple along) {
    const float ratio = sqrt(dot3(along, along) / fmax(dot3(across, across), 1e-30f));
    const float parts = clamped(floor(0.5f * ratio + 0.75f), 1.0f, 8.0f);
    return (int)parts;
}

// Adds `share` times a sample to a mean.
static inline void add_sample(SolidSample* sum, SolidSample sample, float share) {
    sum->color = plus(sum->color, scaled(sample.color, share));
    sum->slope = plus(sum->slope, scaled(sample.slope, share));
    sum->height += sample.height * share;
    sum->roughness += sample.roughness * share;
    sum->value += sample.value * share;
}

static inline SolidSample no_sample(void) {
    SolidSample s;
    s.color = triple(0.0f, 0.0f, 0.0f);
    s.slope = s.color;
    s.height = 0.0f;
    s.roughness = 0.0f;
    s.value = 0.0f;
    return s;
}

// Returns the mean of `part(field, settings, position, across, along, random)` over the parts of
// the filter: see filter_parts.
#define MEAN_OF_PARTS(part, field, settings, point)                                                \
    if (!settings->filtered)                                                                       \
        point.across = point.along = triple(0.0f, 0.0f, 0.0f);                                     \
    const int parts = filter_parts(point.across, point.along);                                     \
    if (parts == 1)                                                                                \
        return part(field, settings, point.position, point.across, point.along, point.random);     \
    SolidSample mean = no_sample();                                                                \
    const float share = 1.0f / (float)parts;                                                       \
    for (int i = 0; i < parts; ++i) {                                                              \
        const float shift = ((float)i + 0.5f) * share - 0.5f;                                      \
        add_sample(&mean,                                                                          \
                   part(field, settings, plus(point.position, scaled(point.along, shift)),         \
                        point.across, scaled(point.along, share), point.random),                   \
                   share);                                                                         \
    }                                                                                              \
    return mean;
