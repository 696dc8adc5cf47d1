// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/render.h"
#include "session/run_stats.h"
#include "session/session.h"

#include <functional>

namespace scree {

/// How a render is kept from being lost, and shown while it runs.
struct RenderCare {
    std::string checkpoint{};     // file; empty: none
    bool resume = false;          // continue from it if it exists, and keep it at the end
    double checkpoint_every = 60; // [s]
    double preview_every = 0;     // [s]; 0: never
    /// Shows the picture so far: after the first pass, and as often as preview_every says.
    std::function<void(const Film& film)> preview{};
};

/// A finished or interrupted picture with its statistics.
struct Rendered {
    RenderResult result;
    RenderFigures figures;
    std::vector<std::shared_ptr<const Material>> materials; // by Seen::material
    std::string spent_checkpoint{}; // to be removed once the picture is written; empty: none
};

/// Builds the world of a scene (stage "build") and renders it (stage "render"). A checkpoint is
/// written while it renders and when it is interrupted; that of a finished picture is spent, unless
/// it was resumed. Throws Error when the scene has no camera, and as World, Rendering and
/// Checkpoint::read do.
Rendered render_scene(Session& session, const Scene& scene, const RenderOptions& options,
                      const RenderCare& care = {});

} // namespace scree
