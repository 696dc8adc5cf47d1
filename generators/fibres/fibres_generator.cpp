// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/fibres_generator.h"

#include "generators/fibres/bake_fibres.h"
#include "generators/fibres/fibres_specs.h"

namespace scree {

Plugin<Generator> fibres_plugin() {
    using namespace fibres;
    return {
        "fibres",
        "Aggregates of staple fibres: dust, wool, nests, noodles, felt, hair (Sakurai 2013, "
        "chapter 5).",
        fibres_specs(), [](const Params& params) -> Bake {
            const auto settings = std::make_shared<const FibresSettings>(fibres_settings(params));
            return [settings](const Context& context) { return bake_fibres(*settings, context); };
        }};
}

} // namespace scree
