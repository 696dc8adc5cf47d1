// SPDX-License-Identifier: GPL-3.0-or-later
// From a world and a camera to a film, in one go.
#pragma once

#include "render/rendering.h"

namespace scree {

struct RenderResult {
    Film film;
    RenderStats stats;
    bool cancelled = false; // on the context's cancel: the film holds what was done until then
};

/// Renders until all samples are taken, or the limit of time or noise is reached. Reports to the
/// context's progress; on cancel returns what there is. Throws Error (usage) on a crop outside of
/// the picture.
RenderResult render(const World& world, const Camera& camera, const FilmSettings& settings,
                    const RenderOptions& options, const Context& context = {});

} // namespace scree
