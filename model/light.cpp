// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/light.h"

#include <algorithm>

namespace scree {

namespace {

bool is_above_0(const Color& color) { return std::max({color.x, color.y, color.z}) > 0; }

struct GivesLight {
    bool operator()(const Sky& sky) const {
        const bool colored =
            is_above_0(sky.zenith) || is_above_0(sky.horizon) || is_above_0(sky.ground);
        const bool bright =
            sky.image == nullptr ||
            std::ranges::any_of(sky.image->pixels, [](float value) { return value > 0; });
        return sky.strength > 0 && colored && bright;
    }
    bool operator()(const Sun& sun) const { return sun.strength > 0 && is_above_0(sun.color); }
    bool operator()(const AreaLight& area) const { return is_above_0(area.radiance); }
};

} // namespace

bool gives_light(const Light& light) { return std::visit(GivesLight{}, light); }

LightGroups light_groups(std::span<const Light> lights) {
    LightGroups groups;
    const auto name_of = [](const Light& light) -> const std::string& {
        return std::visit([](const auto& any) -> const std::string& { return any.group; }, light);
    };
    if (std::ranges::all_of(lights, [&](const Light& light) { return name_of(light).empty(); })) {
        groups.of.assign(lights.size(), 0);
        return groups;
    }
    for (const Light& light : lights) {
        const std::string name = name_of(light).empty() ? "rest" : name_of(light);
        const auto found = std::ranges::find(groups.names, name);
        groups.of.push_back(static_cast<std::uint32_t>(found - groups.names.begin()));
        if (found == groups.names.end())
            groups.names.push_back(name);
    }
    return groups;
}

} // namespace scree
