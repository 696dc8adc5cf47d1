// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/support.h"

#include "geometry/plane/convex_hull.h"

#include <algorithm>

namespace scree {

namespace {

/// The bodies that have not fallen yet, and how they stand.
class Standing {
  public:
    explicit Standing(const ContactGraph& graph) : graph_(graph), left_(graph.size(), 1) {}

    /// Those to which a chain of contacts leads from the ground; with `by_support` a chain in which
    /// each body holds up the next.
    std::vector<char> reached(bool by_support) const {
        std::vector<char> reached(graph_.size(), 0);
        std::vector<std::uint32_t> open;
        const auto reach = [&](std::uint32_t i) {
            if (left_[i] && !reached[i]) {
                reached[i] = 1;
                open.push_back(i);
            }
        };
        for (std::uint32_t i = 0; i < graph_.size(); ++i)
            if (graph_.on_ground(i))
                reach(i);
        while (!open.empty()) {
            const std::uint32_t i = open.back();
            open.pop_back();
            for (const Contact& contact : graph_.contacts[i])
                if (!by_support || holds_up(i, contact.other))
                    reach(contact.other);
        }
        return reached;
    }

    bool is_balanced(std::uint32_t i) const {
        if (graph_.anchored[i])
            return true;
        std::vector<Vec2> points = graph_.floor[i];
        for (const Contact& contact : graph_.contacts[i])
            if (left_[contact.other])
                points.insert(points.end(), contact.supports.begin(), contact.supports.end());
        return !points.empty() && in_convex_hull(Vec2(0.0), std::move(points), 0);
    }

    bool is_left(std::uint32_t i) const { return left_[i] != 0; }

    /// Removes all bodies that fall now; returns whether there were any.
    bool drop() {
        const std::vector<char> held = reached(true);
        std::vector<std::uint32_t> falling;
        for (std::uint32_t i = 0; i < graph_.size(); ++i)
            if (left_[i] && (!held[i] || !is_balanced(i)))
                falling.push_back(i);
        for (const std::uint32_t i : falling)
            left_[i] = 0;
        return !falling.empty();
    }

  private:
    bool holds_up(std::uint32_t below, std::uint32_t above) const {
        for (const Contact& contact : graph_.contacts[above])
            if (contact.other == below)
                return !contact.supports.empty();
        return false;
    }

    const ContactGraph& graph_;
    std::vector<char> left_;
};

} // namespace

Support support_of(const ContactGraph& graph) {
    Standing standing(graph);
    Support support;
    const std::vector<char> reached = standing.reached(false);
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
        support.floating.push_back(!reached[i]);
        support.unsupported.push_back(reached[i] && !standing.is_balanced(i));
    }
    while (standing.drop()) {
    }
    for (std::uint32_t i = 0; i < graph.size(); ++i)
        support.falling.push_back(!standing.is_left(i));
    return support;
}

std::size_t contact_groups(const ContactGraph& graph) {
    std::vector<char> seen(graph.size(), 0);
    std::vector<std::uint32_t> open;
    std::size_t groups = 0;
    for (std::uint32_t first = 0; first < graph.size(); ++first) {
        if (seen[first])
            continue;
        ++groups;
        seen[first] = 1;
        open.push_back(first);
        while (!open.empty()) {
            const std::uint32_t i = open.back();
            open.pop_back();
            for (const Contact& contact : graph.contacts[i])
                if (!seen[contact.other]) {
                    seen[contact.other] = 1;
                    open.push_back(contact.other);
                }
        }
    }
    return groups;
}

double mean_contacts(const ContactGraph& graph) {
    std::size_t sum = 0;
    for (const std::vector<Contact>& contacts : graph.contacts)
        sum += contacts.size();
    return graph.size() > 0 ? double(sum) / double(graph.size()) : 0;
}

} // namespace scree
