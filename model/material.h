// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says about its materials. Each alternative is made ready for rendering by its
// `prepare`, which stands in render/bsdf/<name>.cpp: only the renderer calls it.
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

/// The texture that a parameter of that type holds.
Texture texture_of(const Params& params, const std::string& name);

/// A colour that is constant, from a procedural, or chosen from a palette by Instance.random.
struct Paint {
    Texture texture;
    std::vector<Color> palette; // not empty: used in place of the texture

    /// The colour of a whole instance; none where a procedural gives it.
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
    float roughness = 0.3F; // of the coat; squared it is the GGX alpha (Burley 2012)
    float ior = 1.5F;

    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const;
};

/// A conductor described by its reflectance at normal incidence.
struct Metal {
    Paint paint{{Color(0.9F, 0.9F, 0.9F), nullptr}, {}};
    float roughness = 0.2F;

    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const;
};

/// A dielectric that lets light through.
struct Glass {
    float ior = 1.5F;
    Color absorption{0.0F, 0.0F, 0.0F}; // of the inside [1/m] (Beer 1852)
    float roughness = 0;                // 0: smooth

    std::unique_ptr<const PreparedMaterial> prepare(AlbedoTables& tables) const;
};

/// A medium in which light walks at random, under a dielectric coat.
struct Translucent {
    Paint paint{{Color(0.5F, 0.5F, 0.5F), nullptr}, {}}; // see Medium::color
    Color distance{0.001F, 0.001F, 0.001F};              // by channel [m], see make_medium
    float roughness = 0.3F;                              // of the coat
    float ior = 1.5F;

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

/// Members of an alternative that others find by their names: `paint`, `roughness` (perceptual),
/// and `static constexpr bool oriented` (as in CustomMaterial).
using Material =
    std::variant<Matte, Plastic, Metal, Glass, Translucent, std::shared_ptr<const CustomMaterial>>;

/// What a material is painted with; null for what has no paint, such as glass.
const Paint* paint_of(const Material& material);

/// Whether its look depends on a surface's UVs or tangent, which hits then carry.
bool uses_uv(const Material& material);

/// The declaration of a parameter `material`; without one what is made is of `Matte{}`. `doc`: what
/// it is, without a full stop.
ParamSpec material_spec(const std::string& doc);

} // namespace scree
