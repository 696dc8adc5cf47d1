// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/height_map.h"

#include "core/parallel.h"

#include <algorithm>
#include <limits>

namespace scree::rocks {

namespace {

constexpr float nothing = std::numeric_limits<float>::lowest();
constexpr int rows_of_band = 64; // at least
constexpr int most_bands = 64;

} // namespace

HeightMap::HeightMap(const Box2& area, double cell, const Ground& ground)
    : cell_(cell), origin_(area.min + Vec2(cell / 2)),
      width_(static_cast<int>(std::ceil(area.size().x / cell)) + 1),
      depth_(static_cast<int>(std::ceil(area.size().y / cell)) + 1),
      plane_(static_cast<float>(-ground.rise() * origin_.y + std::abs(ground.rise()) * cell / 2)),
      fall_(static_cast<float>(ground.rise() * cell)) {
    const std::size_t count = std::size_t(width_) * std::size_t(depth_);
    tops_.assign(count, nothing);
    rocks_.assign(count, no_rock);
    const TopGrid* mesh = ground.mesh();
    if (mesh == nullptr)
        return;
    // As if the ground were the top of a rock whose centre is over cell (0, 0).
    std::vector<Vec3> vertices = mesh->vertices();
    for (Vec3& v : vertices)
        v -= Vec3(float(origin_.x), 0, float(origin_.y));
    Footprint top;
    rasterise(vertices, mesh->triangles(), cell, Side::top, top);
    ground_.assign(count, nothing);
    for (int j = std::max(0, top.first_z); j < std::min(depth_, top.first_z + top.depth); ++j)
        for (int i = std::max(0, top.first_x); i < std::min(width_, top.first_x + top.width); ++i)
            ground_[index(i, j)] = std::max(
                nothing, top.heights[std::size_t(j - top.first_z) * std::size_t(top.width) +
                                     std::size_t(i - top.first_x)]);
}

double HeightMap::rest(const Footprint& under, int i, int j, double sink, double enough) const {
    const auto lower = static_cast<float>(sink);
    const auto limit = static_cast<float>(std::min(enough, 1e30));
    const int first_x = std::max(0, -(i + under.first_x));
    const int last_x = std::min(under.width, width_ - (i + under.first_x));
    float rest = nothing;
    for (int row = 0; row < under.depth && rest <= limit; ++row) {
        const int z = j + under.first_z + row;
        if (z < 0 || z >= depth_)
            continue;
        const float* below = under.heights.data() + std::ptrdiff_t(row) * under.width;
        const std::size_t start =
            index(0, z) + std::size_t(i + under.first_x + first_x) - std::size_t(first_x);
        for (int column = first_x; column < last_x; ++column) {
            const std::size_t k = start + std::size_t(column);
            const float base =
                ground_.empty() ? plane_ - fall_ * static_cast<float>(z) : ground_[k];
            rest = std::max(rest, std::max(tops_[k], base - lower) - below[column]);
        }
    }
    return double(rest);
}

void HeightMap::add(std::span<const PlacedRock> rocks, std::span<const RockSurface> surfaces) {
    // Each band of rows is filled by one thread, in the order of the rocks.
    const int rows = std::max(rows_of_band, depth_ / most_bands);
    parallel_for(std::size_t(depth_ / rows + 1), 1, [&](std::size_t band) {
        const int first = int(band) * rows;
        for (std::uint32_t i = 0; i < rocks.size(); ++i)
            if (rocks[i].placed)
                add(rocks[i], surfaces[rocks[i].surface], i, first, std::min(first + rows, depth_));
    });
}

void HeightMap::add(const PlacedRock& rock, const RockSurface& surface, std::uint32_t number,
                    int first_row, int end_row) {
    const int reach = static_cast<int>(double(surface.reach) * rock.scale / cell_) + 2;
    const int middle = row(rock.centre.z);
    if (middle + reach < first_row || middle - reach >= end_row)
        return;
    // A footprint is about the middle of a cell, where the centre seldom is.
    const int i = column(rock.centre.x);
    const Vec2 off = Vec2(rock.centre.x, rock.centre.z) - place(i, middle);
    std::vector<Vec3> vertices;
    pose_vertices(surface, rock.world_from_rock, rock.scale, vertices);
    for (Vec3& v : vertices)
        v += Vec3(float(off.x), 0, float(off.y));
    Footprint top;
    rasterise(vertices, surface.triangles, cell_, Side::top, top);
    const auto centre = static_cast<float>(rock.centre.y);
    const int above_first = middle + top.first_z; // row of the map
    for (int k = std::max(0, first_row - above_first);
         k < std::min(top.depth, end_row - above_first); ++k)
        for (int m = 0; m < top.width; ++m) {
            const int x = i + top.first_x + m;
            const int z = above_first + k;
            const float above =
                top.heights[std::size_t(k) * std::size_t(top.width) + std::size_t(m)];
            if (!contains(x, z) || !top.has(above) || centre + above <= tops_[index(x, z)])
                continue;
            tops_[index(x, z)] = centre + above;
            rocks_[index(x, z)] = number;
        }
}

} // namespace scree::rocks
