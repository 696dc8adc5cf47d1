// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/procedural.h"

#include "core/parallel.h"
#include "core/params.h"

#include <algorithm>

namespace scree {

ParamSpec scale_with_object_spec() {
    return {.name = "scale_with_object",
            .type = ParamType::boolean,
            .doc =
                "The texture grows and shrinks with its object; otherwise its lengths are metres "
                "of the scene on every object.",
            .fallback = false};
}

void Procedural::bake(std::span<const ShadingPoint> points, std::span<ShadingSample> samples,
                      Device* /*device*/) const {
    constexpr std::size_t block = 1024; // points that stay in a core's L1 cache
    parallel_for((points.size() + block - 1) / block, 1, [&](std::size_t i) {
        const std::size_t first = i * block;
        const std::size_t count = std::min(block, points.size() - first);
        evaluate(points.subspan(first, count), samples.subspan(first, count));
    });
}

} // namespace scree
