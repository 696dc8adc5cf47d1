// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/lattice/lattice_quads.h"

#include "procedurals/solid/lattice/vector_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace scree {

namespace {

using solid::Lattice;
using solid::Triple;

bool is_outside(float v) { return !(v >= 0 && v < 1); }

} // namespace

LatticeQuads::LatticeQuads(const FractalLattice& lattice, int level)
    : lattice_(lattice), level_(level) {
    assert(level >= 0 && level <= lattice.header().levels);
    const int cells = 1 << level, stride = 1 << (lattice.header().levels - level);
    const auto node = [&](int x, int y, int z) {
        return lattice.node(stride * x, stride * y, stride * z);
    };
    float largest = 1e-30F, steepest = 0; // along y
    for (int z = 0; z <= cells; ++z)
        for (int y = 0; y <= cells; ++y)
            for (int x = 0; x <= cells; ++x) {
                largest = std::max(largest, std::abs(node(x, y, z)));
                if (y > 0)
                    steepest = std::max(steepest, std::abs(node(x, y, z) - node(x, y - 1, z)));
            }
    // 16-bit nodes are copied unchanged unless a difference does not fit into 16 bits.
    const bool as_they_are = lattice.header().step > 0 && steepest <= 32767 * lattice.header().step;
    step_ = as_they_are ? lattice.header().step : std::max(largest, steepest) / 32766;
    error_ = (as_they_are ? 0 : 0.5F * step_) + steepest * 0x1p-16F + largest * 0x1p-20F;

    const auto rounded = [inverse = 1 / step_](float v) {
        return static_cast<int>(std::lrint(v * inverse));
    };
    quads_ = large_array<std::int16_t>(4 * std::size_t(cells) * std::size_t(cells) *
                                       std::size_t(cells + 1));
    std::int16_t* quad = quads_.get();
    for (int z = 0; z < cells; ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x <= cells; ++x)
                for (const int plane : {z, z + 1}) {
                    const int value = rounded(node(x, y, plane));
                    *quad++ = static_cast<std::int16_t>(value);
                    *quad++ = static_cast<std::int16_t>(rounded(node(x, y + 1, plane)) - value);
                }
}

// The field outside the first cube of a lattice that is not periodic, where no nodes are stored.
float LatticeQuads::value_outside(const Triple& place) const {
    const Lattice& header = lattice_.header();
    const Triple p = solid::into_domain(&header, place);
    solid::Fluctuation sum = solid::corner_field(&header, p);
    solid::add_levels(&header, 1, level_, 0, p, &sum);
    return sum.value;
}

void LatticeQuads::fluctuations(std::span<const float> x, std::span<const float> y,
                                std::span<const float> z, std::span<float> out) const {
    assert(x.size() == out.size() && y.size() == out.size() && z.size() == out.size());
    const Lattice& header = lattice_.header();
    if (scalar_path_in_use()) {
        for (std::size_t i = 0; i < out.size(); ++i) {
            const Triple p = solid::into_domain(&header, {x[i], y[i], z[i]});
            out[i] = solid::is_stored(&header, p)
                         ? solid::stored_field(&header, lattice_.nodes16().data(),
                                               lattice_.nodes32().data(), level_, p)
                               .value
                         : value_outside(p);
        }
        return;
    }
    vector_fluctuations(*this, x, y, z, out);
    if (header.repeats == 0)
        for (std::size_t i = 0; i < out.size(); ++i)
            if (is_outside(x[i]) || is_outside(y[i]) || is_outside(z[i]))
                out[i] = value_outside({x[i], y[i], z[i]});
}

} // namespace scree
