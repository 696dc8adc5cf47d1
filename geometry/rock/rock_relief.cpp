// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/rock/rock_relief.h"

#include "geometry/rock/solid_noise.h"

#include <algorithm>

namespace scree {

namespace {

// Frequencies are waves in half of the longest axis.
constexpr double beds_apart = 1.0 / 9;
constexpr double coarsest_faces = 2.3;
constexpr double coarsest_roughness = 2.6;
constexpr int roughness_octaves = 12;

double smooth_step(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// How much of a wave is kept: none at `shortest`, all at twice its length.
double kept(double wavelength, double shortest) {
    return std::clamp(wavelength / shortest - 1, 0.0, 1.0);
}

} // namespace

RockRelief::RockRelief(const RockSettings& settings, const std::array<WideVec3, 3>& joints,
                       Random& random)
    : settings_(settings), fresh_(std::pow(1 - 0.92 * settings.wear, 1.5)), noise_(random.bits()),
      bedding_((WideVec3(0, 0, 1) + 0.15 * normal_vector(random)).normalized()) {
    for (int i = 0; i < settings.cracks; ++i) {
        const WideVec3 normal = joints[std::size_t(i % 3)] + 0.2 * normal_vector(random);
        const double offset = random.uniform(-0.4, 0.4);
        const double width = random.uniform(0.008, 0.02);
        cracks_.push_back({normal.normalized(), offset, width, random.uniform(0.03, 0.10)});
    }
}

double RockRelief::beds(const WideVec3& place, double shortest) const {
    if (!(settings_.strata > 0))
        return 0;
    const double layer =
        (bedding_ ^ place) / beds_apart + 0.6 * gradient_noise(2.0 * place, noise_ + 40);
    const double lower = std::floor(layer);
    const auto height = [&](int i) {
        return (lattice_hash(i, 7, 3, noise_) & 1023U) / 1023.0 - 0.5;
    };
    const int i = static_cast<int>(lower);
    const double t = smooth_step((layer - lower - 0.8) / 0.2); // most of a bed is level
    return settings_.strata * 0.11 * kept(beds_apart, shortest) * mix(height(i), height(i + 1), t);
}

double RockRelief::broken_faces(const WideVec3& place, double shortest) const {
    double height = 0;
    double amplitude = settings_.hackle * fresh_;
    double frequency = coarsest_faces;
    for (std::uint32_t octave = 0; octave < 3 && amplitude > 0; ++octave) {
        const double share = kept(1 / frequency, shortest);
        if (share <= 0)
            break;
        const WideVec3 bent =
            frequency * place + 0.25 * vector_noise(1.7 * frequency * place, noise_ + 60 + octave);
        height += amplitude * share * faceted_noise(bent, noise_ + 70 + octave);
        amplitude *= 0.48;
        frequency *= 2.3;
    }
    return height;
}

double RockRelief::roughness(const WideVec3& place, double shortest) const {
    double sum = 0;
    double amplitude = settings_.rough * (0.35 + 0.65 * fresh_);
    double frequency = coarsest_roughness;
    for (std::uint32_t octave = 0; octave < roughness_octaves && amplitude > 0; ++octave) {
        const double share = kept(1 / frequency, shortest);
        if (share <= 0)
            break;
        sum += amplitude * share * gradient_noise(frequency * place, noise_ + 100 + octave);
        amplitude *= std::pow(2.0, -settings_.hurst);
        frequency *= 2;
    }
    if (sum == 0)
        return 0;
    // Some places are smoother than others.
    const double here = std::clamp(gradient_noise(1.6 * place, noise_ + 90) + 0.5, 0.0, 1.0);
    return sum * (0.45 + 1.1 * here);
}

double RockRelief::cracked(const WideVec3& place, double shortest) const {
    double height = 0;
    for (const Crack& crack : cracks_) {
        const double away = (crack.normal ^ place) - crack.offset +
                            0.05 * gradient_noise(4.0 * place, noise_ + 30) +
                            0.015 * gradient_noise(13.0 * place, noise_ + 31);
        // A crack that is narrower than two edges of the mesh is drawn as wide, and less deep.
        const double width = std::max(crack.width, 0.5 * shortest);
        const double open = std::clamp(
            3 * gradient_noise(1.7 * place + 5.0 * crack.normal, noise_ + 33) + 0.6, 0.0, 1.0);
        height -=
            crack.depth * (crack.width / width) * open * std::exp(-away * away / (width * width));
    }
    return height;
}

double RockRelief::height(const WideVec3& place, double shortest) const {
    return beds(place, shortest) + broken_faces(place, shortest) + roughness(place, shortest) +
           cracked(place, shortest);
}

} // namespace scree
