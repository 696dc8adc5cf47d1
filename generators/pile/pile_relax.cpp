// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_relax.h"

#include "generators/pile/cover_target.h"
#include "generators/pile/pile_solid.h"

namespace scree {

std::optional<RelaxSettings> relax_settings(const Params& params) {
    if (params.text("method") != "relax") {
        for (const char* name : {"iterations", "density"})
            if (params.has(name))
                throw params.error(name, "is a parameter of relaxation",
                                   "expected method = \"relax\" beside it");
        return {};
    }
    for (const char* name : {"removal", "shells"})
        if (params.has(name))
            throw params.error(name, "is no parameter of relaxation");
    if (params.number("sink") > 0)
        throw params.error("sink", "is no parameter of relaxation");
    check_closed_target(params, "method = \"relax\"");
    RelaxSettings settings{.solid = params.text("fill") == "solid",
                           .overlap = params.number("overlap")};
    if (params.has("iterations"))
        settings.iterations = static_cast<int>(params.integer("iterations"));
    if (params.has("density"))
        settings.density = params.number("density");
    return settings;
}

std::size_t place_relaxed(Pile& pile, Pile& start, const Mesh& target, const PileTurns& turns,
                          std::vector<PileSite> sites, const RelaxSettings& settings,
                          const std::optional<SolidFill>& solid, double cover,
                          const Context& context) {
    const Relaxed relaxed = relax(target, turns, settings, context);
    for (const Placed& placed : relaxed.start)
        start.add(placed);
    for (const Placed& placed : relaxed.all)
        pile.add(placed);
    const std::size_t tried = relaxed.start.size();
    const InsertionSettings insertion{.overlap = settings.overlap};
    return tried +
           (solid ? fill_solid(pile, target, turns, std::move(sites), *solid, insertion, context)
                  : pile_up(pile, target, turns, std::move(sites), insertion, cover, context));
}

} // namespace scree
