// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/rock/solid_noise.h"

#include <algorithm>
#include <array>

namespace scree {

namespace {

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

/// Towards the middles of a cube's edges; four of the twelve are there twice (Perlin 2002).
constexpr double gradients[16][3] = {
    {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
    {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {1, 1, 0}, {-1, 1, 0}, {0, -1, 1}, {0, -1, -1}};

inline double gradient_product(std::uint32_t hash, double x, double y, double z) {
    const auto& g = gradients[hash & 15U];
    return g[0] * x + g[1] * y + g[2] * z;
}

struct Cell {
    std::array<int, 3> at;
    WideVec3 within; // of the unit cube
};

Cell cell_of(const WideVec3& p) {
    Cell cell;
    for (unsigned axis = 0; axis < 3; ++axis) {
        // std::floor is a call without SSE 4.1.
        const int towards_zero = static_cast<int>(p[axis]);
        cell.at[axis] = towards_zero - (p[axis] < towards_zero ? 1 : 0);
        cell.within[axis] = p[axis] - cell.at[axis];
    }
    return cell;
}

/// Ten bits as a number in [0, 1].
double share(std::uint32_t bits) { return (bits & 1023U) / 1023.0; }

/// The height of the slanted plane of the site with this hash, at an offset from it.
double plane_height(std::uint32_t hash, const WideVec3& offset) {
    constexpr double slant = 0.9;
    std::uint32_t g = hash * 0x9E3779B1U + 0x7F4A7C15U;
    g ^= g >> 16;
    const WideVec3 slope(2 * share(g) - 1, 2 * share(g >> 10) - 1, 2 * share(g >> 20) - 1);
    return slant * (slope ^ offset) + 0.7 * (share(g >> 5) - 0.5);
}

} // namespace

std::uint32_t lattice_hash(int x, int y, int z, std::uint32_t seed) {
    std::uint32_t h = seed ^ (static_cast<std::uint32_t>(x) * 0x9E3779B1U) ^
                      (static_cast<std::uint32_t>(y) * 0x85EBCA77U) ^
                      (static_cast<std::uint32_t>(z) * 0xC2B2AE3DU);
    h = (h ^ (h >> 16)) * 0x7FEB352DU; // the last steps as Wellons 2018
    h = (h ^ (h >> 15)) * 0x846CA68BU;
    return h ^ (h >> 16);
}

double gradient_noise(const WideVec3& p, std::uint32_t seed) {
    const Cell cell = cell_of(p);
    const int x = cell.at[0];
    const int y = cell.at[1];
    const int z = cell.at[2];
    const WideVec3& f = cell.within;
    const double u = fade(f.x);
    const double v = fade(f.y);
    const double w = fade(f.z);
    const auto along_x = [&](int j, int k) {
        const double low =
            gradient_product(lattice_hash(x, y + j, z + k, seed), f.x, f.y - j, f.z - k);
        const double high =
            gradient_product(lattice_hash(x + 1, y + j, z + k, seed), f.x - 1, f.y - j, f.z - k);
        return mix(low, high, u);
    };
    return mix(mix(along_x(0, 0), along_x(1, 0), v), mix(along_x(0, 1), along_x(1, 1), v), w);
}

WideVec3 vector_noise(const WideVec3& p, std::uint32_t seed) {
    return {gradient_noise(p, seed), gradient_noise(p + WideVec3(31.4, 7.7, 1.3), seed ^ 0x51U),
            gradient_noise(p + WideVec3(-11.2, 3.9, 17.1), seed ^ 0xA7U)};
}

double faceted_noise(const WideVec3& p, std::uint32_t seed) {
    constexpr double seam = 0.12; // where the distances to both sites differ by less
    struct Site {
        double distance2 = 1e9;
        double height = 0;
    };
    Site nearest, second;
    const Cell cell = cell_of(p);
    const WideVec3& f = cell.within;
    const auto beyond2 = [](double within, int step) { // of a neighbouring cell's nearest face
        const double beyond = step < 0 ? within : step > 0 ? 1 - within : 0;
        return beyond * beyond;
    };
    // The cell itself first, so that most of the others are seen to be too far.
    constexpr std::array<int, 3> steps{0, -1, 1};
    for (const int k : steps)
        for (const int j : steps)
            for (const int i : steps) {
                if (beyond2(f.x, i) + beyond2(f.y, j) + beyond2(f.z, k) >= second.distance2)
                    continue;
                const std::uint32_t h =
                    lattice_hash(cell.at[0] + i, cell.at[1] + j, cell.at[2] + k, seed);
                const WideVec3 offset =
                    f - WideVec3(i + share(h), j + share(h >> 10), k + share(h >> 20));
                const double distance2 = offset.length2();
                if (distance2 >= second.distance2)
                    continue;
                const Site site{distance2, plane_height(h, offset)};
                if (distance2 < nearest.distance2) {
                    second = nearest;
                    nearest = site;
                } else {
                    second = site;
                }
            }
    const double apart = std::sqrt(second.distance2) - std::sqrt(nearest.distance2);
    const double t = std::clamp(apart / seam, 0.0, 1.0);
    return mix(second.height, nearest.height, 0.5 + 0.5 * t * t * (3 - 2 * t));
}

} // namespace scree
