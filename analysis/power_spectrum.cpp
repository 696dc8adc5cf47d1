// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/power_spectrum.h"

#include "analysis/nonuniform_fft.h"
#include "core/parallel.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace scree {

namespace {

using Complex = std::complex<double>;

constexpr int max_reach = 1023; // a grid of 4096 x 4096

double sinc(double x) { return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x; }

// The integral of exp(-i k.x) over the polygon, k != 0, as a sum over its edges by the divergence
// theorem (Lee & Mittra 1983).
Complex polygon_transform(const Region& region, const Vec2& origin, const Vec2& k) {
    Complex sum = 0;
    for (const Ring& ring : region.rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Vec2 edge = ring[i] - ring[j];
            const Vec2 middle = (ring[i] + ring[j]) / 2 - origin;
            sum += cross(k, edge) * sinc(k.dot(edge) / 2) * std::polar(1.0, -k.dot(middle));
        }
    return Complex(0, 1) * sum / k.length2();
}

} // namespace

PowerSpectrum periodogram(std::span<const Vec2> points, const Window& window, double highest) {
    const Box2 box = bounds(*window.domain);
    const Vec2 size = box.size();
    const auto reach = [&](double side) {
        return static_cast<int>(std::clamp(std::floor(highest * side), 1.0, double(max_reach)));
    };
    PowerSpectrum spectrum{{1 / size.x, 1 / size.y}, reach(size.x), reach(size.y), {}};
    spectrum.power.resize(spectrum.width() * (std::size_t(spectrum.reach_y) + 1));
    if (points.empty())
        return spectrum;
    std::vector<Vec2> scaled;
    for (const Vec2& point : points)
        scaled.emplace_back((point.x - box.min.x) / size.x, (point.y - box.min.y) / size.y);
    const FourierSums sums = fourier_sums(scaled, spectrum.reach_x, spectrum.reach_y);
    const double density = double(points.size()) / area(*window.domain);
    parallel_for(std::size_t(spectrum.reach_y) + 1, 1, [&](std::size_t row) {
        for (int x = -spectrum.reach_x; x <= spectrum.reach_x; ++x) {
            const int y = static_cast<int>(row);
            if (x == 0 && y == 0)
                continue;
            Complex sum = sums.at(x, y);
            if (!window.torus) {
                const Vec2 k(2 * pi * x * spectrum.step.x, 2 * pi * y * spectrum.step.y);
                sum -= density * polygon_transform(*window.domain, box.min, k);
            }
            spectrum.power[row * spectrum.width() + std::size_t(spectrum.reach_x + x)] =
                std::norm(sum) / double(points.size());
        }
    });
    return spectrum;
}

PowerSpectrum mean_spectrum(std::span<const PowerSpectrum> spectra) {
    PowerSpectrum mean = spectra.front();
    for (const PowerSpectrum& spectrum : spectra.subspan(1)) {
        assert(spectrum.power.size() == mean.power.size());
        for (std::size_t i = 0; i < mean.power.size(); ++i)
            mean.power[i] += spectrum.power[i];
    }
    for (double& power : mean.power)
        power /= double(spectra.size());
    return mean;
}

RadialSpectrum radial_spectrum(const PowerSpectrum& spectrum, std::size_t max_bins) {
    const double highest =
        std::min(spectrum.reach_x * spectrum.step.x, spectrum.reach_y * spectrum.step.y);
    RadialSpectrum radial;
    radial.bin_width = std::max({spectrum.step.x, spectrum.step.y, highest / double(max_bins)});
    // Complete annuli only: beyond `highest` the corners of the spectrum contain only some
    // directions.
    const auto bins =
        static_cast<std::size_t>(std::max(1.0, std::floor(highest / radial.bin_width)));
    radial.power.resize(bins);
    radial.count.resize(bins);
    std::vector<double> squares(bins);
    for (int pass = 0; pass < 2; ++pass) {
        for (int y = 0; y <= spectrum.reach_y; ++y)
            for (int x = -spectrum.reach_x; x <= spectrum.reach_x; ++x) {
                if (y == 0 && x <= 0)
                    continue; // these mirror the frequencies with x > 0
                const double f = Vec2(x * spectrum.step.x, y * spectrum.step.y).length();
                const auto bin = static_cast<std::size_t>(f / radial.bin_width + 1e-9);
                if (bin >= bins)
                    continue;
                if (pass == 0) {
                    ++radial.count[bin];
                    radial.power[bin] += spectrum.at(x, y);
                } else {
                    const double difference = spectrum.at(x, y) - radial.power[bin];
                    squares[bin] += difference * difference;
                }
            }
        if (pass == 0)
            for (std::size_t k = 0; k < bins; ++k)
                radial.power[k] /= double(std::max<std::size_t>(1, radial.count[k]));
    }
    for (std::size_t k = 0; k < bins; ++k) {
        const bool known = radial.count[k] > 1 && radial.power[k] > 0;
        const double variance = known ? squares[k] / double(radial.count[k] - 1) : 0;
        radial.anisotropy_db.push_back(
            known ? 10 * std::log10(variance / (radial.power[k] * radial.power[k]))
                  : std::numeric_limits<double>::quiet_NaN());
    }
    return radial;
}

} // namespace scree
