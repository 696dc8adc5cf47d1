// SPDX-License-Identifier: GPL-3.0-or-later
// A rough surface whose height is the fractal field itself. Needs solid.cl.

// Mean over space of the square of the gradient of T_n / L_n, in halves of that level's
// cells (measured).
#define HEWN_MEAN_SQUARE 2.6f

typedef struct {
    Placement placement;
    float height; // of a unit of D [m]
} Hewn;

// Perceptual roughness where bumps of that mean squared slope are no longer seen: the normals'
// variance adds to that of the facets (Toksvig 2005, "Mipmapping normal maps"; Olano & Baker 2010,
// "LEAN mapping"), which is alpha^2 / 2 along each direction; two of a slope's three components lie
// in the surface.
static inline float roughened(float roughness, float lost) {
    if (roughness < 0.0f || !(lost > 0.0f))
        return roughness;
    return fmin(sqrt(sqrt(square(square(roughness)) + 0.6666667f * lost)), 1.0f);
}

// Adds the height, and what the filter leaves out of the slope to the roughness.
static inline void hew(Field field, global const Hewn* hewn, Triple position, Triple across,
                       Triple along, float random, SolidSample* sample) {
    if (hewn->height == 0.0f)
        return;
    const Placement placement = hewn->placement;
    const int levels = field.lattice->levels;
    const float finest = 1.41422f / (float)(1 << levels);
    const float width = fmax(filter_width(&placement, across, along), finest);
    const Fluctuation d = fluctuation_at(field, &placement, position, width, random);
    sample->height += hewn->height * d.value;
    sample->slope = plus(sample->slope, scaled(d.gradient, hewn->height));
    const float resolved = resolved_level(field.lattice, width);
    float lost = 0.0f;
    for (int level = levels; level > 0 && (float)level > resolved; --level) {
        const float share = fmin((float)level - resolved, 1.0f); // not taken, in amplitude
        lost += HEWN_MEAN_SQUARE * share * (2.0f - share) *
                square(field.lattice->spread[level] * (float)(1 << level));
    }
    lost *= inner(placement.rows[0], placement.rows[0]) * square(hewn->height);
    sample->roughness = roughened(sample->roughness, lost);
}
