// SPDX-License-Identifier: GPL-3.0-or-later
// Problems for the tests of the Poisson-disk sampler: the four modes of Kita & Miyata 2012,
// figure 2.
#pragma once

#include "geometry/plane/region_shapes.h"
#include "geometry/plane/region_tools.h"
#include "geometry/sampling/poisson_disk.h"
#include "shapes/field/plain_fields.h"

#include <algorithm>
#include <string>

namespace scree::tests {

inline std::shared_ptr<const Region> shared_region(std::vector<Ring> rings) {
    return std::make_shared<const Region>(triangulate(std::move(rings)));
}

inline std::shared_ptr<const Region> square_domain(double side) {
    return shared_region({rectangle_ring(side, side)});
}

/// An L-shaped domain of 1 m with a round hole, rotated and away from the origin.
inline std::shared_ptr<const Region> pierced_domain() {
    Ring corner = l_ring(1, 0.6);
    Ring hole = circle_ring(0.12, 20);
    for (Vec2& v : corner)
        v = rotate(v, 0.2) + Vec2(0.8, -0.15);
    for (Vec2& v : hole)
        v = rotate(v + Vec2(-0.2, -0.2), 0.2) + Vec2(0.8, -0.15);
    return shared_region({corner, hole});
}

enum class Mode { isotropic, anisotropic, multi_class, anisotropic_multi_class };

inline std::vector<Mode> all_modes() {
    return {Mode::isotropic, Mode::anisotropic, Mode::multi_class, Mode::anisotropic_multi_class};
}

inline std::string name_of(Mode mode) {
    static const char* const names[] = {"isotropic", "anisotropic", "multi_class",
                                        "anisotropic_multi_class"};
    return names[static_cast<int>(mode)];
}

/// Classes with axes of about `size` [m].
inline std::vector<DiskClass> classes_of(Mode mode, double size) {
    switch (mode) {
    case Mode::isotropic:
        return {{size, size}};
    case Mode::anisotropic:
        return {{1.6 * size, 0.6 * size}};
    case Mode::multi_class:
        return {{1.6 * size, 1.6 * size}, {size, size}, {2.5 * size, 2.5 * size}, {size, size}};
    default:
        return {{2.4 * size, 1.2 * size}, {1.5 * size, 0.5 * size}, {size, size}};
    }
}

inline bool is_round(Mode mode) { return mode == Mode::isotropic || mode == Mode::multi_class; }

/// Ellipses are oriented by a whirl about the centre of the domain.
inline PoissonDiskProblem problem_of(Mode mode, std::shared_ptr<const Region> domain, double size,
                                     std::uint64_t seed) {
    PoissonDiskProblem problem;
    problem.classes = classes_of(mode, size);
    problem.seed = seed;
    if (!is_round(mode))
        problem.direction = std::make_shared<WhirlField>(bounds(*domain).center(), 70);
    problem.domain = std::move(domain);
    return problem;
}

} // namespace scree::tests
