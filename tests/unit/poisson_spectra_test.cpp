// SPDX-License-Identifier: GPL-3.0-or-later
// Poisson-disk sets are blue noise: little power below half the frequency of the first peak, and no
// preferred direction.
#include "analysis/power_spectrum.h"
#include "tests/support/disk_problems.h"

#include <gtest/gtest.h>

namespace scree::tests {
namespace {

constexpr int sets = 10;

struct Spectrum {
    RadialSpectrum radial;
    double spacing = 0; // mean [m]
};

/// Of points of one class, or of all for a negative one, averaged over ten sets on the unit torus
/// and up to three frequencies per mean spacing.
Spectrum spectrum_of(const std::vector<std::vector<DiskSample>>& all, int disk_class,
                     const Vec2& stretch = Vec2(1, 1)) {
    const Window window{shared_region({rectangle_ring(stretch.x, stretch.y)}), true};
    std::vector<std::vector<Vec2>> points;
    double count = 0;
    for (const auto& samples : all) {
        points.emplace_back();
        for (const DiskSample& s : samples)
            if (disk_class < 0 || s.disk_class == static_cast<std::uint32_t>(disk_class))
                points.back().push_back(s.position * stretch);
        count += double(points.back().size()) / sets;
    }
    Spectrum out;
    out.spacing = std::sqrt(stretch.x * stretch.y / count);
    std::vector<PowerSpectrum> spectra;
    for (const auto& set : points)
        spectra.push_back(periodogram(set, window, 3 / out.spacing));
    out.radial = radial_spectrum(mean_spectrum(spectra));
    return out;
}

std::vector<std::vector<DiskSample>> ten_sets(PoissonDiskProblem problem) {
    problem.torus = true;
    std::vector<std::vector<DiskSample>> out;
    for (std::uint64_t seed = 0; seed < sets; ++seed) {
        problem.seed = seed;
        out.push_back(sample_poisson_disks(problem, {}).samples);
    }
    return out;
}

/// Mean power over frequencies [1 / mean spacing]; each annulus counts by its number of
/// frequencies.
double mean_power(const Spectrum& spectrum, double low, double high) {
    double sum = 0;
    double count = 0;
    for (std::size_t k = 0; k < spectrum.radial.power.size(); ++k) {
        const double f = (double(k) + 0.5) * spectrum.radial.bin_width * spectrum.spacing;
        if (f >= low && f < high) {
            sum += spectrum.radial.power[k] * double(spectrum.radial.count[k]);
            count += double(spectrum.radial.count[k]);
        }
    }
    return sum / count;
}

/// The middle of the frequencies whose power is within 5% of the highest: more stable than the
/// highest itself.
double first_peak(const Spectrum& spectrum) {
    const double highest = *std::ranges::max_element(spectrum.radial.power);
    double sum = 0;
    double count = 0;
    for (std::size_t k = 0; k < spectrum.radial.power.size(); ++k)
        if (spectrum.radial.power[k] > 0.95 * highest) {
            sum += (double(k) + 0.5) * spectrum.radial.bin_width * spectrum.spacing;
            ++count;
        }
    return sum / count;
}

/// The power at one frequency, averaged over K periodograms, is distributed as a gamma variable of
/// shape K: its variance over its squared mean is 1 / K, and that of n frequencies is known to
/// sqrt((2 + 6 / K) / n) of itself.
void expect_flat_anisotropy(const Spectrum& spectrum) {
    double sum = 0;
    double count = 0;
    for (std::size_t k = 0; k < spectrum.radial.power.size(); ++k) {
        const double n = double(spectrum.radial.count[k]);
        if (n < 20) // the estimate is then far from normally distributed
            continue;
        const double ratio = sets * std::pow(10, spectrum.radial.anisotropy_db[k] / 10);
        // 0.15: the power changes over the width of an annulus.
        EXPECT_NEAR(ratio, 1, 5 * std::sqrt((2 + 6.0 / sets) / n) + 0.15) << k;
        sum += ratio * n;
        count += n;
    }
    EXPECT_NEAR(sum / count, 1, 4 * std::sqrt((2 + 6.0 / sets) / count) + 0.02);
}

/// Of all annuli [dB].
double mean_anisotropy(const Spectrum& spectrum) {
    double sum = 0;
    double count = 0;
    for (std::size_t k = 0; k < spectrum.radial.power.size(); ++k) {
        const double n = double(spectrum.radial.count[k]);
        if (n < 20)
            continue;
        sum += std::pow(10, spectrum.radial.anisotropy_db[k] / 10) * n;
        count += n;
    }
    return 10 * std::log10(sum / count);
}

/// Low power at low frequencies, as a share of the plateau at high ones.
double low_power(const Spectrum& spectrum) {
    return mean_power(spectrum, 0, first_peak(spectrum) / 2) / mean_power(spectrum, 1.6, 3);
}

TEST(PoissonSpectra, OfDisksAreBlueAndFlat) {
    const Spectrum spectrum =
        spectrum_of(ten_sets(problem_of(Mode::isotropic, square_domain(1), 0.02, 0)), -1);
    RecordProperty("peak", std::to_string(first_peak(spectrum)));
    RecordProperty("low_power", std::to_string(low_power(spectrum)));
    EXPECT_NEAR(mean_power(spectrum, 1.6, 3), 1, 0.05);
    EXPECT_NEAR(first_peak(spectrum), 1.1, 0.15);
    EXPECT_LT(low_power(spectrum), 0.1);
    expect_flat_anisotropy(spectrum);
}

TEST(PoissonSpectra, OfEllipsesOfOneDirectionAreThoseOfDisksWhenStretched) {
    PoissonDiskProblem problem = problem_of(Mode::anisotropic, square_domain(1), 0.02, 0);
    problem.direction = nullptr;
    const DiskClass axes = problem.classes[0];
    const Spectrum spectrum = spectrum_of(ten_sets(problem), -1, {1, axes.length / axes.width});
    EXPECT_LT(low_power(spectrum), 0.1);
    expect_flat_anisotropy(spectrum);
}

TEST(PoissonSpectra, OfClassesAreBlueEachAndTogether) {
    PoissonDiskProblem problem = problem_of(Mode::multi_class, square_domain(1), 0.02, 0);
    for (const int relax : {0, 50}) {
        problem.relax = relax;
        const auto all = ten_sets(problem);
        for (int k = -1; k < 4; ++k) {
            const Spectrum spectrum = spectrum_of(all, k);
            const std::string name = std::to_string(relax) + "_" + std::to_string(k);
            RecordProperty("low_power_" + name, std::to_string(low_power(spectrum)));
            // Without relaxation the classes disturb each other: 0.13 to 0.26, where a single class
            // has 0.07.
            EXPECT_LT(low_power(spectrum), relax > 0 ? 0.1 : 0.3) << name;
            EXPECT_GT(first_peak(spectrum), 0.9) << name;
            if (relax == 0)
                expect_flat_anisotropy(spectrum);
            else // a little order remains of the few neighbours in the torus
                EXPECT_LT(std::abs(mean_anisotropy(spectrum) + 10), 1) << name;
        }
    }
}

} // namespace
} // namespace scree::tests
