// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/power_diagram.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

constexpr int most_steps = 60;
constexpr int most_halvings = 30;
constexpr int most_solver_steps = 500;
constexpr double solved_to = 1e-5; // of the residual

/// The Hessian of the areas: da_i / dw_j = -|e_ij| / (2 |x_i - x_j|) for neighbours, and rows that
/// add up to 0. Fixed up to a constant, which areas do not depend on.
class Stiffness {
  public:
    Stiffness(std::span<const Vec2> sites, const std::vector<PowerCell>& cells)
        : diagonal_(sites.size(), 0.0) {
        for (std::size_t i = 0; i < cells.size(); ++i)
            for (std::size_t k = 0; k < cells[i].ring.size(); ++k) {
                const std::int32_t beyond = cells[i].beyond[k];
                if (beyond <= static_cast<std::int32_t>(i)) // the border, or seen from there
                    continue;
                const auto j = static_cast<std::size_t>(beyond);
                const Ring& ring = cells[i].ring;
                const double length = (ring[(k + 1) % ring.size()] - ring[k]).length();
                const double share = length / (2 * (sites[i] - sites[j]).length());
                links_.push_back({i, j, share});
                diagonal_[i] += share;
                diagonal_[j] += share;
            }
        // So that a cell without neighbours does not divide by 0.
        const double most = *std::max_element(diagonal_.begin(), diagonal_.end());
        for (double& d : diagonal_)
            d = std::max(d, 1e-12 * most);
    }

    /// Conjugate gradients with the diagonal as preconditioner.
    std::vector<double> solve(std::vector<double> residual) const {
        const std::size_t n = residual.size();
        std::vector<double> x(n, 0.0);
        std::vector<double> z = divided(residual);
        std::vector<double> direction = z;
        std::vector<double> image(n);
        double rz = dot(residual, z);
        const double enough = solved_to * solved_to * rz;
        for (int step = 0; step < most_solver_steps && rz > enough; ++step) {
            apply(direction, image);
            const double along = rz / dot(direction, image);
            for (std::size_t i = 0; i < n; ++i) {
                x[i] += along * direction[i];
                residual[i] -= along * image[i];
            }
            z = divided(residual);
            const double next = dot(residual, z);
            for (std::size_t i = 0; i < n; ++i)
                direction[i] = z[i] + next / rz * direction[i];
            rz = next;
        }
        return x;
    }

  private:
    struct Link {
        std::size_t i, j;
        double share;
    };

    void apply(const std::vector<double>& x, std::vector<double>& out) const {
        std::fill(out.begin(), out.end(), 0.0);
        for (const Link& link : links_) {
            const double flow = link.share * (x[link.i] - x[link.j]);
            out[link.i] += flow;
            out[link.j] -= flow;
        }
    }
    std::vector<double> divided(const std::vector<double>& r) const {
        std::vector<double> out(r.size());
        std::transform(r.begin(), r.end(), diagonal_.begin(), out.begin(), std::divides<>());
        return out;
    }
    static double dot(const std::vector<double>& a, const std::vector<double>& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            sum += a[i] * b[i];
        return sum;
    }

    std::vector<Link> links_;
    std::vector<double> diagonal_;
};

struct Residual {
    std::vector<double> missing; // area of each cell [m^2]
    double square = 0;
    double error = 0;
    double smallest = 0; // cell [m^2]
};

Residual residual_of(std::span<const double> areas, const std::vector<PowerCell>& cells) {
    Residual residual;
    residual.smallest = cells.front().area;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double missing = areas[i] - cells[i].area;
        residual.missing.push_back(missing);
        residual.square += missing * missing;
        residual.error = std::max(residual.error, std::abs(missing) / areas[i]);
        residual.smallest = std::min(residual.smallest, cells[i].area);
    }
    return residual;
}

} // namespace

PrescribedAreas cells_of_areas(std::span<const Vec2> sites, std::span<const double> areas,
                               const Ring& domain, double tolerance, std::vector<double> weights) {
    assert(sites.size() == areas.size() && !sites.empty());
    PrescribedAreas found;
    const auto start = [&](std::vector<double> from) {
        found.weights = std::move(from);
        found.cells = power_diagram(sites, found.weights, domain);
    };
    if (weights.empty())
        weights.assign(sites.size(), 0.0);
    start(std::move(weights));
    Residual residual = residual_of(areas, found.cells);
    if (residual.smallest <= 0) { // Voronoi cells always have an area
        start(std::vector<double>(sites.size(), 0.0));
        residual = residual_of(areas, found.cells);
    }
    const double least =
        0.3 * std::min(residual.smallest, *std::min_element(areas.begin(), areas.end()));
    for (; found.steps < most_steps && residual.error > tolerance; ++found.steps) {
        const std::vector<double> step = Stiffness(sites, found.cells).solve(residual.missing);
        bool taken = false;
        double share = 1;
        for (int i = 0; i < most_halvings && !taken; ++i, share /= 2) {
            std::vector<double> next = found.weights;
            for (std::size_t k = 0; k < next.size(); ++k)
                next[k] += share * step[k];
            std::vector<PowerCell> cells = power_diagram(sites, next, domain);
            Residual after = residual_of(areas, cells);
            const double wanted = 1 - share / 2;
            if (after.smallest > least && after.square <= wanted * wanted * residual.square) {
                found.weights = std::move(next);
                found.cells = std::move(cells);
                residual = std::move(after);
                taken = true;
            }
        }
        if (!taken)
            break;
    }
    found.error = residual.error;
    return found;
}

} // namespace scree
