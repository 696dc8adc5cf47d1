// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace scree {

namespace {

/// Cells of a raster, marked where a triangle touches them.
class CellRaster {
  public:
    CellRaster(int width, int height)
        : width_(width), height_(height), marked_(std::size_t(width) * std::size_t(height)) {}

    bool marked(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_ && y < height_ && marked_[index(x, y)] != 0;
    }

    /// Marks all cells within `slack` of the triangle, whose corners are in cells.
    void mark(const std::array<Vec2, 3>& corners, double slack) {
        const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        const int first = std::max(0, static_cast<int>(std::floor(low - slack)));
        const int last = std::min(height_ - 1, static_cast<int>(std::floor(high + slack)));
        for (int y = first; y <= last; ++y) {
            double left = width_, right = 0;
            for (std::size_t i = 0; i < 3; ++i)
                extend_by_edge(corners[i], corners[(i + 1) % 3], y - slack, y + 1 + slack, left,
                               right);
            const int from = std::max(0, static_cast<int>(std::floor(left - slack)));
            const int to = std::min(width_ - 1, static_cast<int>(std::floor(right + slack)));
            for (int x = from; x <= to; ++x)
                marked_[index(x, y)] = 1;
        }
    }

    /// Marks more cells until no two marked ones meet in a corner only, so that outlines are
    /// simple.
    void fill_diagonals() {
        for (bool changed = true; changed;) {
            changed = false;
            for (int y = 0; y + 1 < height_; ++y) {
                for (int x = 0; x + 1 < width_; ++x) {
                    const bool a = marked(x, y), b = marked(x + 1, y);
                    const bool c = marked(x, y + 1), d = marked(x + 1, y + 1);
                    if (a == b || a != d || b != c)
                        continue;
                    marked_[a ? index(x + 1, y) : index(x, y)] = 1;
                    changed = true;
                }
            }
        }
    }

    /// Rings around the marked cells, which lie to their left; vertices only at turns.
    std::vector<Ring> outlines() const {
        enum Step : std::uint8_t { none, right, up, left, down };
        const int columns = width_ + 1;
        std::vector<std::uint8_t> steps(std::size_t(columns) * std::size_t(height_ + 1), none);
        const auto corner = [&](int x, int y) {
            return std::size_t(y) * std::size_t(columns) + std::size_t(x);
        };
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                if (!marked(x, y))
                    continue;
                if (!marked(x, y - 1))
                    steps[corner(x, y)] = right;
                if (!marked(x + 1, y))
                    steps[corner(x + 1, y)] = up;
                if (!marked(x, y + 1))
                    steps[corner(x + 1, y + 1)] = left;
                if (!marked(x - 1, y))
                    steps[corner(x, y + 1)] = down;
            }
        }
        std::vector<Ring> rings;
        for (int start_y = 0; start_y <= height_; ++start_y) {
            for (int start_x = 0; start_x <= width_; ++start_x) {
                if (steps[corner(start_x, start_y)] == none)
                    continue;
                Ring ring;
                std::uint8_t before = none;
                for (int x = start_x, y = start_y; steps[corner(x, y)] != none;) {
                    const std::uint8_t step = std::exchange(steps[corner(x, y)], none);
                    if (step != before)
                        ring.emplace_back(x, y);
                    before = step;
                    x += step == right ? 1 : step == left ? -1 : 0;
                    y += step == up ? 1 : step == down ? -1 : 0;
                }
                rings.push_back(std::move(ring));
            }
        }
        return rings;
    }

  private:
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }

    static void extend_by_edge(Vec2 a, Vec2 b, double low, double high, double& left,
                               double& right) {
        if (a.y > b.y)
            std::swap(a, b);
        if (b.y < low || a.y > high)
            return;
        const Vec2 edge = b - a;
        const auto at = [&](double y) { return a.x + edge.x * ((y - a.y) / edge.y); };
        const double from = a.y < low ? at(low) : a.x;
        const double to = b.y > high ? at(high) : b.x;
        left = std::min({left, from, to});
        right = std::max({right, from, to});
    }

    int width_;
    int height_;
    std::vector<std::uint8_t> marked_;
};

Box2 projected_bounds(const Mesh& mesh) {
    Box2 box;
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle) {
            const Vec3& p = mesh.positions[v];
            if (!is_finite(p))
                throw Error(fmt::format("vertex {} of {} is not finite", v, mesh.name));
            box.extendBy(Vec2(double(p.x), double(p.z)));
        }
    }
    if (box.isEmpty())
        throw Error(fmt::format("{} has no triangles, so it has no silhouette", mesh.name));
    const Vec2 size = box.size();
    if (!(std::min(size.x, size.y) > 1e-6 * std::max(size.x, size.y)))
        throw Error(fmt::format("{} stands on edge: its projection onto the ground, {} x {} m, "
                                "has no area",
                                mesh.name, size.x, size.y));
    return box;
}

} // namespace

Region silhouette(const Mesh& mesh, const SilhouetteDetail& detail) {
    const Box2 box = projected_bounds(mesh);
    const double longest = std::max(box.size().x, box.size().y);
    // The raster extends beyond the box by a little more than all rounding, so that a flat side of
    // the mesh along an axis does not add a whole cell.
    const double reach = 1e-7 * longest;
    const double target = longest / detail.cells;
    const Vec2 extent = box.size() + Vec2(2 * reach);
    const int width = std::max(1, static_cast<int>(std::ceil(extent.x / target - 0.01)));
    const int height = std::max(1, static_cast<int>(std::ceil(extent.y / target - 0.01)));
    const Vec2 origin = box.min - Vec2(reach);
    const Vec2 cell(extent.x / width, extent.y / height);

    CellRaster raster(width, height);
    const double slack = 1e-6; // cells; far above the rounding of what follows
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        std::array<Vec2, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& p = mesh.positions[triangle[i]];
            corners[i] = (Vec2(double(p.x), double(p.z)) - origin) / cell;
        }
        raster.mark(corners, slack);
    }
    raster.fill_diagonals();

    std::vector<Ring> rings = raster.outlines();
    for (Ring& ring : rings)
        for (Vec2& v : ring)
            v = origin + v * cell;
    const double tolerance = detail.tolerance * longest;
    // A hole smaller than this tolerance slows down collision tests, and no element fits in it.
    Region filled;
    std::erase_if(rings, [&](const Ring& ring) {
        const double signed_size = signed_area(ring);
        const bool tiny = signed_size < 0 && -signed_size < 4 * tolerance * tolerance;
        if (tiny)
            filled.rings.push_back(ring);
        return tiny;
    });
    std::erase_if(rings, [&](const Ring& ring) { // islands in such a hole
        return signed_area(ring) > 0 && contains(filled, ring[0] + cell * 0.5);
    });
    simplify_outward(rings, tolerance);
    return triangulate(std::move(rings));
}

} // namespace scree
