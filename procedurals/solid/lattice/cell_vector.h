// SPDX-License-Identifier: GPL-3.0-or-later
// The lattice's kernel on the host, with the trilinear field of one cell, four lanes at a time: the
// same operations in the same order as cell_field_plainly, so the same bits.
#pragma once

#include "core/float4.h"
#include "procedurals/solid/lattice/lattice_as_cpp.h"

#include <cstring>

namespace scree::solid {

using Int4 = std::int32_t __attribute__((vector_size(16)));

// The nodes at both ends of the cell's four edges along x.
struct CellEnds {
    Float4 low, high;
};

inline std::int32_t two_shorts(const short* p) {
    std::int32_t both;
    std::memcpy(&both, p, sizeof both);
    return both;
}

inline CellEnds cell_ends(const short* nodes16, const float* nodes32, int first, int stride,
                          int side, float step) {
    const int y = stride * side, z = y * side;
    if (step > 0.0F) {
        const short* n = nodes16 + first;
        Int4 low, high;
        if (stride == 1 && std::endian::native == std::endian::little) {
            const Int4 both = {two_shorts(n), two_shorts(n + y), two_shorts(n + z),
                               two_shorts(n + z + y)};
            low = (both << 16) >> 16;
            high = both >> 16;
        } else {
            const short* m = n + stride;
            low = Int4{n[0], n[y], n[z], n[z + y]};
            high = Int4{m[0], m[y], m[z], m[z + y]};
        }
        return {step * __builtin_convertvector(low, Float4),
                step * __builtin_convertvector(high, Float4)};
    }
    const float *n = nodes32 + first, *m = n + stride;
    return {Float4{n[0], n[y], n[z], n[z + y]}, Float4{m[0], m[y], m[z], m[z + y]}};
}

inline Fluctuation cell_field(const short* nodes16, const float* nodes32, int first, int stride,
                              int side, float step, Triple in, float cells) {
    const CellEnds ends = cell_ends(nodes16, nodes32, first, stride, side, step);
    const Float4 across = ends.high - ends.low;
    const Float4 along = ends.low + across * in.x;
    // The edges at the cell's near y and at its far y: values, then slopes along x.
    const Float4 near_y = __builtin_shufflevector(along, across, 0, 2, 4, 6);
    const Float4 far_y = __builtin_shufflevector(along, across, 1, 3, 5, 7);
    const Float4 rise = far_y - near_y;
    const Float4 faces = near_y + rise * in.y; // values, then slopes along x, of near and far z
    // Value, slope along x, slope along y at the near and the far z.
    const Float4 near_z = __builtin_shufflevector(faces, rise, 0, 2, 4, 4);
    const Float4 far_z = __builtin_shufflevector(faces, rise, 1, 3, 5, 5);
    const Float4 climb = far_z - near_z;
    const Float4 found = near_z + climb * in.z;
    return {found[0], scaled(triple(found[1], found[2], climb[0]), cells), 0.0F};
}

} // namespace scree::solid
