// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of what reads an image.
#pragma once

#include "core/image.h"
#include "core/params.h"

namespace scree {

/// `layer`: which layer of an EXR.
ParamSpec layer_spec();

/// What those parameters say; warnings are located at the parameter `path`, the image's. Parameters
/// without a `layer` take the usual one.
ImageOptions image_options(const Params& params, const std::string& path);

} // namespace scree
