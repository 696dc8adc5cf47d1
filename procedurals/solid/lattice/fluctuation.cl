// SPDX-License-Identifier: GPL-3.0-or-later
// The levels of lattice.cl added up, each as far as a filter resolves it. OpenCL C 1.2 that is C++
// as well.

// The field of stored nodes with `levels` levels, evaluated up to `level`, at a point of the unit
// cube, or anywhere if it is periodic. The first node has index `at`.
static inline Fluctuation nodes_field(global const short* nodes16, global const float* nodes32,
                                      int at, float step, int levels, int level, Triple p) {
    const float cells = (float)(1 << level);
    const float x = p.x * cells, y = p.y * cells, z = p.z * cells;
    const float cx = floor(x), cy = floor(y), cz = floor(z);
    const int mask = (1 << level) - 1;
    const int stride = 1 << (levels - level); // NOLINT: no caller asks for a level beyond the last
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
                        : lattice->amplitude[0] * node_normal(lattice->key_a, lattice->key_b, 0U,
                                                              (uint)((int)cx + (corner & 1)),
                                                              (uint)((int)cy + ((corner >> 1) & 1)),
                                                              (uint)((int)cz + (corner >> 2)));
    return trilinear(v, p.x - cx, p.y - cy, p.z - cz, 1.0f);
}

static inline void add_field(Fluctuation* sum, Fluctuation field, float share) {
    sum->value += field.value * share;
    sum->gradient = plus(sum->gradient, scaled(field.gradient, share));
}

// Adds a field that was evaluated at `scale` times the position.
static inline void add_scaled(Fluctuation* sum, Fluctuation field, float share, float scale) {
    sum->value += field.value * share;
    sum->gradient = plus(sum->gradient, scaled(field.gradient, share * scale));
}

// Adds the levels `first` to `last`, and a share of the next one.
static inline void add_levels_plainly(global const Lattice* lattice, int first, int last,
                                      float share, Triple p, Fluctuation* sum) {
    for (int level = first; level <= last; ++level)
        add_field(sum, level_field(lattice, level, p), lattice->amplitude[level]);
    if (share > 0.0f)
        add_field(sum, level_field(lattice, last + 1, p), share * lattice->amplitude[last + 1]);
}
#ifndef __OPENCL_VERSION__ // in vectors, to the same bits: levels_vector.cpp
void add_levels(const Lattice* lattice, int first, int last, float share, Triple p,
                Fluctuation* sum);
#else
#define add_levels add_levels_plainly
#endif

// Adds the levels beyond the unique ones up to `last`, and a share of the next, three levels at a
// time from the tile.
static inline void add_tile(global const Lattice* lattice, global const short* nodes16,
                            global const float* nodes32, int last, float share, Triple p,
                            Fluctuation* sum) {
    float scale = (float)(1 << (lattice->unique_levels - TILE_COARSE));
    for (int base = lattice->unique_levels; base < last || (base == last && share > 0.0f);
         base += TILE_LEVELS, scale *= (float)(1 << TILE_LEVELS)) {
        const int count = last - base < TILE_LEVELS ? last - base : TILE_LEVELS;
        const float next = count < TILE_LEVELS ? share : 0.0f;
        const float amplitude = lattice->amplitude[base + 1];
        const Triple place = scaled(p, scale);
        if (count > 0)
            add_scaled(sum,
                       nodes_field(nodes16, nodes32, lattice->tile, lattice->tile_step,
                                   TILE_COARSE + TILE_LEVELS, TILE_COARSE + count, place),
                       amplitude * (1.0f - next), scale);
        if (next > 0.0f)
            add_scaled(sum,
                       nodes_field(nodes16, nodes32, lattice->tile, lattice->tile_step,
                                   TILE_COARSE + TILE_LEVELS, TILE_COARSE + count + 1, place),
                       amplitude * next, scale);
    }
}

// Whether the unit cube of a point is stored.
static inline int is_stored(global const Lattice* lattice, Triple p) {
    return lattice->levels > 0 &&
           (lattice->repeats || (floor(p.x) == 0.0f && floor(p.y) == 0.0f && floor(p.z) == 0.0f));
}

// Base 2 logarithm of a normalised float with an error below 0.008; exact at powers of 2 and
// continuous.
static inline float rough_log2(float v) {
    const int bits = as_int(v);
    const float t = as_float((bits & 0x7fffff) | 0x3f800000) - 1.0f;
    return (float)((bits >> 23) - 127) + t + 0.3437f * t * (1.0f - t);
}

// The number of levels that a filter of `width` resolves, whose fraction is the share of the next
// level. A level is resolved completely if its cells are at least 0.7 times as wide as the filter;
// of the factors tried in steps of half a level, this comes closest to means of 4096 points.
static inline float resolved_level(global const Lattice* lattice, float width) {
    const float finest = (float)lattice->finest;
    if (!(width > 0.0f))
        return finest;
    const float level = clamped(0.5f - rough_log2(width), 0.0f, finest);
    // Levels of the tile are not blended: they are too weak for a step to be visible.
    return level < (float)lattice->unique_levels ? level : floor(level + 0.5f);
}

// The point wrapped into the first cube if the lattice is periodic, otherwise clamped to the range
// of int.
static inline Triple into_domain(global const Lattice* lattice, Triple p) {
    if (lattice->repeats)
        return triple(p.x - floor(p.x), p.y - floor(p.y), p.z - floor(p.z));
    const float limit = (float)(1 << (30 - lattice->finest));
    return triple(fmin(fmax(p.x, -limit), limit), fmin(fmax(p.y, -limit), limit),
                  fmin(fmax(p.z, -limit), limit));
}

// D at a point, filtered with a width in unit cubes: the sum of the levels that the filter
// resolves, and the variance of the others.
static inline Fluctuation fluctuation(global const Lattice* lattice, global const short* nodes16,
                                      global const float* nodes32, Triple p, float width) {
    const float resolved = resolved_level(lattice, width);
    p = into_domain(lattice, p);
    const int whole = (int)resolved;
    const float share = resolved - (float)whole;
    const int stored = is_stored(lattice, p);
    Fluctuation sum;
    int done = 0;
    float rest = share; // share of the next level that is not added yet
    if (stored) {
        done = whole < lattice->levels ? whole : lattice->levels;
        sum = stored_field(lattice, nodes16, nodes32, done, p);
        if (whole < lattice->levels) {
            rest = 0.0f;
            if (share > 0.0f) {
                const Fluctuation finer = stored_field(lattice, nodes16, nodes32, done + 1, p);
                sum.value = lerp(sum.value, finer.value, share);
                sum.gradient =
                    plus(scaled(sum.gradient, 1.0f - share), scaled(finer.gradient, share));
            }
        }
    } else {
        sum = corner_field(lattice, p);
    }
    const int without_tile = whole < lattice->unique_levels;
    const int last = without_tile ? whole : lattice->unique_levels;
    if (done < last || (without_tile && rest > 0.0f))
        add_levels(lattice, done + 1, last, without_tile ? rest : 0.0f, p, &sum);
    if (!without_tile)
        add_tile(lattice, nodes16, nodes32, whole, rest, p, &sum);
    // A share a of a level is its mean over the filter, with a^2 of its variance; the rest of its
    // variance lies within the filter.
    const float next = whole < lattice->finest ? lattice->amplitude[whole + 1] : 0.0f;
    sum.variance =
        lattice->residual_variance[whole] - share * share * next * next * lattice->mean_square;
    return sum;
}
