// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/element_color.h"

#include "core/canvas.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace scree {

namespace {

bool has_procedural(const std::shared_ptr<const Material>& material) {
    const Paint* paint = material == nullptr ? nullptr : paint_of(*material);
    return paint != nullptr && !paint->one_color(0);
}

/// Of the components that are drawn in one colour although a procedural gives theirs.
std::vector<std::string> names_of_plain(const Aggregate& aggregate) {
    std::vector<std::string> names;
    for (const Prototype& prototype : aggregate.prototypes)
        if (prototype.region && !prototype.picture &&
            std::ranges::any_of(prototype.materials, has_procedural) &&
            std::ranges::find(names, prototype.name) == names.end())
            names.push_back(prototype.name);
    return names;
}

} // namespace

Color element_color(const Aggregate& aggregate, const Instance& instance) {
    const Paint* paint = paint_of(aggregate.prototypes[instance.prototype].materials);
    const std::optional<Color> color =
        paint == nullptr ? std::nullopt : paint->one_color(instance.random);
    return color ? display_color(*color) : palette_color(instance.prototype);
}

void warn_of_plain_colors(std::span<const Aggregate> aggregates, const Warn& warn) {
    for (const Aggregate& aggregate : aggregates)
        if (const auto names = names_of_plain(aggregate); !names.empty())
            warn(Diagnostic{aggregate.where, "generator." + title(aggregate),
                            fmt::format("a drawing has one flat colour for each component: the "
                                        "procedural of {} is not shown",
                                        fmt::join(names, ", ")),
                            ""}
                     .text());
}

} // namespace scree
