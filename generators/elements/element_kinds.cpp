// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/element_kinds.h"

#include "core/parallel.h"
#include "core/random.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

std::vector<std::uint32_t> components_of(const std::vector<std::uint32_t>& classes,
                                         const std::vector<ElementShape>& shapes,
                                         std::size_t class_count, std::uint64_t seed) {
    if (class_count == shapes.size())
        return classes;
    std::vector<double> sums;
    for (const ElementShape& shape : shapes)
        sums.push_back((sums.empty() ? 0 : sums.back()) + shape.weight);
    std::vector<std::uint32_t> components(classes.size());
    parallel_for(classes.size(), 1024, [&](std::size_t i) {
        const double at = Random(seed, Purpose::element_attribute, i).uniform(0, sums.back());
        components[i] = static_cast<std::uint32_t>(
            std::min<std::ptrdiff_t>(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin(),
                                     std::ptrdiff_t(sums.size()) - 1));
    });
    return components;
}

void add_shares(const std::vector<std::uint32_t>& components, std::size_t component_count,
                Facts& facts) {
    std::vector<double> counts(component_count, 0.0);
    for (const std::uint32_t component : components)
        ++counts[component];
    const auto all = double(components.size());
    for (std::size_t c = 0; component_count > 1 && c < component_count; ++c) {
        facts.emplace_back(fmt::format("count_{}", c + 1), counts[c]);
        facts.emplace_back(fmt::format("share_{}", c + 1), all > 0 ? counts[c] / all : 0.0);
    }
}

} // namespace scree
