// SPDX-License-Identifier: GPL-3.0-or-later
// Included by lattice_text.h: the trilinear field of one cell, four lanes at a time. The same
// operations in the same order as cell_field_plainly, so the same bits.

using Lanes = float __attribute__((vector_size(16)));
using Ints = std::int32_t __attribute__((vector_size(16)));

// What both ends of the cell's four edges along x hold.
struct CellEnds {
    Lanes low, high;
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
        Ints low, high;
        if (stride == 1 && std::endian::native == std::endian::little) {
            const Ints both = {two_shorts(n), two_shorts(n + y), two_shorts(n + z),
                               two_shorts(n + z + y)};
            low = (both << 16) >> 16;
            high = both >> 16;
        } else {
            const short* m = n + stride;
            low = Ints{n[0], n[y], n[z], n[z + y]};
            high = Ints{m[0], m[y], m[z], m[z + y]};
        }
        return {step * __builtin_convertvector(low, Lanes),
                step * __builtin_convertvector(high, Lanes)};
    }
    const float *n = nodes32 + first, *m = n + stride;
    return {Lanes{n[0], n[y], n[z], n[z + y]}, Lanes{m[0], m[y], m[z], m[z + y]}};
}

inline Fluctuation cell_field(const short* nodes16, const float* nodes32, int first, int stride,
                              int side, float step, Triple in, float cells) {
    const CellEnds ends = cell_ends(nodes16, nodes32, first, stride, side, step);
    const Lanes across = ends.high - ends.low;
    const Lanes along = ends.low + across * in.x;
    // The edges at the cell's near y and those at its far y: values, then slopes along x.
    const Lanes near_y = __builtin_shufflevector(along, across, 0, 2, 4, 6);
    const Lanes far_y = __builtin_shufflevector(along, across, 1, 3, 5, 7);
    const Lanes rise = far_y - near_y;
    const Lanes faces = near_y + rise * in.y; // value near and far, slope along x near and far
    // Lanes: value, slopes along x and y, from the near face to the far one.
    const Lanes near_z = __builtin_shufflevector(faces, rise, 0, 2, 4, 4);
    const Lanes far_z = __builtin_shufflevector(faces, rise, 1, 3, 5, 5);
    const Lanes climb = far_z - near_z;
    const Lanes found = near_z + climb * in.z;
    return {found[0], scaled(triple(found[1], found[2], climb[0]), cells), 0.0F};
}
