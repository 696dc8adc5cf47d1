// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/strand_spline.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <initializer_list>
#include <limits>
#include <utility>

namespace scree {

namespace {

using Knot = std::array<double, 4>; // position and radius

// The sum of knots times weights.
Knot mix(std::initializer_list<std::pair<double, const Knot*>> terms) {
    Knot out{};
    for (const auto& [weight, knot] : terms)
        for (std::size_t k = 0; k < 4; ++k)
            out[k] += weight * (*knot)[k];
    return out;
}

// The control points c of the spline through the knots q: c[i], c[i + 1] and c[i + 2] give q[i]
// with the weights 1/6, 4/6 and 1/6. That the first piece is a parabola, c[3] - 3 c[2] + 3 c[1] -
// c[0] = 0, makes c[1] - c[2] = q[0] - q[1], and so at the other end. By elimination (Thomas 1949).
std::vector<Knot> control_of(const std::vector<Knot>& q) {
    const std::size_t n = q.size() - 1;
    std::vector<Knot> c(n + 3);
    if (n == 1)
        return {mix({{2, &q[0]}, {-1, &q[1]}}), q[0], q[1], mix({{2, &q[1]}, {-1, &q[0]}})};
    std::vector<double> factor(n + 3, 0.0);
    for (std::size_t i = 2; i <= n; ++i) {
        double pivot = 4 - factor[i - 1];
        c[i] = mix({{6, &q[i - 1]}, {-1, &c[i - 1]}});
        if (i == 2) {
            ++pivot;
            c[i] = mix({{7, &q[1]}, {-1, &q[0]}});
        }
        if (i == n) {
            ++pivot;
            c[i] = mix({{1, &c[i]}, {1, &q[n - 1]}, {-1, &q[n]}});
        }
        factor[i] = 1 / pivot;
        for (double& part : c[i])
            part /= pivot;
    }
    for (std::size_t i = n; i-- > 2;)
        c[i] = mix({{1, &c[i]}, {-factor[i], &c[i + 1]}});
    c[1] = mix({{1, &c[2]}, {1, &q[0]}, {-1, &q[1]}});
    c[n + 1] = mix({{1, &c[n]}, {1, &q[n]}, {-1, &q[n - 1]}});
    c[0] = mix({{3, &c[1]}, {-3, &c[2]}, {1, &c[3]}});
    c[n + 2] = mix({{3, &c[n + 1]}, {-3, &c[n]}, {1, &c[n - 1]}});
    return c;
}

void set(Strands& strands, std::size_t point, const Knot& control) {
    strands.points[point] = Vec3(static_cast<float>(control[0]), static_cast<float>(control[1]),
                                 static_cast<float>(control[2]));
    strands.radii[point] = static_cast<float>(std::max(0.0, control[3]));
}

Knot knot_of(const Vec3& p, float radius) {
    return {double(p.x), double(p.y), double(p.z), double(radius)};
}

/// The vertices of a chain and the smooth curve through them (Catmull & Rom 1974), on which a
/// spline of evenly spaced knots lies nearer to all of them than one through every third of them.
class Chain {
  public:
    Chain(const Strands& chains, std::size_t strand)
        : chains_(chains), begin_(chains.offsets[strand]),
          segments_(chains.offsets[strand + 1] - begin_ - 1) {}

    std::size_t segments() const { return segments_; }

    /// `position` counts segments.
    Knot at(double position) const {
        const auto i = std::min(static_cast<std::size_t>(position), segments_ - 1);
        const double f = position - double(i);
        const Knot b = vertex(i);
        const Knot c = vertex(i + 1);
        if (segments_ == 1)
            return mix({{1 - f, &b}, {f, &c}});
        const Knot a = i > 0 ? vertex(i - 1) : beyond(b, c, vertex(i + 2));
        const Knot d = i + 2 <= segments_ ? vertex(i + 2) : beyond(c, b, a);
        return mix({{0.5 * f * (-1 + f * (2 - f)), &a},
                    {1 + 0.5 * f * f * (-5 + 3 * f), &b},
                    {0.5 * f * (1 + f * (4 - 3 * f)), &c},
                    {0.5 * f * f * (f - 1), &d}});
    }

  private:
    Knot vertex(std::size_t i) const {
        return knot_of(chains_.points[begin_ + i], chains_.radii[begin_ + i]);
    }
    // Where the parabola through three vertices goes on before the first of them.
    static Knot beyond(const Knot& first, const Knot& second, const Knot& third) {
        return mix({{3, &first}, {-3, &second}, {1, &third}});
    }

    const Strands& chains_;
    std::size_t begin_;
    std::size_t segments_;
};

/// Pieces of the spline of a chain.
std::size_t piece_count(std::size_t segments, int step) {
    return (segments + std::size_t(step) - 1) / std::size_t(step);
}

double distance_to_piece(const Vec3* control, const Vec3& p) {
    // A piece bends little: the nearest of a few points, then of some between its neighbours.
    constexpr int fine = 8;
    double low = 0;
    double high = 1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 4; ++round) {
        int best = 0;
        const double step = (high - low) / fine;
        for (int i = 0; i <= fine; ++i) {
            const auto u = static_cast<float>(low + i * step);
            const double distance = double((spline_point(control, u) - p).length());
            if (distance < nearest) {
                nearest = distance;
                best = i;
            }
        }
        const double middle = low + best * step;
        low = std::max(0.0, middle - step);
        high = std::min(1.0, middle + step);
    }
    return nearest;
}

} // namespace

Vec3 spline_point(const Vec3* control, float u) {
    const float v = 1 - u;
    return (control[0] * (v * v * v) + control[1] * (4 - 6 * u * u + 3 * u * u * u) +
            control[2] * (4 - 6 * v * v + 3 * v * v * v) + control[3] * (u * u * u)) /
           6.0F;
}

void add_spline(Strands& strands, std::span<const Vec3> points, std::span<const float> radii) {
    assert(points.size() == radii.size());
    std::vector<Knot> knots(points.size());
    for (std::size_t i = 0; i < knots.size(); ++i)
        knots[i] = knot_of(points[i], radii[i]);
    assert(knots.size() >= 2 && strands.kind == CurveKind::bspline);
    if (strands.offsets.empty())
        strands.offsets.push_back(0);
    for (const Knot& control : control_of(knots)) {
        strands.points.emplace_back();
        strands.radii.emplace_back();
        set(strands, strands.points.size() - 1, control);
    }
    strands.offsets.push_back(static_cast<std::uint32_t>(strands.points.size()));
}

Strands splined(const Strands& chains, int step) {
    assert(chains.kind == CurveKind::linear && step >= 1);
    Strands out;
    out.name = chains.name;
    out.kind = CurveKind::bspline;
    out.randoms = chains.randoms;
    out.normals = chains.normals;
    out.offsets.assign(1, 0);
    for (std::size_t strand = 0; strand < chains.count(); ++strand) {
        const std::size_t segments = chains.offsets[strand + 1] - chains.offsets[strand] - 1;
        out.offsets.push_back(out.offsets.back() +
                              static_cast<std::uint32_t>(piece_count(segments, step) + 3));
    }
    out.points.resize(out.offsets.back());
    out.radii.resize(out.offsets.back());
    parallel_for(chains.count(), 64, [&](std::size_t strand) {
        const Chain chain(chains, strand);
        const std::size_t pieces = piece_count(chain.segments(), step);
        std::vector<Knot> knots(pieces + 1);
        for (std::size_t i = 0; i <= pieces; ++i)
            knots[i] = chain.at(double(i) * double(chain.segments()) / double(pieces));
        std::size_t point = out.offsets[strand];
        for (const Knot& control : control_of(knots))
            set(out, point++, control);
    });
    return out;
}

double spline_deviation(const Strands& chains, const Strands& splines) {
    assert(chains.count() == splines.count());
    std::vector<double> most(chains.count(), 0.0); // of each strand
    parallel_for(chains.count(), 64, [&](std::size_t strand) {
        const std::size_t first = chains.offsets[strand];
        const std::size_t segments = chains.offsets[strand + 1] - first - 1;
        const std::size_t control = splines.offsets[strand];
        const std::size_t pieces = splines.offsets[strand + 1] - control - 3;
        for (std::size_t i = 0; i <= segments; ++i) {
            // Beside the vertex are the piece at the same share of the length and its neighbours.
            const std::size_t middle = std::min(i * pieces / segments, pieces - 1);
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t k = std::max<std::size_t>(middle, 1) - 1;
                 k < std::min(middle + 2, pieces); ++k)
                nearest = std::min(nearest, distance_to_piece(&splines.points[control + k],
                                                              chains.points[first + i]));
            most[strand] = std::max(most[strand], nearest / double(chains.radii[first + i]));
        }
    });
    return most.empty() ? 0 : *std::ranges::max_element(most);
}

} // namespace scree
