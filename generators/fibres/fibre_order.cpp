// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/fibre_order.h"

#include <algorithm>
#include <array>

namespace scree::fibres {

namespace {

constexpr int bits = 10; // of each coordinate

/// Bit k of `value` becomes bit 3 k.
std::uint32_t spread(std::uint32_t value) {
    std::uint32_t out = 0;
    for (int k = 0; k < bits; ++k)
        out |= ((value >> k) & 1U) << (3 * k);
    return out;
}

} // namespace

std::vector<std::uint32_t> order_in_space(std::span<const Vec3> places) {
    Box3 box;
    for (const Vec3& p : places)
        box.extendBy(p);
    const Vec3 size = box.isEmpty() ? Vec3(0.0F) : box.size();
    const float longest = std::max({size.x, size.y, size.z});
    const float cells = longest > 0 ? static_cast<float>((1 << bits) - 1) / longest : 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> keyed(places.size()); // code, index
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec3 cell = (places[i] - box.min) * cells;
        std::uint32_t code = 0;
        for (int axis = 0; axis < 3; ++axis)
            code |= spread(static_cast<std::uint32_t>(cell[axis])) << axis;
        keyed[i] = {code, static_cast<std::uint32_t>(i)};
    }
    std::ranges::sort(keyed);
    std::vector<std::uint32_t> order(places.size());
    std::ranges::transform(keyed, order.begin(), [](const auto& entry) { return entry.second; });
    return order;
}

} // namespace scree::fibres
