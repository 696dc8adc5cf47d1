// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <complex>
#include <span>
#include <vector>

namespace scree {

/// Fourier sums at integer frequencies (x, y) with |x| <= reach_x and 0 <= y <= reach_y; those with
/// negative y are the complex conjugates of these.
struct FourierSums {
    int reach_x = 0;
    int reach_y = 0;
    std::vector<std::complex<double>> values; // row y, column reach_x + x

    std::size_t width() const { return 2 * std::size_t(reach_x) + 1; }
    const std::complex<double>& at(int x, int y) const {
        return values[std::size_t(y) * width() + std::size_t(reach_x + x)];
    }
};

/// The sums over points p of exp(-2 pi i (x p.x + y p.y)), for points on the unit torus
/// (coordinates are taken modulo 1). A nonuniform fast Fourier transform of type 1: points are
/// spread to a grid oversampled by 2 with the "exponential of semicircle" kernel, the grid is
/// transformed, and the result is divided by the kernel's transform (Barnett, Magland & af
/// Klinteberg 2019). The error is below 1e-7 of the number of points. The time is O(n + K log K)
/// for n points and K sums.
FourierSums fourier_sums(std::span<const Vec2> points, int reach_x, int reach_y);

} // namespace scree
