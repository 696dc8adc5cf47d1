// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/marble/marble_as_cpp.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scree {

/// Eq. 8 of Okada et al. (1987) at many points: the unfiltered sum of the veins, each 1 inside and
/// exp(-rate distance) outside, clamped to 1. It is tabulated as cubics over equal bins of the
/// axis, so that the time does not depend on the number of veins. Immutable, so thread-safe.
class VeinTable {
  public:
    /// With a period above 0 each vein is represented by its nearest periodic image.
    VeinTable(std::span<const solid::Vein> veins, float period);

    /// The sum at z - displacement d along the axis. The spans have equal lengths; `out` may be one
    /// of the others. All vector paths give the same bits; the scalar path evaluates the formula.
    /// They differ by less than 3e-6, plus the effect of one ulp of z.
    void values(std::span<const float> z, std::span<const float> d, float displacement,
                std::span<float> out) const;

    /// A cubic in the distance from the bin's middle, in bins, lowest power first. In a bin that
    /// contains the edge of a vein, or that one cubic does not fit, it is instead NaN and 2^23 plus
    /// an index into divided(). (The bits of the index alone would be a denormal float, which is
    /// slow.)
    struct Bin {
        float powers[4];
    };
    /// Two cubics, before and after `border`; the first is NaN if the formula must be evaluated.
    struct Divided {
        Bin before, after;
        float border;
    };

    std::span<const solid::Vein> veins() const { return veins_; } // with rates for powers of 2
    float period() const { return period_; }
    /// The bin of a coordinate is the nearest integer to the coordinate times the scale, modulo the
    /// number of bins, a power of 2. Without a period the coordinate is first clamped to the range.
    float first() const { return first_; }
    float last() const { return last_; }
    float scale() const { return scale_; }
    std::span<const Bin> bins() const { return bins_; }
    std::span<const Divided> divided() const { return divided_; }

  private:
    double sum(double z) const;
    std::size_t choose_bins();
    Bin& bin(std::int64_t number);
    std::vector<std::vector<double>> find_kinks() const;
    void fit_bins();
    Bin fit(std::int64_t number, double first, double last) const;

    std::vector<solid::Vein> veins_;
    float period_;
    float first_ = 0, last_ = 0, scale_ = 1;
    std::vector<Bin> bins_;
    std::vector<Divided> divided_;
};

} // namespace scree
