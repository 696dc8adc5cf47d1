// SPDX-License-Identifier: GPL-3.0-or-later
// A rough-hewn surface, whose height is the fractal field. Needs solid.cl.

// Mean over space of the squared gradient of T_n / L_n, per half cell of that level (measured).
#define HEWN_MEAN_SQUARE 2.6f

typedef struct {
    Placement placement;
    float height; // per unit of D [m]
} Hewn;

// The perceptual roughness after bumps with the mean squared slope `lost` were filtered out: the
// variance of the normals adds to that of the microfacets (Toksvig 2005, "Mipmapping normal maps";
// Olano & Baker 2010, "LEAN mapping"), which is alpha^2 / 2 along each direction. Two of the three
// components of a slope are tangential to the surface.
static inline float roughened(float roughness, float lost) {
    if (roughness < 0.0f || !(lost > 0.0f))
        return roughness;
    return fmin(sqrt(sqrt(square(square(roughness)) + 0.6666667f * lost)), 1.0f);
}

// Adds the height and slope of the rough surface; slopes that the filter removes add to the
// roughness.
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
        const float share = fmin((float)level - resolved, 1.0f); // removed amplitude
        lost += HEWN_MEAN_SQUARE * share * (2.0f - share) *
                square(field.lattice->amplitude[level] * (float)(1 << level));
    }
    lost *= dot3(placement.rows[0], placement.rows[0]) * square(hewn->height);
    sample->roughness = roughened(sample->roughness, lost);
}
