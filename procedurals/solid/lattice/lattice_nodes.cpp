// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/lattice/lattice_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace scree {

namespace {

using solid::Lattice;

/// Adds one level to nodes that hold all previous levels.
class LevelMaker {
  public:
    LevelMaker(const Lattice& lattice, float* nodes, int level)
        : lattice_(lattice), nodes_(nodes), level_(level), cells_(1U << level) {
        const std::size_t side = (std::size_t(1) << lattice.levels) + 1;
        const std::size_t stride = std::size_t(1) << (lattice.levels - level);
        steps_ = {stride, stride * side, stride * side * side};
    }

    // A node with n odd coordinates is the mean of its 2 n neighbours along those axes, which have
    // n - 1 odd coordinates. So midpoints of edges come first, then centres of faces, then of
    // cubes.
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
        const std::uint32_t row = solid::row_bits(
            lattice_.key_a, static_cast<std::uint32_t>(solid::source_level(&lattice_, level_)),
            y & mask, z & mask);
        const std::uint32_t other = solid::scramble(row + lattice_.key_b);
        float* node = nodes_ + first * steps_[0] + y * steps_[1] + z * steps_[2];
        for (std::uint32_t x = first; x <= cells_; x += 2, node += 2 * steps_[0]) {
            float sum = *(node - axes[0]) + *(node + axes[0]);
            for (std::size_t i = 1; i < count; ++i)
                sum += *(node - axes[i]) + *(node + axes[i]);
            const float g = solid::normal_variate(solid::node_bits(row, other, x & mask));
            *node = sum * share + g * lattice_.amplitude[level_];
        }
    }

    const Lattice& lattice_;
    float* nodes_;
    int level_;
    std::uint32_t cells_;
    std::array<std::size_t, 3> steps_; // to the level's next node along x, y, z
};

/// The largest absolute value of the nodes before the last level.
float largest_before_last(const Lattice& header, const std::vector<float>& nodes) {
    const std::size_t side = (std::size_t(1) << header.levels) + 1;
    const std::size_t stride = header.levels > 0 ? 2 : 1;
    float largest = 0;
    for (std::size_t z = 0; z < side; z += stride)
        for (std::size_t y = 0; y < side; y += stride)
            for (std::size_t x = 0; x < side; x += stride)
                largest = std::max(largest, std::abs(nodes[x + side * (y + side * z)]));
    return largest;
}

} // namespace

void make_nodes_plainly(const Lattice& header, float* nodes) {
    const std::size_t side = std::size_t(1) << header.levels;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const std::uint32_t x = corner & 1, y = (corner >> 1) & 1, z = corner >> 2;
        nodes[side * (x + (side + 1) * (y + (side + 1) * z))] = corner_node(header, x, y, z);
    }
    for (int level = 1; level <= header.levels; ++level)
        LevelMaker(header, nodes, level).make();
}

void make_nodes_plainly(Lattice& header, std::int16_t* nodes) {
    std::vector<float> floats(node_count(header.levels));
    make_nodes_plainly(header, floats.data());
    header.step = step_of_nodes(header, largest_before_last(header, floats));
    const float inverse = 1 / header.step;
    for (std::size_t i = 0; i < floats.size(); ++i) // rounds half to even, as vector code does
        nodes[i] = static_cast<std::int16_t>(std::lrint(floats[i] * inverse));
}

} // namespace scree
