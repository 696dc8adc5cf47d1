// SPDX-License-Identifier: GPL-3.0-or-later
// The 3-D random fractal of Okada, Yokoi, Toriwaki & Hori (1987) as both the host and OpenCL
// devices evaluate it: OpenCL C 1.2 that is C++ as well (see core/kernel_as_cpp.h).
//
// The lattice covers one unit cube by cells that are halved level after level. A node that first
// appears on level n is the mean of its neighbours plus g L_n with g normal and L_n =
// exp(-(n - 1) beta) (eqs. 1-5): an edge's midpoint of its 2 ends, a face's centre of the 4 edge
// midpoints around it, a cube's centre of its 6 face centres. As these means are what trilinear
// interpolation of the coarser level answers, the fractal is the sum over the levels of trilinear
// fields T_n that are zero at older nodes, and each level can be had without the others.

typedef struct {
    float x, y, z;
} Triple;

#define LATTICE_MOST_LEVELS 24

typedef struct {
    uint key_a, key_b;                   // of the seed
    uint repeats;                        // 1: goes on periodically; 0: anew in every unit cube
    int levels;                          // that are stored
    int finest;                          // that exist: the others are evaluated on demand
    int own;                             // levels whose every node is drawn by itself
    int drawn_from;                      // levels are drawn as those so much finer: of the tile
    float step;                          // of 16-bit nodes; 0: nodes are floats
    int tile;                            // where the tile's nodes begin behind the others; 0: none
    float tile_step;                     // of its 16-bit nodes
    float spread[LATTICE_MOST_LEVELS];   // L_n, for level n; 0 beyond `finest`
    float left_out[LATTICE_MOST_LEVELS]; // mean variance of all levels above n together
    float mean_square;                   // of T_n / L_n over space
} Lattice;

typedef struct {
    float value;
    Triple gradient; // per unit of the cube
    float variance;  // within the filter, of levels that it does not resolve
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
static inline float inner(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline float mixed(float a, float b, float share) { return a + (b - a) * share; }
static inline float limited(float v, float low, float high) { return fmin(fmax(v, low), high); }

// A bijection that spreads every bit over all (Wellons 2018, lowbias32).
static inline uint scramble(uint h) {
    h = (h ^ (h >> 16)) * 0x7feb352dU;
    h = (h ^ (h >> 15)) * 0x846ca68bU;
    return h ^ (h >> 16);
}

// What the nodes of one row along x share.
static inline uint row_bits(uint key_a, uint level, uint y, uint z) {
    const uint h = scramble(key_a + y * 0x9e3779b9U);
    return scramble(h ^ (z * 0x85ebca6bU + level * 0xc2b2ae35U));
}

// A node's 32 random bits. `other` enters half-way, so that rows whose bits differ by little do
// not hold the same numbers side by side.
static inline uint node_bits(uint row, uint other, uint x) {
    uint h = x * 0x9e3779b1U + row;
    h = (h ^ (h >> 16)) * 0x7feb352dU;
    h = ((h ^ other) ^ (h >> 15)) * 0x846ca68bU;
    return h ^ (h >> 16);
}

// Natural logarithm of a normal number to 2 ulp (the polynomial is that of Moshier's Cephes, 1989).
// Our own, and without fused multiplication, so that every machine finds the same lattice.
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

// A normal variate of mean 0 and variance 1 from 24 of the bits, by the inverse of the normal
// distribution (Giles 2010, "Approximating the erfinv function"); its size is at most 5.42.
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

// g of the node (x, y, z) that first appears on `level`, in units of that level's cells.
static inline float node_normal(uint key_a, uint key_b, uint level, uint x, uint y, uint z) {
    const uint row = row_bits(key_a, level, y, z);
    return normal_variate(node_bits(row, scramble(row + key_b), x));
}

// Beyond its `own` levels a lattice is too fine for anyone to see that it repeats: the next three
// do so after 8 cells of the last own one, and every three that follow are these three once more, 8
// times smaller. So one small tile of nodes holds all detail there is.
#define TILE_COARSE 3 // log2 of the tile's width in cells of the last own level
#define TILE_LEVELS 3

// The level whose random numbers a level has.
static inline int drawn_level(global const Lattice* lattice, int level) {
    level += lattice->drawn_from;
    return level <= lattice->own ? level
                                 : lattice->own + 1 + (level - lattice->own - 1) % TILE_LEVELS;
}

// Coordinates of nodes of a level: those of one period, or all there are.
static inline uint node_mask(global const Lattice* lattice, int level) {
    if (level > lattice->own)
        return (1U << (drawn_level(lattice, level) - lattice->own + TILE_COARSE)) - 1U;
    return lattice->repeats ? (1U << level) - 1U : 0xffffffffU;
}

// Weights of a cell's three nodes along an axis, of its ends and its middle, and their slopes.
static inline void axis_weights(float f, float* w, float* slope) {
    const float t = 2.0f * f - 1.0f; // -1 to 1
    w[0] = t < 0.0f ? -t : 0.0f;
    w[2] = t < 0.0f ? 0.0f : t;
    w[1] = 1.0f - w[0] - w[2];
    slope[0] = t < 0.0f ? -2.0f : 0.0f;
    slope[2] = t < 0.0f ? 0.0f : 2.0f;
    slope[1] = -slope[0] - slope[2];
}

// Adds what 19 independent variates mean to a field whose 27 nodes have the weights x y z: the
// cube's centre leans on the six faces, these on their four edges each. Node (i, j, k) is variate
// number i + 3 j + 9 k; corners have none.
static inline float carried(const float* g, const float* x, const float* y, const float* z) {
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

// The 27 nodes' variates of the level below a cell (corners' too, which nobody asks).
static inline void cell_normals(global const Lattice* lattice, int level, int cx, int cy, int cz,
                                float* g) {
    const uint mask = node_mask(lattice, level);
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) {
            const uint row = row_bits(lattice->key_a, (uint)drawn_level(lattice, level),
                                      (uint)(2 * cy + j) & mask, (uint)(2 * cz + k) & mask);
            const uint other = scramble(row + lattice->key_b);
            for (int i = 0; i < 3; ++i)
                g[i + 3 * j + 9 * k] =
                    normal_variate(node_bits(row, other, (uint)(2 * cx + i) & mask));
        }
}

// T_level / L_level at a place of the unit cube (or of space), without any storage; level >= 1.
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
    found.value = carried(g, wx, wy, wz);
    found.gradient = scaled(
        triple(carried(g, sx, wy, wz), carried(g, wx, sy, wz), carried(g, wx, wy, sz)), cells);
    found.variance = 0.0f;
    return found;
}

// Value and gradient of the trilinear field with these 8 corners (x first) at (fx, fy, fz), where
// the cell is 1 / cells wide (eq. 6).
static inline Fluctuation trilinear(const float* v, float fx, float fy, float fz, float cells) {
    const float a = mixed(v[0], v[1], fx), b = mixed(v[2], v[3], fx);
    const float c = mixed(v[4], v[5], fx), d = mixed(v[6], v[7], fx);
    const float near = mixed(a, b, fy), far = mixed(c, d, fy);
    const float dx_near = mixed(v[1] - v[0], v[3] - v[2], fy);
    const float dx_far = mixed(v[5] - v[4], v[7] - v[6], fy);
    Fluctuation found;
    found.value = mixed(near, far, fz);
    found.gradient =
        scaled(triple(mixed(dx_near, dx_far, fz), mixed(b - a, d - c, fz), far - near), cells);
    found.variance = 0.0f;
    return found;
}

// The trilinear field at the place `in` (0 to 1) of the cell 1 / cells wide whose first node is
// number `first`, the next one `stride` farther, of a cube of `side` nodes. Nodes of 16 bits count
// by `step`.
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

// Stored nodes with their levels up to `level`, of `levels`, at a place of the unit cube, or of
// space where it repeats. The first node is number `at`.
static inline Fluctuation nodes_field(global const short* nodes16, global const float* nodes32,
                                      int at, float step, int levels, int level, Triple p) {
    const float cells = (float)(1 << level);
    const float x = p.x * cells, y = p.y * cells, z = p.z * cells;
    const float cx = floor(x), cy = floor(y), cz = floor(z);
    const int mask = (1 << level) - 1;
    const int stride = 1 << (levels - level);
    const int side = (1 << levels) + 1;
    const int first =
        at + stride * (((int)cx & mask) + side * (((int)cy & mask) + side * ((int)cz & mask)));
    return cell_field(nodes16, nodes32, first, stride, side, step, triple(x - cx, y - cy, z - cz),
                      cells);
}

static inline Fluctuation stored_field(global const Lattice* lattice, global const short* nodes16,
                                       global const float* nodes32, int level, Triple p) {
    return nodes_field(nodes16, nodes32, 0, lattice->step, lattice->levels, level, p);
}

// Level 0: the corners of all unit cubes.
static inline Fluctuation corner_field(global const Lattice* lattice, Triple p) {
    const float cx = floor(p.x), cy = floor(p.y), cz = floor(p.z);
    float v[8];
    for (int corner = 0; corner < 8; ++corner)
        v[corner] = lattice->repeats
                        ? 0.0f
                        : lattice->spread[0] * node_normal(lattice->key_a, lattice->key_b, 0U,
                                                           (uint)((int)cx + (corner & 1)),
                                                           (uint)((int)cy + ((corner >> 1) & 1)),
                                                           (uint)((int)cz + (corner >> 2)));
    return trilinear(v, p.x - cx, p.y - cy, p.z - cz, 1.0f);
}

static inline void add_field(Fluctuation* sum, Fluctuation field, float share) {
    sum->value += field.value * share;
    sum->gradient = plus(sum->gradient, scaled(field.gradient, share));
}

// Adds a field of places that are so many times as large.
static inline void add_scaled(Fluctuation* sum, Fluctuation field, float share, float scale) {
    sum->value += field.value * share;
    sum->gradient = plus(sum->gradient, scaled(field.gradient, share * scale));
}

// Adds the levels `first` to `last`, and a share of the next one.
static inline void add_levels_plainly(global const Lattice* lattice, int first, int last,
                                      float share, Triple p, Fluctuation* sum) {
    for (int level = first; level <= last; ++level)
        add_field(sum, level_field(lattice, level, p), lattice->spread[level]);
    if (share > 0.0f)
        add_field(sum, level_field(lattice, last + 1, p), share * lattice->spread[last + 1]);
}
#ifndef __OPENCL_VERSION__ // in vectors, to the same bits: levels_vector.cpp
void add_levels(const Lattice* lattice, int first, int last, float share, Triple p,
                Fluctuation* sum);
#else
#define add_levels add_levels_plainly
#endif

// Adds the levels from the first that is not the lattice's own to `last` likewise, three at a time
// from the tile.
static inline void add_tile(global const Lattice* lattice, global const short* nodes16,
                            global const float* nodes32, int last, float share, Triple p,
                            Fluctuation* sum) {
    float scale = (float)(1 << (lattice->own - TILE_COARSE));
    for (int base = lattice->own; base < last || (base == last && share > 0.0f);
         base += TILE_LEVELS, scale *= (float)(1 << TILE_LEVELS)) {
        const int most = last - base < TILE_LEVELS ? last - base : TILE_LEVELS;
        const float next = most < TILE_LEVELS ? share : 0.0f;
        const float spread = lattice->spread[base + 1];
        const Triple place = scaled(p, scale);
        if (most > 0)
            add_scaled(sum,
                       nodes_field(nodes16, nodes32, lattice->tile, lattice->tile_step,
                                   TILE_COARSE + TILE_LEVELS, TILE_COARSE + most, place),
                       spread * (1.0f - next), scale);
        if (next > 0.0f)
            add_scaled(sum,
                       nodes_field(nodes16, nodes32, lattice->tile, lattice->tile_step,
                                   TILE_COARSE + TILE_LEVELS, TILE_COARSE + most + 1, place),
                       spread * next, scale);
    }
}

// Whether the stored nodes hold the cube of a place.
static inline int is_stored(global const Lattice* lattice, Triple p) {
    return lattice->levels > 0 &&
           (lattice->repeats || (floor(p.x) == 0.0f && floor(p.y) == 0.0f && floor(p.z) == 0.0f));
}

// The logarithm to base 2 of a normal number within 0.008, exact at powers of 2 and continuous.
static inline float rough_log2(float v) {
    const int bits = as_int(v);
    const float t = as_float((bits & 0x7fffff) | 0x3f800000) - 1.0f;
    return (float)((bits >> 23) - 127) + t + 0.3437f * t * (1.0f - t);
}

// The levels that a filter `width` wide leaves whole, and a share of the next: a real number. A
// cell is whole that is 0.7 times as wide as the filter or wider, which comes nearest to means of
// 4096 points (tried in steps of half a level).
static inline float resolved_level(global const Lattice* lattice, float width) {
    const float most = (float)lattice->finest;
    if (!(width > 0.0f))
        return most;
    const float level = limited(0.5f - rough_log2(width), 0.0f, most);
    // Levels of the tile come and go whole: they are too weak for that to be seen.
    return level < (float)lattice->own ? level : floor(level + 0.5f);
}

// The same place of the first cube where it repeats; otherwise within what integers can count.
static inline Triple within_reach(global const Lattice* lattice, Triple p) {
    if (lattice->repeats)
        return triple(p.x - floor(p.x), p.y - floor(p.y), p.z - floor(p.z));
    const float most = (float)(1 << (30 - lattice->finest));
    return triple(fmin(fmax(p.x, -most), most), fmin(fmax(p.y, -most), most),
                  fmin(fmax(p.z, -most), most));
}

// D at a place seen through a filter of that width (in unit cubes): the levels that the filter
// resolves, and the variance of those that it does not.
static inline Fluctuation fluctuation(global const Lattice* lattice, global const short* nodes16,
                                      global const float* nodes32, Triple p, float width) {
    const float resolved = resolved_level(lattice, width);
    p = within_reach(lattice, p);
    const int whole = (int)resolved;
    const float share = resolved - (float)whole;
    const int stored = is_stored(lattice, p);
    Fluctuation sum;
    int done = 0;
    float rest = share; // which is left to take: where not of the stored levels, of what follows
    if (stored) {
        done = whole < lattice->levels ? whole : lattice->levels;
        sum = stored_field(lattice, nodes16, nodes32, done, p);
        if (whole < lattice->levels) {
            rest = 0.0f;
            if (share > 0.0f) {
                const Fluctuation finer = stored_field(lattice, nodes16, nodes32, done + 1, p);
                sum.value = mixed(sum.value, finer.value, share);
                sum.gradient =
                    plus(scaled(sum.gradient, 1.0f - share), scaled(finer.gradient, share));
            }
        }
    } else {
        sum = corner_field(lattice, p);
    }
    const int own = whole < lattice->own;
    if (done < (own ? whole : lattice->own) || (own && rest > 0.0f))
        add_levels(lattice, done + 1, own ? whole : lattice->own, own ? rest : 0.0f, p, &sum);
    if (!own)
        add_tile(lattice, nodes16, nodes32, whole, rest, p, &sum);
    // A level taken by a share a is taken for its mean over the filter, of variance a^2; the rest
    // of its variance lies within.
    const float next = whole < lattice->finest ? lattice->spread[whole + 1] : 0.0f;
    sum.variance = lattice->left_out[whole] - share * share * next * next * lattice->mean_square;
    return sum;
}
