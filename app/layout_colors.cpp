// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layout_colors.h"

#include "core/canvas.h"

#include <algorithm>
#include <optional>
#include <type_traits>

namespace scree {

namespace {

// As render/surface picks from a palette.
std::optional<Color> flat_color(const Paint& paint, float random) {
    if (!paint.palette.empty()) {
        const auto count = paint.palette.size();
        const auto index = static_cast<std::size_t>(random * static_cast<float>(count));
        return paint.palette[std::min(index, count - 1)];
    }
    if (paint.texture.procedural == nullptr)
        return paint.texture.constant;
    return std::nullopt;
}

std::optional<Color> flat_color(const Material& material, float random) {
    return std::visit(
        [&](const auto& kind) -> std::optional<Color> {
            if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, Glass>)
                return std::nullopt;
            else
                return flat_color(kind.paint, random);
        },
        material);
}

} // namespace

ElementColor layout_colors(const Scene& scene) {
    return [&scene](const Aggregate& aggregate, const Instance& instance) {
        const MaterialId id = aggregate.prototypes[instance.prototype].material;
        // The default material says nothing about a component.
        if (id == MaterialId{})
            return palette_color(instance.prototype);
        const std::optional<Color> color = flat_color(scene.materials[id.index], instance.random);
        return color ? display_color(*color) : palette_color(instance.prototype);
    };
}

} // namespace scree
