// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture.h"
#include "core/registry.h"
#include "model/procedural.h"

namespace scree {

/// The colours of a picture over the UV square, clamped at its borders. Transparent parts take the
/// colours of nearby opaque parts, so that shapes cut out along its outline have clean edges.
std::shared_ptr<const Procedural> picture_texture(const Picture& picture);

Plugin<MakeProcedural> image_plugin(); // procedural.image

} // namespace scree
