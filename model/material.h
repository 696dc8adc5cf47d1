// SPDX-License-Identifier: GPL-3.0-or-later
// The materials of a scene as data; bsdf.h evaluates and samples them.
#pragma once

#include "core/params.h"
#include "model/procedural.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace scree {

class AlbedoTables;
class PreparedMaterial;

/// A colour that is constant or comes from a procedural.
struct Texture {
    Color constant{0.0F, 0.0F, 0.0F};
    std::shared_ptr<const Procedural> procedural; // null: constant
};

/// The texture of a parameter of type `texture`.
Texture texture_of(const Params& params, const std::string& name);

/// A colour: a texture, or one of a palette, chosen for each instance by Instance::random.
struct Paint {
    Texture texture;
    std::vector<Color> palette; // unless empty, replaces the texture

    /// The colour of an instance if it is uniform, that is, unless a procedural gives it.
    std::optional<Color> one_color(float random) const {
        if (palette.empty())
            return texture.procedural == nullptr ? std::optional(texture.constant) : std::nullopt;
        const auto index = static_cast<std::size_t>(random * static_cast<float>(palette.size()));
        return palette[std::min(index, palette.size() - 1)];
    }
};

/// Lambert's diffuse reflector.
struct Matte {
    Paint paint{{Color(0.5F, 0.5F, 0.5F), nullptr}, {}};

    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const;
};

/// A diffuse base under a dielectric coat.
struct Plastic {
    Paint paint{{Color(0.5F, 0.5F, 0.5F), nullptr}, {}};
    float roughness = 0.3F; // of the coat; its square is the GGX alpha (Burley 2012)
    float ior = 1.5F;

    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const;
};

/// A conductor described by its reflectance at normal incidence.
struct Metal {
    Paint paint{{Color(0.9F, 0.9F, 0.9F), nullptr}, {}};
    float roughness = 0.2F;

    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const;
};

/// A dielectric that reflects and refracts.
struct Glass {
    float ior = 1.5F;
    Color absorption{0.0F, 0.0F, 0.0F}; // of the inside [1/m] (Beer 1852)
    float roughness = 0;                // 0: smooth

    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const;
};

/// A scattering medium (subsurface random walk) under a dielectric coat.
struct Translucent {
    Paint paint{{Color(0.5F, 0.5F, 0.5F), nullptr}, {}}; // see Medium::color
    Color distance{0.001F, 0.001F, 0.001F};              // by channel [m], see make_medium
    float roughness = 0.3F;                              // of the coat
    float ior = 1.5F;

    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const;
};

/// A dielectric cylinder with a rough surface, far thinner than what is seen of it, such as a hair
/// (Chiang et al. 2016, "A practical and controllable hair and fur model for production path
/// tracing"). For strands: light goes through the whole fibre at once.
struct Fibre {
    static constexpr bool oriented = true; // along the strand

    Paint paint{{Color(0.5F, 0.5F, 0.5F), nullptr}, {}}; // of a thick bunch, see fibre_color.h
    float beta_m = 0.3F;                                 // roughness along the fibre, in (0, 1]
    float beta_n = 0.3F;                                 // around it
    float eta = 1.55F;                                   // index of refraction
    float tilt = 0.034906585F;                           // of its scales towards the root [rad]

    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const;
};

/// A material that a program adds at run time. Thread-safe once made.
class CustomMaterial {
  public:
    virtual ~CustomMaterial() = default;

    /// What it is painted with; null: nothing.
    virtual const Paint* paint() const { return nullptr; }

    /// Whether it scatters differently when the surface is turned about its normal: hits then carry
    /// the tangent.
    virtual bool oriented() const { return false; }

    virtual std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const = 0;
};

/// The range of an index of refraction relative to air.
inline constexpr double least_ior = 1.01;
inline constexpr double largest_ior = 3;

/// Members of an alternative that others find by their names: `paint`, `roughness` (perceptual),
/// and `static constexpr bool oriented` (as in CustomMaterial).
using Material = std::variant<Matte, Plastic, Metal, Glass, Translucent, Fibre,
                              std::shared_ptr<const CustomMaterial>>;

/// The materials of a shape: none, which is grey matte; one for all of it; or one for each part of
/// its mesh, by Mesh::parts. A null pointer is grey matte.
using Materials = std::vector<std::shared_ptr<const Material>>;

/// The material's paint; null when it has none, such as glass.
const Paint* paint_of(const Material& material);

/// That of a shape's only material; null when there is another number of materials.
const Paint* paint_of(const Materials& materials);

/// Whether one of them is for strands alone.
bool any_fibre(const Materials& materials);

/// Whether light goes through it, which must be inside or outside of the shape then.
bool has_inside(const Material& material);

/// Whether a picture or the like covers it, which UVs put in place.
bool shows_picture(const Material& material);

/// The material with facets of at least this (perceptual) roughness.
Material roughened(const Material& material, float least);

/// Whether its look depends on a surface's UVs or tangent, which hits then carry.
bool uses_uv(const Material& material);

/// The declaration of an optional parameter `material`, whose default is `Matte{}`. `doc` is its
/// description without a full stop.
ParamSpec material_spec(const std::string& doc);

} // namespace scree
