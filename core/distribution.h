// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scree {

/// A piecewise-constant density over [0, 1) (Pharr, Jakob & Humphreys 2016, section 13.3.1).
class Distribution1D {
  public:
    Distribution1D() = default;
    explicit Distribution1D(std::span<const float> weights); // finite, >= 0

    double total() const { return total_; } // sum of the weights
    /// 0 everywhere when all weights are 0; then `sample` must not be called.
    float pdf(float x) const;
    float sample(float u, float& pdf) const;

  private:
    std::vector<float> cumulative_; // starts with 0, ends with 1
    std::vector<float> density_;
    std::vector<std::uint32_t> guide_; // guide table: where searches start (Chen & Asau 1974)
    double total_ = 0;
};

/// A piecewise-constant density over [0, 1)^2: the marginal of y, then the conditional of x.
class Distribution2D {
  public:
    Distribution2D() = default;
    Distribution2D(std::span<const float> weights, int width, int height);

    double total() const { return rows_.total(); }
    float pdf(const Vec2f& p) const;
    Vec2f sample(const Vec2f& u, float& pdf) const;

  private:
    Distribution1D rows_;
    std::vector<Distribution1D> columns_;
};

} // namespace scree
