// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <vector>

namespace scree {

/// How many samples of a pixel met first what.
struct Seen {
    std::uint32_t instance = 0; // of the scene
    std::uint32_t material = 0; // of World::materials
    std::uint32_t samples = 0;

    bool operator==(const Seen&) const = default;
};

/// What each pixel of a film sees first, and in how many of its samples: exact, however many things
/// there are. Different pixels may be written by different threads.
class MatteSamples {
  public:
    explicit MatteSamples(std::size_t pixels = 0) : seen_(pixels) {}

    bool empty() const { return seen_.empty(); }
    void add(std::size_t pixel, std::uint32_t instance, std::uint32_t material);
    std::span<const Seen> at(std::size_t pixel) const { return seen_[pixel]; } // as they came

    void save(std::ostream& out) const;

    /// Reads as many pixels as this has; the stream has failed when it does not hold them.
    void restore(std::istream& in);

  private:
    std::vector<std::vector<Seen>> seen_; // by pixel
};

} // namespace scree
