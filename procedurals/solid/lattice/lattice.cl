// SPDX-License-Identifier: GPL-3.0-or-later
// The 3-D random fractal of Okada, Yokoi, Toriwaki & Hori (1987) as both the host and OpenCL
// devices evaluate it: OpenCL C 1.2 that is C++ as well (see core/kernel_as_cpp.h).
//
// The lattice divides a unit cube into cells, which are halved from level to level. A node that
// first appears on level n is the mean of its neighbours plus g L_n with a normal variate g and L_n
// = exp(-(n - 1) beta) (eqs. 1-5). The neighbours of an edge's midpoint are its 2 ends, those of a
// face's centre the 4 midpoints of its edges, those of a cube's centre its 6 face centres.
// Trilinear interpolation of the coarser level gives the same means. So the fractal is the sum over
// levels of trilinear fields T_n that are zero at older nodes, and each level can be evaluated
// separately.

typedef struct {
    float x, y, z;
} Triple;

#define LATTICE_MAX_LEVELS 24

typedef struct {
    uint key_a, key_b;                   // of the seed
    uint repeats;                        // 1: periodic; 0: every unit cube is different
    int levels;                          // stored levels
    int finest;                          // all levels; those not stored are evaluated on demand
    int unique_levels;                   // levels whose nodes all have independent variates
    int level_offset;                    // added to a level to get its variates; for the tile
    float step;                          // unit of 16-bit nodes; 0: nodes are floats
    int tile;                            // index of the tile's first node; 0: no tile
    float tile_step;                     // unit of its 16-bit nodes
    float amplitude[LATTICE_MAX_LEVELS]; // L_n of level n; 0 beyond `finest`
    float residual_variance[LATTICE_MAX_LEVELS]; // variance of the sum of all levels finer than n
    float mean_square;                           // of T_n / L_n over space
} Lattice;

typedef struct {
    float value;
    Triple gradient; // per unit of the cube
    float variance;  // within the filter: of the levels that it does not resolve
} Fluctuation;

static inline Triple triple(float x, float y, float z) {
    Triple t;
    t.x = x;
    t.y = y;
    t.z = z;
    return t;
}

static inline Triple plus(Triple a, Triple b) { return triple(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline Triple minus(Triple a, Triple b) { return triple(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline Triple scaled(Triple a, float s) { return triple(a.x * s, a.y * s, a.z * s); }
static inline float dot3(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline float lerp(float a, float b, float share) { return a + (b - a) * share; }
static inline float clamped(float v, float low, float high) { return fmin(fmax(v, low), high); }

// A bijective hash of 32 bits (Wellons 2018, lowbias32).
static inline uint scramble(uint h) {
    h = (h ^ (h >> 16)) * 0x7feb352dU;
    h = (h ^ (h >> 15)) * 0x846ca68bU;
    return h ^ (h >> 16);
}

// The part of the hash that is common to the nodes of a row along x.
static inline uint row_bits(uint key_a, uint level, uint y, uint z) {
    const uint h = scramble(key_a + y * 0x9e3779b9U);
    return scramble(h ^ (z * 0x85ebca6bU + level * 0xc2b2ae35U));
}

// A node's 32 random bits. `other` enters half-way, so that rows with similar bits do not have
// shifted copies of the same numbers.
static inline uint node_bits(uint row, uint other, uint x) {
    uint h = x * 0x9e3779b1U + row;
    h = (h ^ (h >> 16)) * 0x7feb352dU;
    h = ((h ^ other) ^ (h >> 15)) * 0x846ca68bU;
    return h ^ (h >> 16);
}

// Natural logarithm of a normalised float with an error of at most 2 ulp (polynomial of Moshier's
// Cephes, 1989). Not the library's, and without fused multiply-add, so that the lattice is the same
// on every machine.
static inline float plain_log(float v) {
    const int exponent = (as_int(v) - 0x3f3504f3) >> 23;
    const float f = as_float(as_int(v) - (int)((uint)exponent << 23)) - 1.0f;
    float p = 7.0376836292e-2f;
    p = p * f - 1.1514610310e-1f;
    p = p * f + 1.1676998740e-1f;
    p = p * f - 1.2420140846e-1f;
    p = p * f + 1.4249322787e-1f;
    p = p * f - 1.6668057665e-1f;
    p = p * f + 2.0000714765e-1f;
    p = p * f - 2.4999993993e-1f;
    p = p * f + 3.3333331174e-1f;
    const float e = (float)exponent;
    const float squared = f * f;
    return (f * squared * p - 2.12194440e-4f * e - 0.5f * squared + f) + 0.693359375f * e;
}

// A standard normal variate from 24 of the bits by the inverse distribution function (Giles 2010,
// "Approximating the erfinv function"); its absolute value is at most 5.42.
static inline float normal_variate(uint bits) {
    const float x = (float)((int)((bits >> 8) * 2U + 1U) - 0x1000000) * 0x1p-24f; // exact, odd
    const float w = -plain_log((1.0f - x) * (1.0f + x));
    const float a = w - 2.5f;
    float p = 2.81022636e-08f;
    p = p * a + 3.43273939e-07f;
    p = p * a - 3.5233877e-06f;
    p = p * a - 4.39150654e-06f;
    p = p * a + 0.00021858087f;
    p = p * a - 0.00125372503f;
    p = p * a - 0.00417768164f;
    p = p * a + 0.246640727f;
    p = p * a + 1.50140941f;
    const float b = sqrt(w) - 3.0f;
    float q = -0.000200214257f;
    q = q * b + 0.000100950558f;
    q = q * b + 0.00134934322f;
    q = q * b - 0.00367342844f;
    q = q * b + 0.00573950773f;
    q = q * b - 0.0076224613f;
    q = q * b + 0.00943887047f;
    q = q * b + 1.00167406f;
    q = q * b + 2.83297682f;
    return 1.41421356f * (w < 5.0f ? p : q) * x;
}

// The variate g of the node (x, y, z) that first appears on `level`, in units of that level's
// cells.
static inline float node_normal(uint key_a, uint key_b, uint level, uint x, uint y, uint z) {
    const uint row = row_bits(key_a, level, y, z);
    return normal_variate(node_bits(row, scramble(row + key_b), x));
}

// Levels beyond the first `unique_levels` are too fine for repetition to be visible. The next three
// are periodic with a period of 8 cells of the last unique level; every following three are the
// same three scaled down by 8. So one small tile of nodes holds all further detail.
#define TILE_COARSE 3 // log2 of the tile's width in cells of the last unique level
#define TILE_LEVELS 3

// The level whose random numbers a level uses.
static inline int source_level(global const Lattice* lattice, int level) {
    level += lattice->level_offset;
    return level <= lattice->unique_levels
               ? level
               : lattice->unique_levels + 1 + (level - lattice->unique_levels - 1) % TILE_LEVELS;
}

// Bit mask that reduces the node coordinates of a level to one period.
static inline uint node_mask(global const Lattice* lattice, int level) {
    if (level > lattice->unique_levels)
        return (1U << (source_level(lattice, level) - lattice->unique_levels + TILE_COARSE)) - 1U;
    return lattice->repeats ? (1U << level) - 1U : 0xffffffffU;
}

// Weights of the three nodes of a cell along an axis (both ends and the middle) and their
// derivatives.
static inline void axis_weights(float f, float* w, float* slope) {
    const float t = 2.0f * f - 1.0f; // -1 to 1
    w[0] = t < 0.0f ? -t : 0.0f;
    w[2] = t < 0.0f ? 0.0f : t;
    w[1] = 1.0f - w[0] - w[2];
    slope[0] = t < 0.0f ? -2.0f : 0.0f;
    slope[2] = t < 0.0f ? 0.0f : 2.0f;
    slope[1] = -slope[0] - slope[2];
}

// The value of a cell's field from its 19 independent variates, where its 27 nodes have the weights
// x y z. The cube's centre is a mean of the six face centres plus a variate, each face centre a
// mean of its four edges plus a variate. Node (i, j, k) has variate number i + 3 j + 9 k; corners
// have none.
static inline float field_of_variates(const float* g, const float* x, const float* y,
                                      const float* z) {
    float faces[3][2]; // across x, y, z; near and far
    const float centre = x[1] * y[1] * z[1];
    const float share = centre * (1.0f / 6.0f);
    float sum = centre * g[13];
    for (int side = 0; side < 2; ++side) {
        const int at = 2 * side;
        faces[0][side] = x[at] * y[1] * z[1] + share;
        faces[1][side] = x[1] * y[at] * z[1] + share;
        faces[2][side] = x[1] * y[1] * z[at] + share;
        sum += faces[0][side] * g[at + 12] + faces[1][side] * g[3 * at + 10] +
               faces[2][side] * g[9 * at + 4];
    }
    for (int b = 0; b < 2; ++b)
        for (int a = 0; a < 2; ++a) {
            const int i = 2 * a, j = 2 * b;
            sum +=
                (x[1] * y[i] * z[j] + 0.25f * (faces[1][a] + faces[2][b])) * g[1 + 3 * i + 9 * j];
            sum += (x[i] * y[1] * z[j] + 0.25f * (faces[0][a] + faces[2][b])) * g[i + 3 + 9 * j];
            sum += (x[i] * y[j] * z[1] + 0.25f * (faces[0][a] + faces[1][b])) * g[i + 3 * j + 9];
        }
    return sum;
}

// The variates of the 27 nodes of a cell on the next level (including the corners, which are not
// used).
static inline void cell_normals(global const Lattice* lattice, int level, int cx, int cy, int cz,
                                float* g) {
    const uint mask = node_mask(lattice, level);
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) {
            const uint row = row_bits(lattice->key_a, (uint)source_level(lattice, level),
                                      (uint)(2 * cy + j) & mask, (uint)(2 * cz + k) & mask);
            const uint other = scramble(row + lattice->key_b);
            for (int i = 0; i < 3; ++i)
                g[i + 3 * j + 9 * k] =
                    normal_variate(node_bits(row, other, (uint)(2 * cx + i) & mask));
        }
}

// T_level / L_level at a point, computed without stored nodes; level >= 1.
static inline Fluctuation level_field(global const Lattice* lattice, int level, Triple p) {
    const float cells = (float)(1 << (level - 1));
    const float x = p.x * cells, y = p.y * cells, z = p.z * cells;
    const float cx = floor(x), cy = floor(y), cz = floor(z);
    float wx[3], wy[3], wz[3], sx[3], sy[3], sz[3];
    axis_weights(x - cx, wx, sx);
    axis_weights(y - cy, wy, sy);
    axis_weights(z - cz, wz, sz);
    float g[27];
    cell_normals(lattice, level, (int)cx, (int)cy, (int)cz, g);
    Fluctuation found;
    found.value = field_of_variates(g, wx, wy, wz);
    found.gradient =
        scaled(triple(field_of_variates(g, sx, wy, wz), field_of_variates(g, wx, sy, wz),
                      field_of_variates(g, wx, wy, sz)),
               cells);
    found.variance = 0.0f;
    return found;
}

// Value and gradient of the trilinear field with the 8 corners `v` (x fastest) at (fx, fy, fz) in a
// cell of width 1 / cells (eq. 6).
static inline Fluctuation trilinear(const float* v, float fx, float fy, float fz, float cells) {
    const float a = lerp(v[0], v[1], fx), b = lerp(v[2], v[3], fx);
    const float c = lerp(v[4], v[5], fx), d = lerp(v[6], v[7], fx);
    const float near = lerp(a, b, fy), far = lerp(c, d, fy);
    const float dx_near = lerp(v[1] - v[0], v[3] - v[2], fy);
    const float dx_far = lerp(v[5] - v[4], v[7] - v[6], fy);
    Fluctuation found;
    found.value = lerp(near, far, fz);
    found.gradient =
        scaled(triple(lerp(dx_near, dx_far, fz), lerp(b - a, d - c, fz), far - near), cells);
    found.variance = 0.0f;
    return found;
}

// The trilinear field at `in` (0 to 1) in a cell of width 1 / cells. Its first node has index
// `first`; adjacent nodes are `stride` apart in a cube of `side` nodes per axis. 16-bit nodes are
// in units of `step`.
static inline Fluctuation cell_field_plainly(global const short* nodes16,
                                             global const float* nodes32, int first, int stride,
                                             int side, float step, Triple in, float cells) {
    float v[8];
    for (int corner = 0; corner < 8; ++corner) {
        const int node =
            first + stride * ((corner & 1) + side * (((corner >> 1) & 1) + side * (corner >> 2)));
        v[corner] = step > 0.0f ? step * (float)nodes16[node] : nodes32[node];
    }
    return trilinear(v, in.x, in.y, in.z, cells);
}
#ifndef __OPENCL_VERSION__ // in vectors, to the same bits: cell_vector.h
inline Fluctuation cell_field(const short* nodes16, const float* nodes32, int first, int stride,
                              int side, float step, Triple in, float cells);
#else
#define cell_field cell_field_plainly
#endif
