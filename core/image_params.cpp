// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image_params.h"

namespace scree {

ParamSpec layer_spec() {
    return {.name = "layer",
            .type = ParamType::text,
            .doc = "Layer or part of an EXR that has several: \"ViewLayer.Combined\", or its end "
                   "\"Combined\". Without it the one without a name, or called combined, rgba, "
                   "rgb, beauty or color.",
            .optional = true};
}

ImageOptions image_options(const Params& params, const std::string& path) {
    return {params.has("layer") ? params.text("layer") : std::string(),
            [params, path](const std::string& message) { params.warn(path, message); }};
}

} // namespace scree
