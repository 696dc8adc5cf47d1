// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"
#include "render/light/area_sampler.h"

#include <span>
#include <vector>

namespace scree {

/// A hierarchy of area lights, from which one is chosen in time that grows with the logarithm of
/// their number, with probability roughly in proportion to the irradiance that it gives (Conty
/// Estevez & Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting").
class LightTree {
  public:
    struct Choice {
        std::uint32_t light = 0;
        float probability = 0; // 0: no light reaches the point
    };

    LightTree() = default;
    explicit LightTree(std::span<const AreaSampler> lights);

    const AreaSampler& light(std::uint32_t index) const { return lights_[index]; }

    /// An estimate of the irradiance of all lights at `point`, on surfaces that face them; 0 only
    /// where it is 0.
    float irradiance(const Vec3& point) const;

    /// A light by a uniform number in [0, 1).
    Choice choose(const Vec3& point, float u) const;

    /// The probability with which `choose` chooses `light` at `point`.
    float probability(std::uint32_t light, const Vec3& point) const;

  private:
    // Lights whose normals lie within an angle of an axis, and emit within 90 degrees of them.
    struct Bounds {
        Box3 box;
        Vec3 axis{0.0F};
        float angle = -1; // [rad]; negative: no light
        float power = 0;  // sum of luminance times area

        void extend(const Bounds& other);
        double cost() const;
    };
    struct Node {
        Vec3 centre{0.0F};
        float radius = 0; // of a ball about the box
        Vec3 axis{0.0F};
        float cosine = 1; // of the angle about the axis
        float sine = 0;
        float power = 0;
        std::uint32_t first = 0; // child, the other one follows; of a leaf: the light
        std::uint32_t parent = 0;
        bool leaf = false;
    };

    static Bounds bounds_of(const AreaSampler& light);
    void build(std::uint32_t node, std::span<std::uint32_t> lights, std::span<const Bounds> bounds);
    static std::size_t split(std::span<std::uint32_t> lights, std::span<const Bounds> bounds);
    void find_cut();
    float weight(const Node& node, const Vec3& point) const;

    std::vector<AreaSampler> lights_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> leaf_of_; // node of each light
    std::vector<std::uint32_t> cut_;     // nodes that hold every light once, weighed one by one
};

} // namespace scree
