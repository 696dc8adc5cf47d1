// SPDX-License-Identifier: GPL-3.0-or-later
// How a rough dielectric cylinder scatters light (Chiang et al. 2016, "A practical and controllable
// hair and fur model for production path tracing", near field): a sum over the paths through it, p
// = 0 (reflected), 1 (through), 2 (reflected once inside) and 3 (all others), each the product of
// its share of the light, a density along the fibre and one around it. Float for rendering, double
// for tests.
#pragma once

#include "core/math.h"

#include <algorithm>
#include <array>

namespace scree::fibre {

inline constexpr int path_count = 4;

/// exp(-x) I0(x), the modified Bessel function, for x >= 0; within 2e-7 of its value (Abramowitz &
/// Stegun 1964, 9.8.1 and 9.8.2).
template <class Real>
Real scaled_bessel_i0(Real x) {
    const auto polynomial = [](Real t, const auto& factors) {
        Real sum = 0;
        for (std::size_t i = std::size(factors); i-- > 0;)
            sum = sum * t + factors[i];
        return sum;
    };
    constexpr Real split = Real(3.75);
    if (x < split) {
        static constexpr Real low[] = {Real(1),         Real(3.5156229), Real(3.0899424),
                                       Real(1.2067492), Real(0.2659732), Real(0.0360768),
                                       Real(0.0045813)};
        return std::exp(-x) * polynomial(x * x / (split * split), low);
    }
    static constexpr Real high[] = {Real(0.39894228),  Real(0.01328592),  Real(0.00225319),
                                    Real(-0.00157565), Real(0.00916281),  Real(-0.02057706),
                                    Real(0.02635537),  Real(-0.01647633), Real(0.00392377)};
    return polynomial(split / x, high) / std::sqrt(x);
}

/// The angle from the plane square to the fibre, positive towards the tip.
template <class Real>
struct Slope {
    Real sine;
    Real cosine; // >= 0
};

/// From where a fibre is seen.
template <class Real>
struct View {
    Slope<Real> theta;
    Real gamma;   // azimuth about the axis, from the normal at the point of entry [rad]
    Real gamma_t; // the same of the refracted ray, from the inner normal
    Real fresnel; // share of light reflected at each surface
    Real length;  // of the way from side to side inside [radii]
};

/// The constants of a fibre.
template <class Real>
class Scattering {
  public:
    /// `beta_m`, `beta_n` in (0, 1], `tilt` [rad].
    Scattering(Real beta_m, Real beta_n, Real eta, Real tilt) : eta_(eta) {
        const auto square = [](Real x) { return x * x; };
        const Real v = square(Real(0.726) * beta_m + Real(0.812) * square(beta_m) +
                              Real(3.7) * std::pow(beta_m, Real(20)));
        variance_ = {v, v / 4, 4 * v, 4 * v};
        for (int p = 0; p < path_count; ++p)
            normalisation_[p] = 1 / (variance_[p] * -std::expm1(-2 / variance_[p]));
        width_ = std::sqrt(Real(pi) / 8) * (Real(0.265) * beta_n + Real(1.194) * square(beta_n) +
                                            Real(5.372) * std::pow(beta_n, Real(22)));
        trim_ = std::tanh(Real(pi) / (2 * width_));
        const Real tilts[] = {2 * tilt, -tilt, -4 * tilt, 0};
        for (int p = 0; p < path_count; ++p)
            tilt_[p] = {std::sin(tilts[p]), std::cos(tilts[p])};
    }

    /// Seen along a direction with the parts `along` the fibre, `across` it and along the `normal`
    /// (> 0) at the point of entry.
    View<Real> view(Real along, Real across, Real normal) const {
        const Real cosine = std::sqrt(across * across + normal * normal);
        const Real inner = std::sqrt(eta_ * eta_ - along * along); // eta cos(theta_t)
        // Snell's law in the plane square to the fibre, with Bravais's index inner / cosine.
        const Real sine_t = across / inner;
        return {{along, cosine},
                std::atan2(across, normal),
                std::asin(sine_t),
                reflectance(normal),
                2 * std::sqrt(1 - sine_t * sine_t) * eta_ / inner};
    }

    /// The share of the light that takes each path, of which `transmittance` is left between two
    /// surfaces; together 1 where that is 1.
    static std::array<Real, path_count> shares(const View<Real>& view, Real transmittance) {
        const Real f = view.fresnel;
        const Real inside = transmittance * f;
        const Real through = (1 - f) * (1 - f) * transmittance;
        const Real twice = through * inside;
        return {f, through, twice, inside < 1 ? twice * inside / (1 - inside) : Real(0)};
    }

    /// The density along the fibre, per sine of the slope (d'Eon et al. 2011, "An energy-conserving
    /// hair reflectance model", eq. 7). There, exp and I0 overflow for smooth fibres; here they are
    /// taken together.
    Real along(int p, const Slope<Real>& seen, const Slope<Real>& to) const {
        const Slope<Real> from = tilted(p, seen);
        const Real v = variance_[p];
        const Real sines = from.sine + to.sine;
        const Real cosines = from.cosine - to.cosine;
        return normalisation_[p] * std::exp((sines * sines + cosines * cosines) / (-2 * v)) *
               scaled_bessel_i0(from.cosine * to.cosine / v);
    }

    /// The sine of a slope with that density; u1, u2 uniform in [0, 1) (d'Eon et al. 2013,
    /// "Importance sampling for physically-based hair fiber models").
    Real sample_along(int p, const Slope<Real>& seen, Real u1, Real u2) const {
        const Slope<Real> from = tilted(p, seen);
        const Real v = variance_[p];
        const Real u = 1 - u1;                                            // in (0, 1]
        const Real below = -v * std::log(u + (1 - u) * std::exp(-2 / v)); // 1 - the cosine
        const Real sine = std::sqrt(std::max(Real(0), below * (2 - below)));
        return std::clamp((below - 1) * from.sine +
                              sine * from.cosine * std::cos(2 * Real(pi) * u2),
                          Real(-1), Real(1));
    }

    /// The density around the fibre at the azimuth `to` from the normal [1/rad].
    Real around(int p, const View<Real>& view, Real to) const {
        if (p == path_count - 1)
            return 1 / (2 * Real(pi));
        const Real e = std::exp(-std::abs(wrapped(to - exit(p, view))) / width_);
        return e / (width_ * (1 + e) * (1 + e) * trim_);
    }

    /// An azimuth with that density; u uniform in [0, 1).
    Real sample_around(int p, const View<Real>& view, Real u) const {
        const Real centred = 2 * u - 1; // in [-1, 1)
        if (p == path_count - 1)
            return Real(pi) * centred;
        const Real logistic = centred * trim_;
        const Real away = width_ * std::log((1 + logistic) / (1 - logistic));
        return exit(p, view) + std::clamp(away, -Real(pi), Real(pi));
    }

  private:
    // Fresnel 1823.
    Real reflectance(Real cosine) const {
        const Real other = std::sqrt(std::max(Real(0), eta_ * eta_ - 1 + cosine * cosine)) / eta_;
        const Real parallel = (eta_ * cosine - other) / (eta_ * cosine + other);
        const Real perpendicular = (cosine - eta_ * other) / (cosine + eta_ * other);
        return (parallel * parallel + perpendicular * perpendicular) / 2;
    }

    // The scales of a hair lean its normals towards the root, so that light is reflected as if seen
    // from further towards the tip.
    Slope<Real> tilted(int p, const Slope<Real>& seen) const {
        const Slope<Real>& by = tilt_[p];
        return {seen.sine * by.cosine + seen.cosine * by.sine,
                std::abs(seen.cosine * by.cosine - seen.sine * by.sine)};
    }

    // The azimuth at which the light of a path leaves a smooth fibre, from the normal where it
    // enters.
    static Real exit(int p, const View<Real>& view) {
        return static_cast<Real>(p) * (2 * view.gamma_t + Real(pi)) - view.gamma;
    }

    static Real wrapped(Real angle) { return std::remainder(angle, 2 * Real(pi)); }

    Real eta_;
    std::array<Real, path_count> variance_;      // along the fibre
    std::array<Real, path_count> normalisation_; // of the density along it
    std::array<Slope<Real>, path_count> tilt_;
    Real width_; // of the logistic distribution around the fibre [rad]
    Real trim_;  // its share within half a turn to both sides
};

} // namespace scree::fibre
