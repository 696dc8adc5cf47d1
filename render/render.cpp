// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/render.h"

#include <limits>

namespace scree {

RenderResult render(const World& world, const Camera& camera, const FilmSettings& settings,
                    const RenderOptions& options, const Context& context) {
    Rendering rendering(world, camera, settings, options, context);
    rendering.pass(); // at least one sample per pixel
    rendering.step(options.time_limit > 0 ? options.time_limit - rendering.stats().seconds
                                          : std::numeric_limits<double>::infinity());
    return {rendering.take_film(), rendering.stats(), rendering.cancelled()};
}

} // namespace scree
