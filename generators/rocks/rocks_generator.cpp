// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/rocks_generator.h"

#include "generators/rocks/cell_rocks.h"
#include "generators/rocks/dropped.h"
#include "generators/rocks/mosaic.h"
#include "generators/rocks/paper.h"
#include "generators/rocks/rocks_specs.h"

namespace scree {

Plugin<Generator> rocks_plugin() {
    using namespace rocks;
    return {"rocks",
            "Rocks of various sizes on the ground: fallen, fitted together, or as in Sakurai & "
            "Miyata.",
            rocks_specs(), [](const Params& params) -> Bake {
                const auto settings = std::make_shared<const RocksSettings>(rocks_settings(params));
                if (settings->method == Method::dropped)
                    check_dropped(*settings);
                else
                    convex_outline(*settings);
                return [settings](const Context& context) {
                    switch (settings->method) {
                    case Method::paper:
                        return bake_paper(*settings, context);
                    case Method::mosaic:
                        return bake_mosaic(*settings, context);
                    case Method::dropped:
                        break;
                    }
                    return bake_dropped(*settings, context);
                };
            }};
}

} // namespace scree
