// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/rock_surface.h"
#include "generators/rocks/rocks_settings.h"

namespace scree::rocks {

/// The shape of kind number `kind`: its own axes and wear, and a seed of its own.
RockSettings settings_of_kind(const RocksSettings& settings, std::uint64_t kind);

/// The level of detail of a rock that `rank` others are larger than, of a size relative to the
/// largest's.
int level_of(const RocksSettings& settings, std::size_t rank, double relative_size);

/// The shapes that dropped rocks share, each at the levels of detail that are used.
class RockKinds {
  public:
    /// @param sizes longest axes, largest first [m]
    RockKinds(const RocksSettings& settings, std::span<const double> sizes);

    /// The surface of rock i when it is of a kind; any number is a kind.
    std::uint32_t surface_of(std::size_t i, std::uint32_t kind) const;

    std::span<const RockSurface> surfaces() const { return surfaces_; }

    /// Of a surface, which of the generator's materials is its.
    std::size_t kind_of(std::uint32_t surface) const { return kinds_[surface]; }

  private:
    std::size_t unique_ = 0; // so many of the largest rocks have a shape of their own
    std::size_t shared_ = 0; // shapes of the others
    std::vector<std::uint32_t>
        first_of_rock_;              // of each rock that shares: its level's first surface
    std::vector<std::size_t> kinds_; // of each surface
    std::vector<RockSurface> surfaces_;
};

} // namespace scree::rocks
