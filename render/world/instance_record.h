// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace scree {

/// What shading needs of an instance: 64 bytes, one cache line per hit.
struct alignas(64) InstanceRecord {
    std::array<Vec3, 4> rows; // of world_from_object, relative to the world's origin
    std::uint32_t prototype;
    float random;
    float scale; // of lengths, mean over the axes
    bool mirrored;
    bool similar; // a rotation and one scale, as generators make: normals transform as directions

    Vec3 direction(const Vec3& v) const { return rows[0] * v.x + rows[1] * v.y + rows[2] * v.z; }
    Vec3 point(const Vec3& v) const { return direction(v) + rows[3]; }
    // The inverse of `direction`: by the transpose, or by Cramer's rule.
    Vec3 inverse_direction(const Vec3& v) const {
        if (similar)
            return Vec3(rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)) * (1 / (scale * scale));
        const Vec3 yz = rows[1].cross(rows[2]);
        return Vec3(yz.dot(v), rows[2].cross(rows[0]).dot(v), rows[0].cross(rows[1]).dot(v)) /
               rows[0].dot(yz);
    }
    // By what factors the object's axes are stretched.
    Vec3 stretch() const {
        return similar ? Vec3(scale) : Vec3(rows[0].length(), rows[1].length(), rows[2].length());
    }
    // Normals transform by the cofactors, up to a positive factor.
    Vec3 normal(const Vec3& n) const {
        if (similar)
            return direction(n);
        const Vec3 image = rows[1].cross(rows[2]) * n.x + rows[2].cross(rows[0]) * n.y +
                           rows[0].cross(rows[1]) * n.z;
        return mirrored ? -image : image;
    }
};

/// Whether the matrix is a rotation and one scale, up to rounding, without a reflection.
inline bool is_similarity(const InstanceRecord& record) {
    const float square = record.scale * record.scale;
    const float allowed = 1e-5F * square;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            if (std::abs(record.rows[i].dot(record.rows[j]) - (i == j ? square : 0)) > allowed)
                return false;
    return !record.mirrored;
}

/// `prototype` counts over all aggregates.
inline InstanceRecord instance_record(const Instance& instance, std::uint32_t prototype,
                                      const WideVec3& origin) {
    InstanceRecord record{};
    const WideMatrix& m = instance.world_from_object;
    for (int row = 0; row < 4; ++row)
        record.rows[row] =
            Vec3(WideVec3(m[row][0], m[row][1], m[row][2]) - (row == 3 ? origin : WideVec3(0)));
    const float volume = record.rows[0].dot(record.rows[1].cross(record.rows[2]));
    record.prototype = prototype;
    record.random = instance.random;
    record.scale = std::cbrt(std::abs(volume));
    record.mirrored = volume < 0;
    record.similar = is_similarity(record);
    return record;
}

} // namespace scree
