// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_support.h"

#include "geometry/bodies/support.h"

#include <algorithm>

namespace scree {

namespace {

PlacedBodies without(const PlacedBodies& pile, const std::vector<char>& gone) {
    PlacedBodies left(pile.shapes);
    for (std::size_t i = 0; i < pile.all.size(); ++i)
        if (!gone[i])
            left.add(pile.all[i]);
    return left;
}

double number_of(const std::vector<char>& flags) {
    return double(std::count(flags.begin(), flags.end(), 1));
}

} // namespace

void check_support(PlacedBodies& pile, const Mesh& target, const SupportSettings& settings,
                   Facts& facts) {
    if (settings.check == SupportCheck::none || pile.all.empty())
        return;
    ContactSettings contacts{.tolerance = settings.contact, .floor = settings.floor};
    if (settings.adhesive)
        contacts.adhesive = &target;
    else if (!settings.floor)
        contacts.floor = lowest_point(pile);

    ContactGraph graph = contact_graph(pile, contacts);
    const Support found = support_of(graph);
    facts.insert(facts.end(), {{"floating", number_of(found.floating)},
                               {"unsupported", number_of(found.unsupported)},
                               {"falling", number_of(found.falling)}});
    if (settings.check == SupportCheck::remove) {
        facts.emplace_back("removed", number_of(found.falling));
        pile = without(pile, found.falling);
        graph = contact_graph(pile, contacts);
    }
    facts.insert(facts.end(), {{"contacts_mean", mean_contacts(graph)},
                               {"groups", double(contact_groups(graph))}});
}

} // namespace scree
