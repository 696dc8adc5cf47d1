// SPDX-License-Identifier: GPL-3.0-or-later
// The lights of a scene as data; light_sampler.h samples them.
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace scree {

/// Light from all directions: a vertical gradient, or a latitude-longitude image.
struct Sky {
    Color zenith{1.0F, 1.0F, 1.0F};
    Color horizon{1.0F, 1.0F, 1.0F};
    Color ground{1.0F, 1.0F, 1.0F};     // below the horizon
    std::shared_ptr<const Image> image; // R, G, B; its centre column lies at -z; null: gradient
    float rotation = 0;                 // about y, counter-clockwise seen from above [rad]
    float strength = 1;                 // radiance of a colour of 1 [W/(m^2 sr)]
    std::string group{};                // as of all lights, see LightGroups
};

/// A distant disk of uniform radiance.
struct Sun {
    Vec3 direction{0.0F, 1.0F, 0.0F}; // towards the sun; any length
    float angle = 0.0093F;            // angular diameter [rad]; 0.53 deg as seen from the Earth
    Color color{1.0F, 1.0F, 1.0F};
    float strength = 3; // irradiance on a plane that faces it, for a colour of 1 [W/m^2]
    std::string group{};
};

/// A rectangle that emits on one side, that of cross(edge_u, edge_v).
struct AreaLight {
    WideVec3 centre{0, 0, 0};
    Vec3 edge_u{1.0F, 0.0F, 0.0F}; // full sides [m], perpendicular to each other
    Vec3 edge_v{0.0F, 0.0F, 1.0F};
    Color radiance{1.0F, 1.0F, 1.0F}; // [W/(m^2 sr)]
    std::string group{};

    Vec3 normal() const { return edge_u.cross(edge_v).normalized(); }
    std::array<Vec3, 4> corners() const { // in turn; the first two lie along edge_u
        const Vec3 first = Vec3(centre) - (edge_u + edge_v) * 0.5F;
        return {first, first + edge_u, first + edge_u + edge_v, first + edge_v};
    }
};

using Light = std::variant<Sky, Sun, AreaLight>;

/// Whether any radiance of the light is above 0.
bool gives_light(const Light& light);

/// Lights whose share of a picture is kept apart, so that it can be weighed and coloured
/// afterwards.
struct LightGroups {
    std::vector<std::string> names; // in the order of the lights; none when no light has a group
    std::vector<std::uint32_t> of;  // by light, index into `names`
};

/// The groups of a scene's lights. When only some lights have one, the others are group "rest", so
/// that all groups together are the picture.
LightGroups light_groups(std::span<const Light> lights);

} // namespace scree
