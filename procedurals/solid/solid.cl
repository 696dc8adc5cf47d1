// SPDX-License-Identifier: GPL-3.0-or-later
// What all solid textures share: where they are asked, what they answer, the fractal field D placed
// in the object, and the filters that take the place of supersampling. Needs lattice.cl.

typedef struct {
    Triple position; // in the object's frame [m]
    Triple across;   // the filter's two sides, at right angles [m]: see ShadingPoint
    Triple along;
    float random; // of the instance, in [0, 1)
} SolidPoint;

typedef struct {
    Triple color;
    Triple slope;    // of the bump height
    float height;    // [m]
    float roughness; // below 0: none
    float value;
} SolidSample;

// A lattice in the object: place = rows * position + offset, in unit cubes.
typedef struct {
    Triple rows[3];
    Triple offset;
    float vary; // 1: every instance is cut from another place
} Placement;

// The nodes of the lattice that all textures of a material share.
typedef struct {
    global const Lattice* lattice;
    global const short* nodes16;
    global const float* nodes32;
} Field;

static inline Triple turned(const Triple* rows, Triple v) {
    return triple(inner(rows[0], v), inner(rows[1], v), inner(rows[2], v));
}

static inline Triple turned_back(const Triple* rows, Triple v) {
    return plus(plus(scaled(rows[0], v.x), scaled(rows[1], v.y)), scaled(rows[2], v.z));
}

static inline float square(float v) { return v * v; }
static inline float length_of(Triple v) { return sqrt(inner(v, v)); }
static inline Triple mixed3(Triple a, Triple b, float share) {
    return plus(scaled(a, 1.0f - share), scaled(b, share));
}

// 0 below `low`, 1 above `high`, with a continuous slope between.
static inline float smooth(float low, float high, float v) {
    const float t = limited((v - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// The whole number below, of numbers that an int may not hold too.
static inline int whole_of(float v) { return (int)floor(limited(v, -1e9f, 1e9f)); }

// Uniform in [0, 1) from a hash.
static inline float unit_of(uint bits) { return (float)(bits >> 8) * 0x1p-24f; }

// Width of a filter with these sides, in unit cubes.
static inline float filter_width(const Placement* placement, Triple across, Triple along) {
    return fmax(length_of(turned(placement->rows, across)),
                length_of(turned(placement->rows, along)));
}

// D where the object's point lies, through a filter of that width in unit cubes; its gradient in
// the object's frame [1/m].
static inline Fluctuation fluctuation_at(Field field, const Placement* placement, Triple position,
                                         float width, float random) {
    Triple place = plus(turned(placement->rows, position), placement->offset);
    if (placement->vary > 0.0f) // by numbers that agree with no period of the lattice
        place = plus(place, triple(random * 47.31f, random * 23.17f, random * 91.73f));
    Fluctuation found = fluctuation(field.lattice, field.nodes16, field.nodes32, place, width);
    found.gradient = turned_back(placement->rows, found.gradient);
    return found;
}

// Variance of a linear function with that gradient over the filter, whose sides are boxes.
static inline float filter_variance(Triple gradient, Triple across, Triple along) {
    return (square(inner(gradient, across)) + square(inner(gradient, along))) * (1.0f / 12.0f);
}

// exp(x^2) erfc(x) for x >= 0 within 1.5e-7 exp(x^2) (Hastings 1955; Abramowitz & Stegun 7.1.26).
static inline float scaled_erfc(float x) {
    const float t = 1.0f / (1.0f + 0.3275911f * x);
    return t * (0.254829592f +
                t * (-0.284496736f + t * (1.421413741f + t * (-1.453152027f + t * 1.061405429f))));
}

// The normal distribution's share below x, and its density, at unit variance.
static inline float normal_share(float x) {
    const float tail = 0.5f * scaled_erfc(fabs(x) * 0.70710678f) * exp(-0.5f * x * x);
    return x < 0.0f ? tail : 1.0f - tail;
}
static inline float normal_density(float x) { return 0.39894228f * exp(-0.5f * x * x); }

// How many parts of a drawn-out filter are evaluated: enough to make each about round, since one
// answer for all of it would leave out what its narrow side still resolves.
static inline int filter_parts(Triple across, Triple along) {
    const float ratio = sqrt(inner(along, along) / fmax(inner(across, across), 1e-30f));
    const float parts = limited(floor(0.5f * ratio + 0.75f), 1.0f, 8.0f);
    return (int)parts;
}

// Adds a share of one sample to a mean of several.
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

// A mean over the filter's parts of what `part(field, settings, position, across, along, random)`
// answers for each: one answer would leave out what a drawn-out filter's narrow side resolves.
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
