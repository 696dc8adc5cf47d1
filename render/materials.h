// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says about its materials; bsdf.h evaluates and samples them.
#pragma once

#include "core/procedural.h"

#include <variant>
#include <vector>

namespace scree {

/// A colour that is constant, from a procedural, or chosen from a palette by Instance.random.
struct Paint {
    Texture texture;
    std::vector<Color> palette; // not empty: used in place of the texture
};

/// Lambert's diffuse reflector.
struct Matte {
    Paint paint{{Color(0.5F, 0.5F, 0.5F), nullptr}, {}};
};

/// A diffuse base under a dielectric coat.
struct Plastic {
    Paint paint{{Color(0.5F, 0.5F, 0.5F), nullptr}, {}};
    float roughness = 0.3F; // of the coat; squared it is the GGX alpha (Burley 2012)
    float ior = 1.5F;
};

/// A conductor described by its reflectance at normal incidence.
struct Metal {
    Paint paint{{Color(0.9F, 0.9F, 0.9F), nullptr}, {}};
    float roughness = 0.2F;
};

/// A dielectric that lets light through.
struct Glass {
    float ior = 1.5F;
    Color absorption{0.0F, 0.0F, 0.0F}; // of the inside [1/m] (Beer 1852)
    float roughness = 0;                // 0: smooth
};

/// A medium in which light walks at random, under a dielectric coat.
struct Translucent {
    Paint paint{{Color(0.5F, 0.5F, 0.5F), nullptr}, {}}; // see Medium::color
    Color distance{0.001F, 0.001F, 0.001F};              // by channel [m], see make_medium
    float roughness = 0.3F;                              // of the coat
    float ior = 1.5F;
};

using Material = std::variant<Matte, Plastic, Metal, Glass, Translucent>;

} // namespace scree
