// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture.h"
#include "core/registry.h"
#include "model/procedural.h"

namespace scree {

/// The picture's colours over the UV square, which goes on at its borders; where it is transparent
/// those of what is opaque nearby, so that shapes cut out along its outline have clean edges.
std::shared_ptr<const Procedural> picture_texture(const Picture& picture);

Plugin<MakeProcedural> image_plugin(); // procedural.image

} // namespace scree
