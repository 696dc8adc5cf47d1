// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "generators/layout/domain_test.h"

namespace scree {

enum class Selection {
    cyclic,  // each trial takes the next component (Sakurai & Miyata 2014, section 3.2)
    weighted // at random in proportion to the weights
};

/// What every method of placing elements is given.
struct LayoutProblem {
    std::vector<CollisionShape> shapes{}; // one per component
    std::vector<double> weights{};        // one per component, >= 0, sum > 0
    Selection selection = Selection::cyclic;
    DomainTest domain;
    Range rotation{0, 2 * pi}; // [rad]
    Range scale{1, 1};
    std::uint64_t seed = 0;
    std::size_t max_count = std::numeric_limits<std::size_t>::max();

    /// What elements keep from each other and from the domain's border so that they are apart even
    /// where positions are float, as in an instance's matrix [m].
    double clearance() const;

    double largest_radius() const; // of all circumscribed circles at the largest scale [m]
    double smallest_radius() const;
};

/// One trial: which component, how turned and scaled, and where.
struct Dart {
    std::uint32_t component = 0;
    Pose pose;
};

/// The trial of this number, with its position drawn uniformly from the domain: a pure function of
/// the seed and the number.
Dart throw_dart(const LayoutProblem& problem, std::uint64_t trial);

/// The same component, angle and scale as `throw_dart`, but at a given place.
Dart throw_dart_at(const LayoutProblem& problem, std::uint64_t trial, const Vec2& position);

/// Throws Error when a component certainly cannot lie whole in the domain at its smallest scale, at
/// any allowed angle; `component` receives its index. The message gives both sizes.
void check_fits(const LayoutProblem& problem, std::size_t component, const std::string& name);

} // namespace scree
