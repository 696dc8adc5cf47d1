// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/fractal_lattice.h"

#include "core/random.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace scree {

namespace {

using solid::Lattice;

/// Adds one level to nodes that hold all levels before it.
class LevelMaker {
  public:
    LevelMaker(const Lattice& lattice, std::vector<float>& nodes, int level)
        : lattice_(lattice), nodes_(nodes), level_(level), cells_(1U << level) {
        const std::size_t side = (std::size_t(1) << lattice.levels) + 1;
        const std::size_t stride = std::size_t(1) << (lattice.levels - level);
        steps_ = {stride, stride * side, stride * side * side};
    }

    // A node with n odd coordinates is the mean of its 2 n neighbours along those axes, which have
    // n - 1 of them: first the edges' midpoints, then the centres of faces, then of cubes.
    void make() {
        for (std::uint32_t odd = 1; odd <= 3; ++odd)
            for (std::uint32_t z = 0; z <= cells_; ++z)
                for (std::uint32_t y = 0; y <= cells_; ++y) {
                    const std::uint32_t others = (y & 1) + (z & 1);
                    if (odd == others || odd == others + 1)
                        make_row(odd - others, y, z);
                }
    }

  private:
    // Every other node of a row, from x = `first`.
    void make_row(std::uint32_t first, std::uint32_t y, std::uint32_t z) {
        std::array<std::size_t, 3> axes{};
        std::size_t count = 0;
        const std::array<std::uint32_t, 3> parities{first, y & 1, z & 1};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (parities[axis] == 1)
                axes[count++] = steps_[axis];
        const float share = 1.0F / static_cast<float>(2 * count);

        const std::uint32_t mask = solid::node_mask(&lattice_, level_);
        const std::uint32_t row =
            solid::row_bits(lattice_.key_a, static_cast<std::uint32_t>(level_), y & mask, z & mask);
        const std::uint32_t other = solid::scramble(row + lattice_.key_b);
        float* node = &nodes_[first * steps_[0] + y * steps_[1] + z * steps_[2]];
        for (std::uint32_t x = first; x <= cells_; x += 2, node += 2 * steps_[0]) {
            float sum = 0;
            for (std::size_t i = 0; i < count; ++i)
                sum += *(node - axes[i]) + *(node + axes[i]);
            const float g = solid::normal_variate(solid::node_bits(row, other, x & mask));
            *node = sum * share + g * lattice_.spread[level_];
        }
    }

    const Lattice& lattice_;
    std::vector<float>& nodes_;
    int level_;
    std::uint32_t cells_;
    std::array<std::size_t, 3> steps_; // to the level's next node along x, y, z
};

/// The eight corners, which are level 0.
void make_corners(const Lattice& lattice, std::vector<float>& nodes) {
    const std::size_t side = std::size_t(1) << lattice.levels;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const std::uint32_t x = corner & 1, y = (corner >> 1) & 1, z = corner >> 2;
        nodes[side * (x + (side + 1) * (y + (side + 1) * z))] =
            lattice.repeats != 0
                ? 0
                : lattice.spread[0] * solid::node_normal(lattice.key_a, lattice.key_b, 0, x, y, z);
    }
}

Lattice make_header(const LatticeSettings& settings) {
    assert(settings.levels >= 0 && settings.levels <= 8 && settings.detail >= 0);
    Lattice header{};
    Random random(settings.seed, Purpose::solid_lattice);
    header.key_a = random.bits();
    header.key_b = random.bits();
    header.repeats = settings.repeats ? 1 : 0;
    header.levels = settings.levels;
    header.finest = std::min(settings.levels + settings.detail, LATTICE_MOST_LEVELS - 2);
    header.mean_square = static_cast<float>(mean_square_of_level());
    double left_out = 0;
    for (int level = header.finest; level >= 0; --level) {
        const double spread = std::exp(-(level - 1) * settings.decay);
        header.spread[level] = static_cast<float>(spread);
        header.left_out[level] = static_cast<float>(left_out);
        left_out += spread * spread * mean_square_of_level();
    }
    return header;
}

} // namespace

FractalLattice::FractalLattice(const LatticeSettings& settings) : header_(make_header(settings)) {
    const auto side = static_cast<std::size_t>(this->side()) + 1;
    nodes32_.resize(side * side * side);
    make_corners(header_, nodes32_);
    for (int level = 1; level <= header_.levels; ++level)
        LevelMaker(header_, nodes32_, level).make();
    if (!settings.sixteen_bit)
        return;
    float largest = 0;
    for (const float value : nodes32_)
        largest = std::max(largest, std::abs(value));
    header_.step = std::max(largest, 1e-30F) / 32767;
    nodes16_.resize(nodes32_.size());
    for (std::size_t i = 0; i < nodes16_.size(); ++i)
        nodes16_[i] = static_cast<std::int16_t>(std::lround(nodes32_[i] / header_.step));
    nodes32_ = {};
}

float FractalLattice::node(int x, int y, int z) const {
    const int nodes = side() + 1;
    assert(x >= 0 && y >= 0 && z >= 0 && std::max({x, y, z}) < nodes);
    const auto at = static_cast<std::size_t>(x + nodes * (y + nodes * z));
    return nodes32_.empty() ? header_.step * static_cast<float>(nodes16_[at]) : nodes32_[at];
}

double mean_square_of_level() {
    // The weights are products of one linear function per half of an axis, their squares of degree
    // 2, and Gauss's rule of two points is exact to degree 3.
    constexpr double low = 0.5 - 0.28867513459481287, high = 0.5 + 0.28867513459481287;
    const float places[4] = {low / 2, high / 2, 0.5F + low / 2, 0.5F + high / 2};
    static const double mean = [&] {
        double sum = 0;
        float unit[27] = {}, wx[3], wy[3], wz[3], unused[3];
        for (const float x : places)
            for (const float y : places)
                for (const float z : places) {
                    solid::axis_weights(x, wx, unused);
                    solid::axis_weights(y, wy, unused);
                    solid::axis_weights(z, wz, unused);
                    for (float& g : unit) { // each variate by itself: they are independent
                        g = 1;
                        const double weight = double(solid::carried(unit, wx, wy, wz));
                        sum += weight * weight / 64;
                        g = 0;
                    }
                }
        return sum;
    }();
    return mean;
}

} // namespace scree
