// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_support.h"

#include "geometry/bodies/support.h"

#include <algorithm>

namespace scree {

namespace {

Pile without(const Pile& pile, const std::vector<char>& gone) {
    Pile left(pile.kinds);
    for (std::size_t i = 0; i < pile.all.size(); ++i)
        if (!gone[i])
            left.add(pile.all[i]);
    return left;
}

double number_of(const std::vector<char>& flags) {
    return double(std::count(flags.begin(), flags.end(), 1));
}

} // namespace

void check_support(Pile& pile, const Params& params, Facts& facts) {
    const std::string& support = params.text("support");
    if (support == "none" || pile.all.empty())
        return;
    const std::shared_ptr<const Mesh> target = params.object<Mesh>("target");
    ContactSettings settings{.tolerance = params.number("contact")};
    if (params.flag("adhesive"))
        settings.adhesive = target.get();
    if (params.has("floor"))
        settings.floor = params.number("floor");
    else if (settings.adhesive == nullptr)
        settings.floor = lowest_point(pile);

    ContactGraph graph = contact_graph(pile, settings);
    const Support found = support_of(graph);
    facts.insert(facts.end(), {{"floating", number_of(found.floating)},
                               {"unsupported", number_of(found.unsupported)},
                               {"falling", number_of(found.falling)}});
    if (support == "remove") {
        pile = without(pile, found.falling);
        graph = contact_graph(pile, settings);
    }
    facts.insert(facts.end(), {{"contacts_mean", mean_contacts(graph)},
                               {"groups", double(contact_groups(graph))}});
}

} // namespace scree
