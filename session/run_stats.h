// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"
#include "render/render.h"
#include "session/stages.h"

#include <span>
#include <string>

namespace scree {

struct Fabrication;

/// Statistics of a render.
struct RenderFigures {
    RenderStats stats;
    std::size_t instances = 0;
    std::size_t scene_bytes = 0;
    StrandFigures strands{};
};

/// The JSON of --stats (docs/formats.md): the cost of every stage, the facts of every generator
/// and, if any, the statistics of the render, the texture or the solid.
std::string run_stats_json(const Stages& stages, std::span<const Aggregate> aggregates,
                           const RenderFigures* render, const Facts& texture = {},
                           const Fabrication* solid = nullptr);

} // namespace scree
