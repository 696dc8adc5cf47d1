// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/surroundings.h"

#include <algorithm>
#include <limits>

namespace scree::rocks {

namespace {

constexpr double tops_per_cell = 0.5;
constexpr int most_columns = 64;

} // namespace

void Surroundings::gather(const Neighbourhood& around, const WideVec3& origin, double half,
                          double sink) {
    origin_ = origin;
    half_ = half;
    tops_.clear();
    boxes_.clear();
    gather_rocks(around);
    for (const std::uint32_t rock : rocks_)
        add_rock(around, rock);
    if (const TopGrid* ground = around.ground.mesh()) {
        const Vec2f middle(static_cast<float>(origin.x), static_cast<float>(origin.z));
        const Vec2f reach(static_cast<float>(half));
        ground->each_in({middle - reach, middle + reach},
                        [&](const Vec3& a, const Vec3& b, const Vec3& c) {
                            add(a, b, c, -origin - WideVec3(0, sink, 0), HeightMap::no_rock);
                        });
    }
    grid_.fill(boxes_, tops_per_cell, most_columns);
    highest_.assign(grid_.cell_count(), std::numeric_limits<double>::lowest());
    for (std::size_t cell = 0; cell < highest_.size(); ++cell)
        for (const std::uint32_t k : grid_.members(cell))
            highest_[cell] = std::max(highest_[cell], tops_[k].plan.high);
}

void Surroundings::gather_rocks(const Neighbourhood& around) {
    const HeightMap& map = around.map;
    const int last_column = map.column(origin_.x + half_) + 1;
    const int last_row = map.row(origin_.z + half_) + 1;
    rocks_.clear();
    for (int j = map.row(origin_.z - half_) - 1; j <= last_row; ++j)
        for (int i = map.column(origin_.x - half_) - 1; i <= last_column; ++i) {
            const std::uint32_t rock = map.rock(i, j);
            if (rock != HeightMap::no_rock && (rocks_.empty() || rocks_.back() != rock))
                rocks_.push_back(rock);
        }
    std::sort(rocks_.begin(), rocks_.end());
    rocks_.erase(std::unique(rocks_.begin(), rocks_.end()), rocks_.end());
}

void Surroundings::add_rock(const Neighbourhood& around, std::uint32_t number) {
    const PlacedRock& rock = around.rocks[number];
    const WideVec3 offset = rock.centre - origin_;
    const Vec2f middle(static_cast<float>(offset.x), static_cast<float>(offset.z));
    const Vec2f reach(static_cast<float>(half_));
    const Imath::Box2f area(-middle - reach, reach - middle);
    if (const TopGrid* grid = around.tops[number].get()) {
        grid->each_in(area, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
            add(a, b, c, offset, number);
        });
        return;
    }
    const RockSurface& surface = around.surfaces[rock.surface];
    pose_vertices(surface, rock.world_from_rock, rock.scale, posed_);
    for (const Mesh::Triangle& t : surface.triangles) {
        const Vec3& a = posed_[t[0]];
        const Vec3& b = posed_[t[1]];
        const Vec3& c = posed_[t[2]];
        const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
        const auto [low_z, high_z] = std::minmax({a.z, b.z, c.z});
        if (low_x <= area.max.x && high_x >= area.min.x && low_z <= area.max.y &&
            high_z >= area.min.y && (b - a).cross(c - a).y > 0)
            add(a, b, c, offset, number);
    }
}

void Surroundings::add(const Vec3& a, const Vec3& b, const Vec3& c, const WideVec3& offset,
                       std::uint32_t rock) {
    tops_.push_back({Plan(WideVec3(a) + offset, WideVec3(b) + offset, WideVec3(c) + offset), rock});
    boxes_.push_back(tops_.back().plan.box);
}

} // namespace scree::rocks
