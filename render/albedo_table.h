// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace scree {

/// Share of light from one direction that a GGX surface reflects in a single bounce, by the cosine
/// of the direction: of a perfect mirror's facets, or of a dielectric's.
class AlbedoTable {
  public:
    /// `ior` 0: facets that reflect everything.
    AlbedoTable(float alpha, float ior);

    float at(float cosine) const {
        const float position = cosine * (size - 1);
        const int cell = position < size - 2 ? static_cast<int>(position) : size - 2;
        const float part = position - static_cast<float>(cell);
        const auto i = static_cast<unsigned>(cell);
        return values_[i] + (values_[i + 1] - values_[i]) * part;
    }

    /// Its cosine-weighted mean over the hemisphere, exact for what `at` answers.
    float average() const { return average_; }

  private:
    // 64 nodes keep the furnace test of plastics within 0.1%.
    static constexpr int size = 64;
    std::array<float, size> values_{};
    float average_ = 0;
};

} // namespace scree
