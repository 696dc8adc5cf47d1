// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/marble/marble_as_cpp.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scree {

/// Eq. 8 of Okada et al. (1987) for many points: the veins' sum, 1 inside of a vein and exp(-rate
/// distance) outside, at most 1 and unfiltered, by parabolas over even bins of the axis, so that
/// any number of veins costs the same. Thread-safe once made.
class VeinTable {
  public:
    /// With a period above 0 every vein counts by its nearest image.
    VeinTable(std::span<const solid::Vein> veins, float period);

    /// At z - push d along the axis; the spans have one length, and `out` may be one of the others.
    /// All vector paths give the same bits; the scalar path is the formula. They differ by less
    /// than 3e-6, and by what one unit in the last place of z makes.
    void values(std::span<const float> z, std::span<const float> d, float push,
                std::span<float> out) const;

    /// A cubic in the distance from the bin's middle, in bins, lowest power first. Or, in a bin
    /// where a vein has its edge, or which is wide for what happens in it: no number, and 2^23 plus
    /// the number of one in divided(). (The number's bits alone would be a denormal number, over
    /// which processors stumble.)
    struct Bin {
        float powers[4];
    };
    /// Such cubics up to `border` and beyond; no number in the first where the sum itself is
    /// needed.
    struct Divided {
        Bin before, after;
        float border;
    };

    std::span<const solid::Vein> veins() const { return veins_; } // rates in powers of 2
    float period() const { return period_; }
    /// The bin of a coordinate, limited to the range if there is no period, has the nearest integer
    /// to it times the scale for its number, modulo the bins, a power of 2.
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
