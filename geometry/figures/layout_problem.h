// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "geometry/figures/domain_test.h"
#include "geometry/plane/field.h"

#include <limits>

namespace scree {

enum class Selection {
    cyclic,  // each trial takes the next component (Sakurai & Miyata 2014, section 3.2)
    weighted // at random in proportion to the weights
};

/// One trial: which component, how turned and scaled, and where.
struct Dart {
    std::uint32_t component = 0;
    FigurePose pose;
    double margin = 0; // kept free all round, in addition to the shape [m]
};

/// How elements change from place to place; what is null changes nothing.
struct LayoutFields {
    std::shared_ptr<const Field> direction{}; // [deg], added to the angle
    std::shared_ptr<const Field> scale{};     // multiplies the scale
    std::shared_ptr<const Field> density{};   // multiplies the margin
    std::shared_ptr<const Field> classes{};   // rounded: the class that is placed there
};

/// What every method of placing elements is given.
struct LayoutProblem {
    std::vector<CollisionShape> shapes{}; // one per component
    std::vector<double> weights{};        // one per component, >= 0, sum > 0
    std::vector<double> margins{};        // one per component, at scale 1 [m]; empty: none
    std::vector<long> classes{};          // one per component; empty without fields.classes
    Selection selection = Selection::cyclic;
    DomainTest domain;
    LayoutFields fields{};
    Range rotation{0, 2 * pi}; // [rad]
    Range scale{1, 1};
    std::uint64_t seed = 0;
    std::size_t max_count = std::numeric_limits<std::size_t>::max();

    /// Distance of elements from each other and from the domain's border [m], which keeps them
    /// apart even when their positions are rounded to float, as in an instance's matrix.
    double clearance() const;

    /// Of all circumscribed circles at the largest and smallest scale anywhere, margins not
    /// included [m].
    double largest_radius() const;
    double smallest_radius() const;
    double smallest_inner_radius() const; // of the largest inscribed disks [m]
    double largest_margin() const;        // anywhere, at any scale [m]

    /// Bounds of what the fields allow in a box: of the angle's offset [rad], the factor of the
    /// scale and that of the margin.
    Range direction_over(const Box2& box) const;
    Range scale_over(const Box2& box) const;
    Range density_over(const Box2& box) const;

    /// Whether the component may be placed at the point, by its class.
    bool has_class(std::uint32_t component, const Vec2& point) const;

    /// The element of a component at this place; `turn` [rad] and `scale` are what the rotation and
    /// scale ranges gave, to which the fields are applied here.
    Dart dart(std::uint32_t component, const Vec2& position, double turn, double scale) const;
};

/// The trial of this number, with a position drawn uniformly from the domain: a pure function of
/// the seed and the number. None where the classes allow no component.
std::optional<Dart> throw_dart(const LayoutProblem& problem, std::uint64_t trial);

/// The same component, angle and scale as `throw_dart`, but at a given place.
std::optional<Dart> throw_dart_at(const LayoutProblem& problem, std::uint64_t trial,
                                  const Vec2& position);

/// The same, with random numbers from this stream.
std::optional<Dart> throw_dart_at(const LayoutProblem& problem, std::uint64_t trial,
                                  const Vec2& position, Random& random);

/// Throws Error when a component certainly cannot lie whole in the domain at its smallest scale, at
/// any allowed angle; `component` receives its index. The message gives both sizes.
void check_fits(const LayoutProblem& problem, std::size_t component, const std::string& name);

} // namespace scree
