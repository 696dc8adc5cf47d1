// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/footprint.h"

#include <algorithm>
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

/// An edge seen from above, from its end with the smaller z.
struct Edge {
    Edge(const Vec3& p, const Vec3& q) : low(p.z < q.z ? p : q), high(p.z < q.z ? q : p) {
        slope = high.z > low.z ? (high.x - low.x) / (high.z - low.z) : 0;
    }

    /// Adds to `x` what of the edge lies between two lines of constant z.
    void clip(float from, float to, Interval& x) const {
        if (high.z < from || low.z > to)
            return;
        x.add(low.z < from ? low.x + slope * (from - low.z) : low.x);
        x.add(high.z > to ? low.x + slope * (to - low.z) : high.x);
    }

    const Vec3& low;
    const Vec3& high;
    float slope = 0;
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
        const auto [low_z, high_z] = std::minmax({a.z, b.z, c.z});
        const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
        const float extreme = is_top ? high_y : low_y;
        const bool upright = std::abs(normal.y) < 1e-4F * (std::abs(normal.x) + std::abs(normal.z));
        const float gx = upright ? 0 : -normal.x / normal.y;
        const float gz = upright ? 0 : -normal.z / normal.y;
        const float over_cell = (is_top ? 0.5F : -0.5F) * cell_ * (std::abs(gx) + std::abs(gz));
        const std::array<Edge, 3> edges{Edge(a, b), Edge(b, c), Edge(c, a)};
        for (int j = cell_of(low_z, per_cell_); j <= cell_of(high_z, per_cell_); ++j) {
            const float middle = static_cast<float>(j) * cell_;
            Interval x;
            for (const Edge& edge : edges)
                edge.clip(middle - 0.5F * cell_, middle + 0.5F * cell_, x);
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

    Footprint& out_;
    float cell_;
    float per_cell_;
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
