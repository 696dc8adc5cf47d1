// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/render.h"
#include "session/run_stats.h"
#include "session/session.h"

namespace scree {

/// A finished or interrupted picture with its statistics.
struct Rendered {
    RenderResult result;
    RenderFigures figures;
};

/// Builds the world of a scene (stage "build") and renders it (stage "render"). Throws Error when
/// the scene has no camera, and as World and render() do.
Rendered render_scene(Session& session, const Scene& scene, const RenderOptions& options);

} // namespace scree
