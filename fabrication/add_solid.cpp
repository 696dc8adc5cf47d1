// SPDX-License-Identifier: GPL-3.0-or-later
#include "fabrication/add_solid.h"

#include "core/parallel.h"
#include "fabrication/triangle_distance.h"
#include "geometry/mesh/line_crossing.h"

#include <algorithm>
#include <tuple>

namespace scree {

namespace {

using Vec3d = Imath::V3d;
using Box3d = Imath::Box3d;

constexpr int side = DistanceField::side;
constexpr double block_radius = 6.0622; // from a block's centre to its corner points: 3.5 sqrt(3)

int block_floor(double at) { return static_cast<int>(std::floor(at / side)); }

/// A triangle within reach of a block.
struct Near {
    std::uint64_t key;
    std::uint32_t triangle;

    friend auto operator<=>(const Near&, const Near&) = default;
};

/// The crossing of the lattice line (i, j, *) with a triangle.
struct ColumnCrossing {
    int j, i;
    LineCrossing at;

    auto order() const { return std::tuple(j, i, at.z, at.turn); }
};

/// Gathers the items of `count` triangles in parallel pieces, joins them and sorts them.
template <class Item, class Gather>
std::vector<Item> gather_sorted(std::size_t count, const Gather& gather, const auto& less) {
    constexpr std::size_t piece = 4096;
    std::vector<std::vector<Item>> parts((count + piece - 1) / piece);
    parallel_for(parts.size(), 1, [&](std::size_t part) {
        for (std::size_t i = part * piece; i < std::min(count, (part + 1) * piece); ++i)
            gather(i, parts[part]);
    });
    std::vector<Item> out;
    for (std::vector<Item>& part : parts) {
        if (parts.size() == 1)
            out.swap(part);
        else
            out.insert(out.end(), part.begin(), part.end());
        std::vector<Item>().swap(part);
    }
    parallel_sort(out.begin(), out.end(), less);
    return out;
}

class SolidAdder {
  public:
    SolidAdder(DistanceField& field, std::span<const Vec3d> positions,
               std::span<const Mesh::Triangle> triangles)
        : field_(field), positions_(positions), triangles_(triangles),
          reach_(std::max(field.inner(), field.outer())) {}

    bool run() {
        near_ = gather_sorted<Near>(
            triangles_.size(), [&](std::size_t t, auto& out) { gather_near(t, out); },
            std::less<>());
        crossings_ = gather_sorted<ColumnCrossing>(
            triangles_.size(), [&](std::size_t t, auto& out) { gather_crossings(t, out); },
            [](const auto& a, const auto& b) { return a.order() < b.order(); });
        std::vector<std::size_t> starts;
        for (std::size_t n = 0; n < near_.size(); ++n)
            if (n == 0 || near_[n].key != near_[n - 1].key)
                starts.push_back(n);
        std::atomic<bool> room = true;
        parallel_for(starts.size(), 16, [&](std::size_t b) {
            const std::size_t end = b + 1 < starts.size() ? starts[b + 1] : near_.size();
            if (room && !add_block(std::span(near_).subspan(starts[b], end - starts[b])))
                room = false;
        });
        if (room)
            add_inside();
        return room;
    }

  private:
    std::array<Vec3d, 3> corners(std::size_t t) const {
        const Mesh::Triangle& v = triangles_[t];
        return {positions_[v[0]], positions_[v[1]], positions_[v[2]]};
    }

    Box3d box_of(const std::array<Vec3d, 3>& corners) const {
        Box3d box;
        for (const Vec3d& v : corners)
            box.extendBy(v);
        return box;
    }

    void gather_near(std::size_t t, std::vector<Near>& out) const {
        const std::array<Vec3d, 3> v = corners(t);
        const Box3d box = box_of(v);
        const TriangleDistance triangle(v);
        const double far = reach_ + block_radius;
        // The points of a block lie from its corner to 7 beyond it.
        const auto first = [&](double low) { return block_floor(low - reach_ - (side - 1)); };
        for (int z = first(box.min.z); z <= block_floor(box.max.z + reach_); ++z)
            for (int y = first(box.min.y); y <= block_floor(box.max.y + reach_); ++y)
                for (int x = first(box.min.x); x <= block_floor(box.max.x + reach_); ++x) {
                    const Vec3d middle = Vec3d(x, y, z) * side + Vec3d((side - 1) / 2.0);
                    if (triangle.plane_distance(middle) < far && triangle.distance(middle) < far)
                        out.push_back({DistanceField::key_of({x, y, z}), std::uint32_t(t)});
                }
    }

    void gather_crossings(std::size_t t, std::vector<ColumnCrossing>& out) const {
        const std::array<Vec3d, 3> v = corners(t);
        const Box3d box = box_of(v);
        for (int j = int(std::ceil(box.min.y)); j <= int(std::floor(box.max.y)); ++j)
            for (int i = int(std::ceil(box.min.x)); i <= int(std::floor(box.max.x)); ++i)
                if (const auto found = line_crossing(v, {double(i), double(j)}))
                    out.push_back({j, i, *found});
    }

    std::span<const ColumnCrossing> column(int i, int j) const {
        const auto before = [](const ColumnCrossing& c, const std::pair<int, int>& at) {
            return std::pair(c.j, c.i) < at;
        };
        const std::pair at(j, i);
        const auto begin = std::lower_bound(crossings_.begin(), crossings_.end(), at, before);
        auto end = begin;
        while (end != crossings_.end() && end->i == i && end->j == j)
            ++end;
        return {begin, end};
    }

    bool add_block(std::span<const Near> near) {
        const LatticePoint block = DistanceField::block_of(near.front().key);
        const Vec3d corner = Vec3d(block.x, block.y, block.z) * side;
        DistanceField::Values values;
        values.fill(float(reach_ * reach_));
        for (const Near& n : near) {
            const std::array<Vec3d, 3> v = corners(n.triangle);
            const Box3d box = box_of(v);
            const TriangleDistance triangle(v);
            const auto first = [&](int axis) {
                return std::max(0, int(std::ceil(box.min[axis] - reach_ - corner[axis])));
            };
            const auto last = [&](int axis) {
                return std::min(side - 1, int(std::floor(box.max[axis] + reach_ - corner[axis])));
            };
            for (int z = first(2); z <= last(2); ++z)
                for (int y = first(1); y <= last(1); ++y)
                    for (int x = first(0) & ~3; x <= last(0); x += 4)
                        triangle.lower_four(corner + Vec3d(x, y, z), float(reach_),
                                            &values[std::size_t(DistanceField::sample(x, y, z))]);
        }
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                sign_column(values, block, x, y);
        return field_.unite(near.front().key, values);
    }

    void sign_column(DistanceField::Values& values, const LatticePoint& block, int x, int y) const {
        const std::span<const ColumnCrossing> line = column(block.x * side + x, block.y * side + y);
        std::size_t below = 0;
        int winding = 0;
        for (int z = 0; z < side; ++z) {
            for (; below < line.size() && line[below].at.z < block.z * side + z; ++below)
                winding += line[below].at.turn;
            float& value = values[std::size_t(DistanceField::sample(x, y, z))];
            const float distance = std::sqrt(value);
            // Clamped away from 0, so that the sign is that given by the winding number.
            value = winding != 0 ? -std::clamp(distance, 1e-6F, field_.inner())
                                 : std::clamp(distance, 1e-6F, field_.outer());
        }
    }

    // A block out of reach of all triangles is entirely inside if its first point is inside.
    void add_inside() {
        for (std::size_t n = 0; n < crossings_.size();) {
            const auto [i, j] = std::pair(crossings_[n].i, crossings_[n].j);
            int winding = 0;
            for (; n < crossings_.size() && crossings_[n].i == i && crossings_[n].j == j; ++n) {
                winding += crossings_[n].at.turn;
                if (winding == 0 || i % side != 0 || j % side != 0)
                    continue;
                // The mesh is closed, so another crossing follows while the line is inside.
                const double from = crossings_[n].at.z, to = crossings_[n + 1].at.z;
                for (int z = block_floor(from) + 1; z * side <= to; ++z) {
                    const std::uint64_t key = DistanceField::key_of({i / side, j / side, z});
                    const auto found = std::lower_bound(near_.begin(), near_.end(), Near{key, 0});
                    if (found == near_.end() || found->key != key)
                        field_.unite_inside(key);
                }
            }
        }
    }

    DistanceField& field_;
    std::span<const Vec3d> positions_;
    std::span<const Mesh::Triangle> triangles_;
    double reach_;
    std::vector<Near> near_;                // sorted by block
    std::vector<ColumnCrossing> crossings_; // sorted by column, then upwards
};

} // namespace

bool add_solid(DistanceField& field, std::span<const Vec3d> positions,
               std::span<const Mesh::Triangle> triangles) {
    return SolidAdder(field, positions, triangles).run();
}

} // namespace scree
