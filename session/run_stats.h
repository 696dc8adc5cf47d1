// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"
#include "render/render.h"
#include "session/stages.h"

#include <span>
#include <string>

namespace scree {

struct Fabrication;

/// What a render adds to the stats.
struct RenderFigures {
    RenderStats stats;
    std::size_t instances = 0;
    std::size_t scene_bytes = 0;
};

/// The text of --stats (docs/formats.md): every stage's cost, every generator's facts, the
/// renderer's figures when there was a render, and a texture's or a solid's when one was baked.
std::string run_stats_json(const Stages& stages, std::span<const Aggregate> aggregates,
                           const RenderFigures* render, const Facts& texture = {},
                           const Fabrication* solid = nullptr);

} // namespace scree
