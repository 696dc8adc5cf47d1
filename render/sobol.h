// SPDX-License-Identifier: GPL-3.0-or-later
// Sobol's sequence and Owen's scrambling. Numbers are kept with their bits reversed: the scrambling
// works from the highest bit of a fraction down, which reversed is from the lowest bit up.
#pragma once

#include "core/math.h"

#include <array>
#include <cstdint>

namespace scree::sobol {

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = ((x & 0x0f0f0f0fU) << 4) | ((x >> 4) & 0x0f0f0f0fU);
    x = ((x & 0x33333333U) << 2) | ((x >> 2) & 0x33333333U);
    return ((x & 0x55555555U) << 1) | ((x >> 1) & 0x55555555U);
}

/// Owen scrambling by hashing, of a number whose bits are reversed: every bit is flipped by a hash
/// of those below it (Laine & Karras 2011 with the constants of Vegdahl 2021, "Building a better
/// LK hash").
inline std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeaU;
    x += seed;
    x *= (seed >> 16) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return x;
}

inline std::uint32_t hash(std::uint32_t x) { // lowbias32 of Wellons 2018, "Hash prospector"
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    return x ^ (x >> 16);
}

inline std::uint32_t combine(std::uint32_t a, std::uint32_t b) {
    return hash(a ^ (b * 0x9e3779b9U + (a << 6) + (a >> 2)));
}

inline float to_unit(std::uint32_t reversed) {
    return static_cast<float>(reverse_bits(reversed) >> 8) * 0x1p-24F;
}

inline constexpr std::size_t dimensions = 18;

/// Of each dimension, what each bit of the index adds to the point.
using Matrices = std::array<std::array<std::uint32_t, 32>, dimensions>;

constexpr Matrices make_matrices() {
    struct Polynomial {
        int degree;
        std::uint32_t coefficients; // of the inner powers, the highest first
        std::array<std::uint32_t, 6> first;
    };
    // Joe & Kuo 2008, "Constructing Sobol sequences with better two-dimensional projections".
    constexpr std::array<Polynomial, dimensions - 1> polynomials{{
        {1, 0, {1}},
        {2, 1, {1, 3}},
        {3, 1, {1, 3, 1}},
        {3, 2, {1, 1, 1}},
        {4, 1, {1, 1, 3, 3}},
        {4, 4, {1, 3, 5, 13}},
        {5, 2, {1, 1, 5, 5, 17}},
        {5, 4, {1, 1, 5, 5, 5}},
        {5, 7, {1, 1, 7, 11, 19}},
        {5, 11, {1, 1, 5, 1, 1}},
        {5, 13, {1, 1, 1, 3, 11}},
        {5, 14, {1, 3, 5, 5, 31}},
        {6, 1, {1, 3, 3, 9, 7, 49}},
        {6, 13, {1, 1, 1, 15, 21, 21}},
        {6, 16, {1, 3, 1, 13, 27, 49}},
        {6, 19, {1, 1, 1, 15, 7, 5}},
        {6, 22, {1, 3, 1, 15, 13, 25}},
    }};
    Matrices matrices{};
    for (std::uint32_t i = 0; i < 32; ++i)
        matrices[0][i] = 1U << i; // reversed; the sequence of van der Corput
    for (std::size_t d = 1; d < dimensions; ++d) {
        const auto& [degree, coefficients, first] = polynomials[d - 1];
        std::array<std::uint32_t, 32> v{};
        for (int i = 0; i < 32; ++i) {
            const auto at = [&](int k) -> std::uint32_t& { return v[static_cast<std::size_t>(k)]; };
            if (i < degree) {
                at(i) = first[static_cast<std::size_t>(i)] << (31 - i);
            } else {
                at(i) = at(i - degree) ^ (at(i - degree) >> degree);
                for (int k = 1; k < degree; ++k)
                    if ((coefficients >> (degree - 1 - k)) & 1U)
                        at(i) ^= at(i - k);
            }
            matrices[d][static_cast<std::size_t>(i)] = reverse_bits(at(i));
        }
    }
    return matrices;
}

inline constexpr Matrices matrices = make_matrices();

/// The first two coordinates, reversed, by the structure of their matrices: the identity, and
/// Pascal's triangle modulo 2 as a Kronecker product. Fast for large indices.
inline std::array<std::uint32_t, 2> first_pair(std::uint32_t index) {
    std::uint32_t y = index ^ (index >> 16);
    y ^= (y & 0xff00ff00U) >> 8;
    y ^= (y & 0xf0f0f0f0U) >> 4;
    y ^= (y & 0xccccccccU) >> 2;
    return {index, y ^ ((y & 0xaaaaaaaaU) >> 1)};
}

/// Two coordinates, that of `dimension` and the next, of the point with this index; reversed.
inline std::array<std::uint32_t, 2> pair(std::uint32_t index, std::size_t dimension) {
    std::array<std::uint32_t, 2> p{};
    for (; index != 0; index &= index - 1) {
        const auto bit = static_cast<std::size_t>(__builtin_ctz(index));
        p[0] ^= matrices[dimension][bit];
        p[1] ^= matrices[dimension + 1][bit];
    }
    return p;
}

} // namespace scree::sobol
