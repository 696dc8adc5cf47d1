// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/float4.h"
#include "core/math.h"

#include <array>
#include <cstring>

namespace scree {

/// Distances to a triangle, computed in single precision relative to its first corner, so that they
/// are accurate anywhere.
class TriangleDistance {
  public:
    explicit TriangleDistance(const std::array<Imath::V3d, 3>& corners)
        : first_(corners[0]), second_(corners[1] - corners[0]), third_(corners[2] - corners[0]) {
        const std::array<Vec3, 3> sides{second_, third_ - second_, -third_};
        const Vec3 normal = Vec3(sides[0].cross(third_)).normalized();
        plane_ = normal;
        for (std::size_t k = 0; k < 3; ++k) {
            along_[k] = sides[k];
            inward_[k] = normal.cross(sides[k]);
            inverse_[k] = sides[k].length2() > 0 ? 1.0F / sides[k].length2() : 0.0F;
        }
    }

    /// The distance to the triangle's plane, a lower bound.
    double plane_distance(const Imath::V3d& p) const {
        return std::abs((p - first_).dot(Imath::V3d(plane_)));
    }

    double distance(const Imath::V3d& p) const {
        const Vec3 v(p - first_);
        return std::sqrt(double(squared(v.x, v.y, v.z)));
    }

    /// Sets each of lowest[0..3] to its minimum with the squared distance of p, p + (1, 0, 0), ...,
    /// p + (3, 0, 0), unless all of them are farther than `reach` from the triangle's plane.
    void lower_four(const Imath::V3d& p, float reach, float* lowest) const {
        const Vec3 v(p - first_);
        const float from = v.dot(plane_), to = from + 3 * plane_.x;
        if (smaller(from, to) > reach || larger(from, to) < -reach)
            return;
        const Float4 made = squared(v.x + Float4{0, 1, 2, 3}, Float4{} + v.y, Float4{} + v.z);
        Float4 held;
        std::memcpy(&held, lowest, sizeof held);
        held = smaller(held, made);
        std::memcpy(lowest, &held, sizeof held);
    }

  private:
    template <class Number>
    static Number smaller(const Number& a, const Number& b) {
        return a < b ? a : b;
    }
    template <class Number>
    static Number larger(const Number& a, const Number& b) {
        return a > b ? a : b;
    }

    template <class Number>
    Number squared(const Number& x, const Number& y, const Number& z) const {
        const Number plane = x * plane_.x + y * plane_.y + z * plane_.z;
        const Number s0 = x * inward_[0].x + y * inward_[0].y + z * inward_[0].z;
        const Number x1 = x - second_.x, y1 = y - second_.y, z1 = z - second_.z;
        const Number s1 = x1 * inward_[1].x + y1 * inward_[1].y + z1 * inward_[1].z;
        const Number s2 = x * inward_[2].x + y * inward_[2].y + z * inward_[2].z;
        const Number x2 = x - third_.x, y2 = y - third_.y, z2 = z - third_.z;
        const Number edges =
            smaller(smaller(to_side(0, x, y, z), to_side(1, x1, y1, z1)), to_side(2, x2, y2, z2));
        // For a degenerate triangle the normal is 0, so none of these is positive.
        const Number inside = smaller(smaller(s0, s1), s2);
        const Number flat = plane * plane;
        return inside > Number{} ? flat : edges;
    }

    template <class Number>
    Number to_side(std::size_t k, const Number& x, const Number& y, const Number& z) const {
        const Vec3& d = along_[k];
        const Number at = (x * d.x + y * d.y + z * d.z) * inverse_[k];
        const Number t = smaller(larger(at, Number{}), Number{} + 1);
        const Number u = x - t * d.x, v = y - t * d.y, w = z - t * d.z;
        return u * u + v * v + w * w;
    }

    Imath::V3d first_;
    Vec3 second_, third_; // from the first
    Vec3 plane_;
    std::array<Vec3, 3> along_, inward_;
    std::array<float, 3> inverse_; // of the squared lengths
};

} // namespace scree
