// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device.h"
#include "geometry/figures/domain_test.h"

#include <memory>
#include <optional>

namespace scree {

/// A pixel grid over the domain for the fill-gap method: each pixel's distance to the placed
/// elements, and the candidate points drawn from these distances. Runs on an OpenCL device or,
/// without one, as C++; both give the same bytes.
class GapField {
  public:
    /// `resolution`: pixels along the domain's longest side. What lies outside the domain counts
    /// as occupied for Inside::whole; otherwise it only yields no candidates.
    GapField(const DomainTest& domain, int resolution, Device* device);
    ~GapField();

    /// Marks the pixels whose centres lie in the region.
    void occupy(const Region& outline, const FigurePose& pose);

    /// The candidate points Q of a round, in pixel order, each at a random place in its pixel;
    /// empty when everything is occupied.
    std::vector<Vec2> candidates(std::uint32_t exponent, std::uint64_t seed, std::uint64_t round);

    int width() const { return width_; }
    int height() const { return height_; }
    Vec2 pixel_centre(int x, int y) const { return origin_ + Vec2(x + 0.5, y + 0.5) * pixel_; }
    double pixel() const { return pixel_; } // side [m]

    /// For tests: what the last call of `candidates` saw and chose, one value per pixel.
    const std::vector<std::uint8_t>& state() const { return state_; }
    const std::vector<std::uint32_t>& squared_distance() const; // [pixels^2]
    const std::vector<std::uint8_t>& marks() const { return marks_; }

  private:
    struct Buffers;

    void update_on_host();
    void update_on_device();

    bool changed_ = true; // since the distances were last computed
    double pixel_ = 0;
    Vec2 origin_;
    std::optional<Vec2> period_; // of a torus [m]
    int width_ = 0;
    int height_ = 0;
    std::vector<std::uint8_t> state_;
    std::vector<std::uint8_t> marks_;
    std::vector<std::uint32_t> row_maximum_;
    mutable std::vector<std::uint32_t> squared_;
    Device* device_;
    std::unique_ptr<Buffers> buffers_;
};

} // namespace scree
