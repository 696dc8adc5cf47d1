// SPDX-License-Identifier: GPL-3.0-or-later
// Exact squared distances on a pixel grid, and candidate points drawn from them. Integers only, so
// that every device gives the same bytes. OpenCL C that also compiles as C++ (after Bruneton's way
// of testing shaders): see core/kernel_as_cpp.h.

// Bits of a pixel's state.
#define SCREE_OCCUPIED 1U // by a region, or by what lies outside the domain
#define SCREE_EXCLUDED 2U // no candidate may lie here

// Distance in pixels to the nearest occupied pixel of the same column, at most width + height.
// Global size: width. Phase 1 of Meijster, Roerdink & Hesselink 2000.
kernel void scree_column_distance(global const uchar* state, int width, int height,
                                  global int* column_distance) {
    int x = (int)get_global_id(0);
    int none = width + height;
    int run = none;
    for (int y = 0; y < height; ++y) {
        run = (state[y * width + x] & SCREE_OCCUPIED) != 0U ? 0 : (run < none ? run + 1 : none);
        column_distance[y * width + x] = run;
    }
    run = none;
    for (int y = height - 1; y >= 0; --y) {
        int above = column_distance[y * width + x];
        run = above == 0 ? 0 : (run < none ? run + 1 : none);
        if (run < above)
            column_distance[y * width + x] = run;
    }
}

// Squared distance in pixels to the nearest occupied pixel, and its maximum over the row's pixels
// that are not excluded. Global size: height. Phase 2 of Meijster et al.: the lower envelope of one
// parabola per column, kept on a stack of `height` rows of `width` places.
kernel void scree_row_distance(global const uchar* state, global const int* column_distance,
                               int width, global int* stack_column, global int* stack_start,
                               global uint* squared, global uint* row_maximum) {
    int y = (int)get_global_id(0);
    global const int* g = column_distance + y * width;
    global int* s = stack_column + y * width;
    global int* t = stack_start + y * width;
    int top = 0;
    s[0] = 0;
    t[0] = 0;
    for (int u = 1; u < width; ++u) {
        int gu = g[u] * g[u];
        while (top >= 0) {
            int d = t[top] - s[top];
            int e = t[top] - u;
            if (d * d + g[s[top]] * g[s[top]] <= e * e + gu)
                break;
            --top;
        }
        if (top < 0) {
            top = 0;
            s[0] = u;
        } else {
            int i = s[top];
            // Not negative, since the parabola of i is the lower one at t[top] >= 0.
            int start = 1 + (u * u - i * i + gu - g[i] * g[i]) / (2 * (u - i));
            if (start < width) {
                ++top;
                s[top] = u;
                t[top] = start;
            }
        }
    }
    uint maximum = 0U;
    for (int u = width - 1; u >= 0; --u) {
        int d = u - s[top];
        uint value = (uint)(d * d + g[s[top]] * g[s[top]]);
        squared[y * width + u] = value;
        if ((state[y * width + u] & SCREE_EXCLUDED) == 0U && value > maximum)
            maximum = value;
        if (u == t[top])
            --top;
    }
    row_maximum[y] = maximum;
}

// floor(a * b / 2^32)
uint scree_times(uint a, uint b) { return (uint)(((ulong)a * (ulong)b) >> 32); }

// floor(sqrt(a)), bit by bit.
uint scree_root(ulong a) {
    ulong root = 0UL;
    for (int bit = 31; bit >= 0; --bit) {
        ulong next = root | (1UL << bit);
        if (next * next <= a)
            root = next;
    }
    return (uint)root;
}

// (squared / maximum)^(exponent / 2) in units of 2^-32: the probability of a pixel at distance
// sqrt(squared), normalised by the largest one, to the power `exponent` (Sakurai & Miyata 2014,
// section 4.2).
uint scree_probability(uint squared, uint maximum, uint exponent) {
    if (squared >= maximum || exponent == 0U)
        return 0xFFFFFFFFU;
    uint base = (uint)(((ulong)squared << 32) / maximum);
    uint result = (exponent & 1U) != 0U ? scree_root((ulong)base << 32) : 0xFFFFFFFFU;
    for (uint left = exponent >> 1; left != 0U; left >>= 1) {
        if ((left & 1U) != 0U)
            result = scree_times(result, base);
        base = scree_times(base, base);
    }
    return result;
}

// First number of core/random.h's stream (seed, layout_candidate, index): Philox 4x32-10 (Salmon
// et al. 2011).
uint scree_random(ulong seed, ulong index) {
    uint c0 = 0U, c1 = 3U, c2 = (uint)index, c3 = (uint)(index >> 32);
    uint k0 = (uint)seed, k1 = (uint)(seed >> 32);
    for (int round = 0; round < 10; ++round) {
        ulong p0 = (ulong)0xD2511F53U * c0;
        ulong p1 = (ulong)0xCD9E8D57U * c2;
        c0 = (uint)(p1 >> 32) ^ c1 ^ k0;
        c1 = (uint)p1;
        c2 = (uint)(p0 >> 32) ^ c3 ^ k1;
        c3 = (uint)p0;
        k0 += 0x9E3779B9U;
        k1 += 0xBB67AE85U;
    }
    return c0;
}

// Marks the candidates Q: pixels whose random number is below their probability. The paper prints
// "over"; its own next sentence, more points farther away, needs "below". Global size: pixels.
kernel void scree_candidates(global const uchar* state, global const uint* squared, uint maximum,
                             uint exponent, ulong seed, ulong first_index,
                             global uchar* is_candidate) {
    uint i = (uint)get_global_id(0);
    uchar chosen = 0;
    if (state[i] == 0) {
        uint probability = scree_probability(squared[i], maximum, exponent);
        if (probability != 0U && scree_random(seed, first_index + i) < probability)
            chosen = 1;
    }
    is_candidate[i] = chosen;
}
