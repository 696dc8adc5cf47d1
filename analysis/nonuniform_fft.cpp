// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/nonuniform_fft.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <bit>

namespace scree {

namespace {

using Complex = std::complex<double>;

// Kernel of Barnett et al. (2019), eq. 1.8, for an oversampling factor of 2.
constexpr int kernel_width = 10;
constexpr double kernel_beta = 2.30 * kernel_width;

double kernel(double offset) { // in grid steps
    const double z = 2 * offset / kernel_width;
    return std::abs(z) < 1 ? std::exp(kernel_beta * (std::sqrt(1 - z * z) - 1)) : 0;
}

// The kernel's Fourier transform at `cycles` per grid step, by Simpson's rule. The kernel is
// negligible, 1e-10, at its ends.
double kernel_transform(double cycles) {
    constexpr int steps = 400;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double offset = kernel_width * (double(i) / steps - 0.5);
        const double weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
        sum += weight * kernel(offset) * std::cos(2 * pi * cycles * offset);
    }
    return sum * kernel_width / (3.0 * steps);
}

/// In-place fast Fourier transform of 2^n numbers (Cooley & Tukey 1965).
class FastFourier {
  public:
    explicit FastFourier(std::size_t size) : size_(size), roots_(size / 2) {
        for (std::size_t i = 0; i < roots_.size(); ++i)
            roots_[i] = std::polar(1.0, -2 * pi * double(i) / double(size));
    }

    void operator()(std::vector<Complex>& data) const {
        for (std::size_t i = 1, j = 0; i < size_; ++i) { // bit reversal
            std::size_t bit = size_ >> 1;
            for (; (j & bit) != 0; bit >>= 1)
                j ^= bit;
            j ^= bit;
            if (i < j)
                std::swap(data[i], data[j]);
        }
        for (std::size_t half = 1; half < size_; half *= 2) {
            const std::size_t stride = size_ / (2 * half);
            for (std::size_t start = 0; start < size_; start += 2 * half)
                for (std::size_t k = 0; k < half; ++k) {
                    const Complex& root = roots_[k * stride];
                    const Complex& b = data[start + half + k];
                    // Faster than operator*, which handles NaN.
                    const Complex turned(b.real() * root.real() - b.imag() * root.imag(),
                                         b.real() * root.imag() + b.imag() * root.real());
                    const Complex a = data[start + k];
                    data[start + k] = a + turned;
                    data[start + half + k] = a - turned;
                }
        }
    }

  private:
    std::size_t size_;
    std::vector<Complex> roots_;
};

std::size_t grid_size(int reach) {
    return std::bit_ceil(std::size_t(std::max(2 * (2 * reach + 1), 2 * kernel_width)));
}

// The grid cells that a coordinate is spread to, and its weight in each.
struct Spread {
    std::array<std::size_t, kernel_width> cell;
    std::array<double, kernel_width> weight;

    Spread(double coordinate, std::size_t size) {
        const double at = (coordinate - std::floor(coordinate)) * double(size);
        const auto first = static_cast<std::int64_t>(std::ceil(at - kernel_width / 2.0));
        for (int i = 0; i < kernel_width; ++i) {
            cell[std::size_t(i)] = static_cast<std::size_t>(first + i) & (size - 1);
            weight[std::size_t(i)] = kernel(double(first + i) - at);
        }
    }
};

std::vector<double> spread_grid(std::span<const Vec2> points, std::size_t columns,
                                std::size_t rows) {
    std::vector<double> grid(columns * rows);
    for (const Vec2& point : points) {
        const Spread x(point.x, columns);
        const Spread y(point.y, rows);
        for (std::size_t j = 0; j < kernel_width; ++j) {
            double* row = &grid[y.cell[j] * columns];
            for (std::size_t i = 0; i < kernel_width; ++i)
                row[x.cell[i]] += y.weight[j] * x.weight[i];
        }
    }
    return grid;
}

std::size_t wrap(int frequency, std::size_t size) {
    return static_cast<std::size_t>(frequency) & (size - 1);
}

} // namespace

FourierSums fourier_sums(std::span<const Vec2> points, int reach_x, int reach_y) {
    FourierSums sums{reach_x, reach_y, {}};
    const std::size_t width = sums.width();
    const std::size_t columns = grid_size(reach_x);
    const std::size_t rows = grid_size(reach_y);
    // The transformed rows; only needed frequencies are kept.
    std::vector<Complex> middle(width * rows);
    {
        const std::vector<double> grid = spread_grid(points, columns, rows);
        const FastFourier transform(columns);
        parallel_for(rows, 8, [&](std::size_t y) {
            const double* row = &grid[y * columns];
            std::vector<Complex> line(row, row + columns);
            transform(line);
            for (int x = -reach_x; x <= reach_x; ++x)
                middle[y * width + std::size_t(reach_x + x)] = line[wrap(x, columns)];
        });
    }
    std::vector<double> inverse_y(std::size_t(reach_y) + 1);
    for (int y = 0; y <= reach_y; ++y)
        inverse_y[std::size_t(y)] = 1 / kernel_transform(double(y) / double(rows));
    sums.values.resize(width * (std::size_t(reach_y) + 1));
    const FastFourier transform(rows);
    parallel_for(width, 8, [&](std::size_t x) {
        std::vector<Complex> line(rows);
        for (std::size_t y = 0; y < rows; ++y)
            line[y] = middle[y * width + x];
        transform(line);
        const double inverse_x =
            1 / kernel_transform((double(x) - double(reach_x)) / double(columns));
        for (std::size_t y = 0; y <= std::size_t(reach_y); ++y)
            sums.values[y * width + x] = line[y] * (inverse_x * inverse_y[y]);
    });
    return sums;
}

} // namespace scree
