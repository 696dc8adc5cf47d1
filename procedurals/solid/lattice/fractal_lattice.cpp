// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/lattice/fractal_lattice.h"

#include "core/random.h"
#include "procedurals/solid/lattice/lattice_nodes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace scree {

namespace {

using solid::Lattice;

Lattice make_header(const LatticeSettings& settings) {
    assert(settings.levels >= 0 && settings.levels <= 8 && settings.detail >= 0);
    Lattice header{};
    Random random(settings.seed, Purpose::solid_lattice);
    header.key_a = random.bits();
    header.key_b = random.bits();
    header.repeats = settings.repeats ? 1 : 0;
    header.levels = settings.levels;
    header.unique_levels = std::max(settings.levels, 7);
    header.finest = std::min(settings.levels + settings.detail, LATTICE_MAX_LEVELS - 2);
    header.mean_square = static_cast<float>(mean_square_of_level());
    double residual_variance = 0;
    for (int level = header.finest; level >= 0; --level) {
        const double amplitude = std::exp(-(level - 1) * settings.decay);
        header.amplitude[level] = static_cast<float>(amplitude);
        header.residual_variance[level] = static_cast<float>(residual_variance);
        residual_variance += amplitude * amplitude * mean_square_of_level();
    }
    return header;
}

constexpr int tile_levels = TILE_COARSE + TILE_LEVELS;

/// The tile as a separate lattice: its coarse levels are zero, the others are in units of the first
/// non-zero one.
Lattice tile_header(const Lattice& header) {
    Lattice tile = header;
    tile.repeats = 1;
    tile.levels = tile_levels;
    tile.level_offset = header.unique_levels - TILE_COARSE;
    for (int level = 0; level <= tile_levels; ++level)
        tile.amplitude[level] =
            level <= TILE_COARSE ? 0 : header.amplitude[level - TILE_COARSE] / header.amplitude[1];
    return tile;
}

} // namespace

FractalLattice::FractalLattice(const LatticeSettings& settings)
    : header_(make_header(settings)), count_(node_count(header_.levels)) {
    const std::size_t tile_start = count_;
    if (header_.finest > header_.unique_levels) {
        header_.tile = static_cast<int>(tile_start);
        count_ += node_count(tile_levels);
    }
    Lattice tile = tile_header(header_);
    if (settings.sixteen_bit) {
        nodes16_ = large_array<std::int16_t>(count_ + node_padding);
        make_nodes(header_, nodes16_.get());
        if (header_.tile > 0)
            make_nodes(tile, nodes16_.get() + tile_start);
        header_.tile_step = tile.step;
    } else {
        nodes32_ = large_array<float>(count_ + node_padding);
        make_nodes(header_, nodes32_.get());
        if (header_.tile > 0)
            make_nodes(tile, nodes32_.get() + tile_start);
    }
}

float FractalLattice::node(int x, int y, int z) const {
    const int nodes = side() + 1;
    assert(x >= 0 && y >= 0 && z >= 0 && std::max({x, y, z}) < nodes);
    const auto at = static_cast<std::size_t>(x + nodes * (y + nodes * z));
    return nodes32_ ? nodes32_[at] : header_.step * static_cast<float>(nodes16_[at]);
}

double mean_square_of_level() {
    // In each half of an axis the weights are products of linear functions, so their squares have
    // degree 2 per axis, for which Gauss's two-point rule (exact up to degree 3) is exact.
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
                    for (float& g : unit) { // variances of independent variates add
                        g = 1;
                        const double weight = double(solid::field_of_variates(unit, wx, wy, wz));
                        sum += weight * weight / 64;
                        g = 0;
                    }
                }
        return sum;
    }();
    return mean;
}

} // namespace scree
