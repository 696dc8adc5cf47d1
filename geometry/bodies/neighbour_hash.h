// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/body.h"

#include <unordered_map>

namespace scree {

/// Finds placed bodies near a point. Each shape of body has a grid of its own, with cells as wide
/// as the body, so that small bodies among large ones are found as fast as among their own.
class NeighbourHash {
  public:
    explicit NeighbourHash(const Bodies& bodies);

    /// Adds number `index`, of the given body, at `centre`.
    void add(std::uint32_t body, std::uint32_t index, const Imath::V3d& centre);

    /// Calls found(index) for all whose reach comes within `radius` [m] of `centre`.
    template <class Found>
    void near(const Imath::V3d& centre, double radius, const Found& found) const {
        for (const Cells& cells : cells_of_body_)
            cells.near(centre, radius, found);
    }

  private:
    struct Entry {
        Imath::V3d centre;
        std::uint32_t index;
    };
    using Key = std::array<std::int32_t, 3>;
    struct KeyHash {
        std::size_t operator()(const Key& key) const {
            std::uint64_t hash = 0;
            for (const std::int32_t i : key) {
                hash = (hash ^ static_cast<std::uint32_t>(i)) * 0x9e3779b97f4a7c15ULL;
                hash ^= hash >> 29;
            }
            return hash;
        }
    };
    struct Cells {
        double reach = 0;
        std::unordered_map<Key, std::vector<Entry>, KeyHash> entries;

        std::int32_t cell(double x) const {
            return static_cast<std::int32_t>(std::floor(x / (2 * reach)));
        }

        template <class Found>
        void near(const Imath::V3d& centre, double radius, const Found& found) const {
            if (entries.empty())
                return;
            const double far = radius + reach;
            Key low, high;
            for (int axis = 0; axis < 3; ++axis) {
                low[std::size_t(axis)] = cell(centre[axis] - far);
                high[std::size_t(axis)] = cell(centre[axis] + far);
            }
            for (std::int32_t z = low[2]; z <= high[2]; ++z)
                for (std::int32_t y = low[1]; y <= high[1]; ++y)
                    for (std::int32_t x = low[0]; x <= high[0]; ++x) {
                        const auto at = entries.find({x, y, z});
                        if (at == entries.end())
                            continue;
                        for (const Entry& entry : at->second)
                            if ((entry.centre - centre).length2() < far * far)
                                found(entry.index);
                    }
        }
    };

    std::vector<Cells> cells_of_body_;
};

} // namespace scree
