// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/offset_shells.h"

#include <algorithm>
#include <unordered_map>

namespace scree {

namespace {

// Corners of a cube are numbered by bits: x, y, z. Each tetrahedron goes from corner 0 to corner 7
// by one axis after the other, in one of six orders, so that neighbouring cubes cut their common
// face along the same diagonal. The last says whether the order is an even one.
struct Tetrahedron {
    std::array<unsigned, 4> corners;
    bool even;
};
constexpr std::array<Tetrahedron, 6> tetrahedra{{
    {{0, 1, 3, 7}, true},
    {{0, 2, 6, 7}, true},
    {{0, 4, 5, 7}, true},
    {{0, 1, 5, 7}, false},
    {{0, 2, 3, 7}, false},
    {{0, 4, 6, 7}, false},
}};

class LevelSurface {
  public:
    LevelSurface(const SignedDistanceGrid& distance, float level)
        : grid_(distance.grid()), values_(distance.samples()), level_(level) {
        for (unsigned c = 0; c < 8; ++c)
            corner_[c] = grid_.index(c & 1U, c >> 1U & 1U, c >> 2U);
    }

    Mesh make() {
        for (int z = 0; z + 1 < grid_.count[2]; ++z)
            for (int y = 0; y + 1 < grid_.count[1]; ++y)
                for (int x = 0; x + 1 < grid_.count[0]; ++x)
                    cut_cube(x, y, z);
        return std::move(mesh_);
    }

  private:
    void cut_cube(int x, int y, int z) {
        const std::size_t first = grid_.index(x, y, z);
        unsigned inside = 0;
        for (unsigned c = 0; c < 8; ++c)
            inside |= unsigned{values_[first + corner_[c]] < level_} << c;
        if (inside == 0 || inside == 255)
            return;
        cube_ = {x, y, z};
        for (const Tetrahedron& t : tetrahedra)
            cut_tetrahedron(t, inside);
    }

    // With the corners inside sorted before those outside, the order's parity tells which way the
    // triangles look.
    void cut_tetrahedron(const Tetrahedron& t, unsigned cube_inside) {
        std::array<unsigned, 4> v = t.corners;
        bool even = t.even;
        const auto inside = [&](unsigned corner) { return (cube_inside >> corner & 1U) != 0; };
        unsigned count = 0;
        for (unsigned i = 0; i < 4; ++i)
            if (inside(v[i])) {
                for (unsigned k = i; k > count; --k) {
                    std::swap(v[k], v[k - 1]);
                    even = !even;
                }
                ++count;
            }
        if (count == 1) {
            triangle(vertex(v[0], v[1]), vertex(v[0], v[2]), vertex(v[0], v[3]), even);
        } else if (count == 2) {
            const std::array<std::uint32_t, 4> quad{vertex(v[0], v[2]), vertex(v[0], v[3]),
                                                    vertex(v[1], v[3]), vertex(v[1], v[2])};
            triangle(quad[0], quad[1], quad[2], even);
            triangle(quad[0], quad[2], quad[3], even);
        } else if (count == 3) {
            triangle(vertex(v[0], v[3]), vertex(v[1], v[3]), vertex(v[2], v[3]), even);
        }
    }

    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool even) {
        if (even)
            mesh_.triangles.push_back({a, b, c});
        else
            mesh_.triangles.push_back({a, c, b});
    }

    // On the edge between two corners of the cube, one inside and one not.
    std::uint32_t vertex(unsigned a, unsigned b) {
        const unsigned low = a & b; // one has all the bits of the other
        const unsigned high = a | b;
        const std::size_t first = grid_.index(cube_[0], cube_[1], cube_[2]);
        const std::size_t key = (first + corner_[low]) * 8 + (low ^ high);
        const auto [at, is_new] =
            vertices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
        if (is_new) {
            const double from = double(values_[first + corner_[low]]);
            const double to = double(values_[first + corner_[high]]);
            // Off the samples, so that no two vertices fall into one.
            const double share = std::clamp((double(level_) - from) / (to - from), 0.01, 0.99);
            const Imath::V3d start = position(low);
            mesh_.positions.emplace_back(start + (position(high) - start) * share);
        }
        return at->second;
    }

    Imath::V3d position(unsigned corner) const {
        return grid_.centre(cube_[0] + static_cast<int>(corner & 1U),
                            cube_[1] + static_cast<int>(corner >> 1U & 1U),
                            cube_[2] + static_cast<int>(corner >> 2U));
    }

    const VoxelGrid& grid_;
    const std::vector<float>& values_;
    float level_;
    std::array<std::size_t, 8> corner_{};
    std::array<int, 3> cube_{};
    std::unordered_map<std::size_t, std::uint32_t> vertices_;
    Mesh mesh_;
};

} // namespace

Mesh level_surface(const SignedDistanceGrid& distance, double level) {
    return LevelSurface(distance, static_cast<float>(level)).make();
}

std::vector<OffsetShell> offset_shells(const SignedDistanceGrid& solid, double spacing,
                                       std::size_t most) {
    std::vector<OffsetShell> shells;
    while (shells.size() < most) {
        const double depth = double(shells.size() + 1) * spacing;
        Mesh surface = level_surface(solid, -depth);
        if (surface.triangles.empty())
            break;
        shells.push_back({depth, std::move(surface)});
    }
    return shells;
}

} // namespace scree
