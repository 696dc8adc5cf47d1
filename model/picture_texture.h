// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture_filter.h"
#include "model/procedural.h"

#include <optional>

namespace scree {

/// How a picture is shown.
struct PictureLook {
    std::optional<Color> ground{}; // behind transparent parts; none: nearby opaque colours
    Color tint{1.0F, 1.0F, 1.0F};  // factor of the picture's colours
    Imath::M33d picture_from_uv{}; // for row vectors (u, v, 1)
};

/// The colours of a picture over the UV square, (0, 0) at its lower left, filtered over the pixel
/// (Williams 1983).
std::shared_ptr<const Procedural> picture_texture(std::shared_ptr<const PictureFilter> picture,
                                                  const PictureLook& look = {});

/// The same, clamped at the picture's borders. Transparent parts take the colours of nearby opaque
/// parts, so that shapes cut out along its outline have clean edges.
std::shared_ptr<const Procedural> picture_texture(const Image& picture);

} // namespace scree
