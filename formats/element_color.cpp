// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/element_color.h"

#include "core/canvas.h"

namespace scree {

Color element_color(const Aggregate& aggregate, const Instance& instance) {
    const Paint* paint = paint_of(aggregate.prototypes[instance.prototype].materials);
    const std::optional<Color> color =
        paint == nullptr ? std::nullopt : paint->one_color(instance.random);
    return color ? display_color(*color) : palette_color(instance.prototype);
}

} // namespace scree
