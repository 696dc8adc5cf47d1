// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/render_scene.h"

namespace scree {

Rendered render_scene(Session& session, const Scene& scene, const RenderOptions& options) {
    session.stages().begin("build");
    const World world(scene.aggregates, scene.lights, session.context("build"),
                      world_origin(scene.camera.value()));
    session.stages().begin("render");
    RenderResult result =
        render(world, scene.camera.value(), scene.film, options, session.context("render"));
    session.stages().end();
    const RenderFigures figures{result.stats, world.instance_count(), world.memory_bytes(),
                                world.strand_figures()};
    return {std::move(result), figures};
}

} // namespace scree
