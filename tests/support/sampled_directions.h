// SPDX-License-Identifier: GPL-3.0-or-later
// A sampling routine against its own density.
#pragma once

#include "core/random.h"
#include "tests/support/rendering.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace scree::test {

// The chance of a false alarm of all sampling tests together, about 40: 0.001. Seeds are fixed.
inline constexpr double sampling_alpha = 0.001 / 40;
inline constexpr int sample_count = 200'000;

inline Vec2f next_pair(Random& random) {
    const float x = random.uniform_float();
    return {x, random.uniform_float()};
}

/// Compares directions with their density by chi-square, over cells of equal solid angle; "" or
/// what is wrong. `sample` answers a direction, or zero for a lost sample: the share of those is
/// what the density's integral leaves below 1. `fine`: squared, how many points a cell's integral
/// takes.
inline std::string check_directions(const std::function<Vec3(Random&)>& sample,
                                    const std::function<float(const Vec3&)>& pdf, int fine = 24) {
    constexpr int rows = 16;
    constexpr int columns = 32;
    std::vector<double> observed(rows * columns + 1);
    std::vector<double> expected(rows * columns + 1);
    Random random(11, Purpose::test);
    for (int i = 0; i < sample_count; ++i) {
        const Vec3 d = sample(random);
        if (d.length() == 0) {
            observed.back() += 1;
            continue;
        }
        if (std::abs(d.length() - 1) > 1e-4F)
            return "a direction is not of unit length";
        const int row = std::clamp(static_cast<int>((d.z + 1) / 2 * rows), 0, rows - 1);
        const double turn = std::atan2(double(d.y), double(d.x)) / (2 * pi) + 0.5;
        const int column = std::clamp(static_cast<int>(turn * columns), 0, columns - 1);
        observed[std::size_t(row * columns + column)] += 1;
    }
    double total = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            double sum = 0;
            for (int i = 0; i < fine; ++i)
                for (int j = 0; j < fine; ++j) {
                    const double z = (row + (i + 0.5) / fine) / rows * 2 - 1;
                    const double turn = ((column + (j + 0.5) / fine) / columns - 0.5) * 2 * pi;
                    const double sine = std::sqrt(1 - z * z);
                    sum += double(pdf(Vec3(static_cast<float>(sine * std::cos(turn)),
                                           static_cast<float>(sine * std::sin(turn)),
                                           static_cast<float>(z))));
                }
            const double share = sum / (fine * fine) * 4 * pi / (rows * columns);
            expected[std::size_t(row * columns + column)] = share * sample_count;
            total += share;
        }
    if (total > 1.004)
        return "the density integrates to " + std::to_string(total);
    expected.back() = std::max(0.0, 1 - total) * sample_count;
    return chi_square(observed, expected, sampling_alpha);
}

} // namespace scree::test
