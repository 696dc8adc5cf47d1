// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/footprint.h"

#include <algorithm>
#include <array>
#include <limits>

namespace scree::rocks {

namespace {

int cell_of(float x, float per_cell) { return nearest_cell(x * per_cell); }

struct Interval {
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();

    void add(float x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
};

template <Side side>
class Raster {
  public:
    Raster(double cell, Footprint& out)
        : out_(out), cell_(static_cast<float>(cell)), per_cell_(1 / cell_) {}

    void draw(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 normal = (b - a).cross(c - a);
        if (is_top ? normal.y < 0 : normal.y > 0)
            return; // of the other side
        const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
        const float extreme = is_top ? high_y : low_y;
        const bool upright = std::abs(normal.y) < 1e-4F * (std::abs(normal.x) + std::abs(normal.z));
        const float gx = upright ? 0 : -normal.x / normal.y;
        const float gz = upright ? 0 : -normal.z / normal.y;
        const float over_cell = (is_top ? 0.5F : -0.5F) * cell_ * (std::abs(gx) + std::abs(gz));
        const int first_row = find_rows(a, b, c);
        for (int j = first_row; j < first_row + static_cast<int>(rows_.size()); ++j) {
            const float middle = static_cast<float>(j) * cell_;
            const Interval& x = rows_[std::size_t(j - first_row)];
            const int first = std::max(cell_of(x.low, per_cell_), out_.first_x);
            const int last = std::min(cell_of(x.high, per_cell_), out_.first_x + out_.width - 1);
            float* row = out_.heights.data() + std::ptrdiff_t(j - out_.first_z) * out_.width;
            const float start =
                upright ? extreme : a.y - gx * a.x + gz * (middle - a.z) + over_cell;
            for (int i = first; i <= last; ++i) {
                const float here = start + gx * (static_cast<float>(i) * cell_);
                float& kept = row[i - out_.first_x];
                kept = is_top ? std::max(kept, std::min(here, extreme))
                              : std::min(kept, std::max(here, extreme));
            }
        }
    }

  private:
    static constexpr bool is_top = side == Side::top;

    /// Of each row of cells that a triangle reaches into, what it covers of x; returns the first.
    int find_rows(const Vec3& a, const Vec3& b, const Vec3& c) {
        const std::array<const Vec3*, 3> corners{&a, &b, &c};
        const std::array<int, 3> row{cell_of(a.z, per_cell_), cell_of(b.z, per_cell_),
                                     cell_of(c.z, per_cell_)};
        const int first = std::min({row[0], row[1], row[2]});
        rows_.assign(std::size_t(std::max({row[0], row[1], row[2]}) - first + 1), {});
        for (std::size_t i = 0; i < 3; ++i)
            rows_[std::size_t(row[i] - first)].add(corners[i]->x);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = i < 2 ? i + 1 : 0;
            if (row[i] == row[next])
                continue;
            // Where the edge goes from one row to the next, it is in both.
            const Vec3& p = *corners[i];
            const Vec3& q = *corners[next];
            const float slope = (q.x - p.x) / (q.z - p.z);
            const auto [low, high] = std::minmax(p.x, q.x);
            const auto [from, to] = std::minmax(row[i], row[next]);
            for (int j = from; j < to; ++j) {
                const float border = (static_cast<float>(j) + 0.5F) * cell_;
                const float x = std::clamp(p.x + slope * (border - p.z), low, high);
                rows_[std::size_t(j - first)].add(x);
                rows_[std::size_t(j + 1 - first)].add(x);
            }
        }
        return first;
    }

    Footprint& out_;
    float cell_;
    float per_cell_;
    std::vector<Interval> rows_;
};

template <Side side>
void draw_all(std::span<const Vec3> vertices, std::span<const Mesh::Triangle> triangles,
              double cell, Footprint& out) {
    Raster<side> raster(cell, out);
    for (const Mesh::Triangle& t : triangles)
        raster.draw(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
}

/// Of triangles that are smaller than a cell each lies within a cell of its corners, and none of it
/// is beyond the extreme one of them: each cell takes the extreme vertex of its 3 x 3 neighbours.
void spread_vertices(std::span<const Vec3> vertices, float per_cell, Side side, Footprint& out) {
    const bool is_top = side == Side::top;
    const auto extreme = [&](float a, float b) { return is_top ? std::max(a, b) : std::min(a, b); };
    for (const Vec3& v : vertices) {
        const int i = cell_of(v.x, per_cell) - out.first_x;
        const int j = cell_of(v.z, per_cell) - out.first_z;
        float& kept = out.heights[std::size_t(j) * std::size_t(out.width) + std::size_t(i)];
        kept = extreme(kept, v.y);
    }
    const auto along = [&](std::size_t start, std::size_t step, int count) {
        float before = out.heights[start];
        for (int k = 0; k < count; ++k) {
            float& here = out.heights[start + std::size_t(k) * step];
            const float kept = here;
            here = extreme(here, before);
            if (k + 1 < count)
                here = extreme(here, out.heights[start + std::size_t(k + 1) * step]);
            before = kept;
        }
    };
    for (int j = 0; j < out.depth; ++j)
        along(std::size_t(j) * std::size_t(out.width), 1, out.width);
    for (int i = 0; i < out.width; ++i)
        along(std::size_t(i), std::size_t(out.width), out.depth);
}

bool are_small(std::span<const Vec3> vertices, std::span<const Mesh::Triangle> triangles,
               double cell) {
    const auto most = static_cast<float>(cell * cell);
    return std::all_of(triangles.begin(), triangles.end(), [&](const Mesh::Triangle& t) {
        const Vec3& a = vertices[t[0]];
        const Vec3& b = vertices[t[1]];
        const Vec3& c = vertices[t[2]];
        return (b - a).length2() < most && (c - b).length2() < most && (a - c).length2() < most;
    });
}

} // namespace

void rasterise(std::span<const Vec3> vertices, std::span<const Mesh::Triangle> triangles,
               double cell, Side side, Footprint& out) {
    Imath::Box3f box;
    for (const Vec3& v : vertices)
        box.extendBy(v);
    const auto per_cell = static_cast<float>(1 / cell);
    out.first_x = cell_of(box.min.x, per_cell);
    out.first_z = cell_of(box.min.z, per_cell);
    out.width = cell_of(box.max.x, per_cell) - out.first_x + 1;
    out.depth = cell_of(box.max.z, per_cell) - out.first_z + 1;
    const float nothing = std::numeric_limits<float>::infinity() * (side == Side::under ? 1 : -1);
    out.heights.assign(std::size_t(out.width) * std::size_t(out.depth), nothing);
    if (are_small(vertices, triangles, cell))
        spread_vertices(vertices, per_cell, side, out);
    else if (side == Side::top)
        draw_all<Side::top>(vertices, triangles, cell, out);
    else
        draw_all<Side::under>(vertices, triangles, cell, out);
}

} // namespace scree::rocks
