// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/solid_procedural.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace scree {

/// The filters of several points, elongated ones divided into parts (see filter_parts in solid.cl),
/// and the samples of a texture for each, as a structure of arrays for vector code.
struct FilterParts {
    static constexpr std::size_t capacity =
        64 + 8; // padded for the unused lanes of the last vector

    std::size_t count = 0;
    float position[3][capacity], across[3][capacity], along[3][capacity], random[capacity];
    float color[3][capacity], slope[3][capacity], height[capacity], roughness[capacity],
        value[capacity];

    void add(const solid::Triple& place, const solid::Triple& side, const solid::Triple& other,
             float instance) {
        const auto set = [this](float(&to)[3][capacity], const solid::Triple& t) {
            to[0][count] = t.x;
            to[1][count] = t.y;
            to[2][count] = t.z;
        };
        set(position, place);
        set(across, side);
        set(along, other);
        random[count++] = instance;
    }

    /// Pads to a multiple of 8 by repeating the last filter, for unused lanes.
    void fill_up() {
        const std::size_t last = count - 1;
        for (std::size_t i = count; i % 8 != 0; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                position[axis][i] = position[axis][last];
                across[axis][i] = across[axis][last];
                along[axis][i] = along[axis][last];
            }
            random[i] = random[last];
        }
    }

    solid::SolidSample sample(std::size_t i) const {
        return {{color[0][i], color[1][i], color[2][i]},
                {slope[0][i], slope[1][i], slope[2][i]},
                height[i],
                roughness[i],
                value[i]};
    }
};

/// Evaluates a texture by `answer(parts)`, which returns false when it cannot; then false is
/// returned and the samples of those and later points are not written. See MEAN_OF_PARTS.
template <class Answer>
bool in_filter_parts(std::span<const ShadingPoint> points, std::span<ShadingSample> samples,
                     const Answer& answer) {
    constexpr std::size_t together = 8; // points per batch, with at most 8 parts each
    FilterParts parts;
    std::array<int, together> counts;
    for (std::size_t first = 0; first < points.size(); first += together) {
        const std::size_t here = std::min(together, points.size() - first);
        parts.count = 0;
        for (std::size_t i = 0; i < here; ++i) {
            const solid::SolidPoint point = solid_point(points[first + i]);
            counts[i] = solid::filter_parts(point.across, point.along);
            const float share = 1.0F / static_cast<float>(counts[i]);
            const solid::Triple along =
                counts[i] == 1 ? point.along : solid::scaled(point.along, share);
            for (int k = 0; k < counts[i]; ++k) {
                const float shift = (static_cast<float>(k) + 0.5F) * share - 0.5F;
                parts.add(counts[i] == 1
                              ? point.position
                              : solid::plus(point.position, solid::scaled(point.along, shift)),
                          point.across, along, point.random);
            }
        }
        parts.fill_up();
        if (!answer(parts))
            return false;
        std::size_t part = 0;
        for (std::size_t i = 0; i < here; ++i) {
            solid::SolidSample mean = parts.sample(part++);
            if (counts[i] > 1) {
                const float share = 1.0F / static_cast<float>(counts[i]);
                solid::SolidSample sum = solid::no_sample();
                solid::add_sample(&sum, mean, share);
                for (int k = 1; k < counts[i]; ++k)
                    solid::add_sample(&sum, parts.sample(part++), share);
                mean = sum;
            }
            samples[first + i] = shading_sample(mean);
        }
    }
    return true;
}

} // namespace scree
