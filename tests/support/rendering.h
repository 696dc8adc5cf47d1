// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes and statistics shared by the renderer's tests.
#pragma once

#include "core/random.h"
#include "render/render.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace scree::test {

inline Mesh make_sphere(float radius, int rows, bool smooth = true) {
    Mesh mesh;
    mesh.name = "sphere";
    const int columns = 2 * rows;
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c) {
            const double polar = pi * r / rows;
            const double turn = 2 * pi * (c % columns) / columns;
            const Vec3 n(static_cast<float>(std::sin(polar) * std::cos(turn)),
                         static_cast<float>(std::cos(polar)),
                         static_cast<float>(std::sin(polar) * std::sin(turn)));
            mesh.positions.push_back(n * radius);
            if (smooth)
                mesh.normals.push_back(n);
        }
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const auto a = static_cast<std::uint32_t>(r * (columns + 1) + c);
            const std::uint32_t b = a + 1;
            const auto d = a + static_cast<std::uint32_t>(columns) + 1;
            if (r > 0)
                mesh.triangles.push_back({a, b, d});
            if (r < rows - 1)
                mesh.triangles.push_back({b, d + 1, d});
        }
    return mesh;
}

/// A square in the plane y = 0 that faces up.
inline Mesh make_plane(float size) {
    const float h = size / 2;
    Mesh mesh;
    mesh.name = "plane";
    mesh.positions = {{-h, 0.0F, -h}, {-h, 0.0F, h}, {h, 0.0F, h}, {h, 0.0F, -h}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

inline Vec3 random_direction(Random& random) {
    for (;;) {
        const Vec3 v(static_cast<float>(random.uniform(-1, 1)),
                     static_cast<float>(random.uniform(-1, 1)),
                     static_cast<float>(random.uniform(-1, 1)));
        if (v.length() > 0.1F && v.length() < 1)
            return v.normalized();
    }
}

inline Matrix move(const Vec3& by) {
    Matrix m;
    m.setTranslation(by);
    return m;
}

inline MaterialSet material_set(const std::vector<Material>& materials) {
    std::vector<std::shared_ptr<const Material>> shared;
    for (const Material& material : materials)
        shared.push_back(std::make_shared<const Material>(material));
    return MaterialSet(shared);
}

/// A scene that tests build step by step and render.
struct Stage {
    std::vector<Aggregate> aggregates;
    std::vector<Light> lights;
    Camera camera;
    FilmSettings film;

    void add(const Mesh& mesh, const Material& material, const Matrix& matrix = {}) {
        Aggregate aggregate;
        aggregate.generator = "object";
        Prototype prototype;
        prototype.shape = std::make_shared<Mesh>(mesh);
        prototype.materials = {std::make_shared<const Material>(material)};
        aggregate.prototypes.push_back(prototype);
        Instance instance;
        instance.world_from_object = WideMatrix(matrix);
        aggregate.instances.push_back(instance);
        aggregates.push_back(aggregate);
    }
    RenderResult render(const RenderOptions& options = {}) const {
        const World world(aggregates, lights);
        return scree::render(world, camera, film, options);
    }
};

inline Matte grey_matte(float v) { return {{{Color(v, v, v), nullptr}, {}}}; }
inline Sky even_sky(float v) {
    Sky sky;
    sky.strength = v;
    return sky;
}

/// Two-sided quantile of the standard normal distribution that any of `count` independent values
/// exceeds with probability `alpha` (Sidak 1967), by bisection of erfc.
inline double sidak_quantile(double alpha, double count) {
    const double each = -std::expm1(std::log1p(-alpha) / count);
    double low = 0;
    double high = 40;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (std::erfc(middle / std::sqrt(2.0)) > each ? low : high) = middle;
    }
    return high;
}

/// Upper quantile of the chi-square distribution by Wilson & Hilferty (1931); accurate for 10 and
/// more degrees of freedom.
inline double chi_square_quantile(double degrees, double alpha) {
    const double z = sidak_quantile(2 * alpha, 1);
    const double a = 2 / (9 * degrees);
    return degrees * std::pow(1 - a + z * std::sqrt(a), 3);
}

/// Pearson's chi-square test of counts; cells with an expectation below 5 are pooled. Returns a
/// message, empty when the test passes.
inline std::string chi_square(const std::vector<double>& observed,
                              const std::vector<double>& expected, double alpha) {
    double pooled_observed = 0;
    double pooled_expected = 0;
    double statistic = 0;
    int cells = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (expected[i] < 5) {
            pooled_observed += observed[i];
            pooled_expected += expected[i];
            continue;
        }
        statistic += (observed[i] - expected[i]) * (observed[i] - expected[i]) / expected[i];
        ++cells;
    }
    if (pooled_expected >= 5) {
        const double d = pooled_observed - pooled_expected;
        statistic += d * d / pooled_expected;
        ++cells;
    } else if (pooled_observed > 25) {
        return "samples where none are expected: " + std::to_string(pooled_observed);
    }
    const double limit = chi_square_quantile(std::max(1, cells - 1), alpha);
    if (statistic <= limit)
        return "";
    return "chi-square " + std::to_string(statistic) + " over " + std::to_string(limit) + " with " +
           std::to_string(cells) + " cells";
}

} // namespace scree::test
