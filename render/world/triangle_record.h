// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace scree {

/// All that shading needs of a triangle in one cache line: bounced rays hit triangles at random,
/// and indices, positions and normals in separate arrays would cost seven cache lines a hit.
struct alignas(64) TriangleRecord {
    Vec3 positions[3];
    std::int16_t normals[3][3]; // of unit vectors, in steps of 1 / 32767
    std::uint16_t part;         // see Mesh::parts
};

inline std::int16_t pack_unit(float value) {
    return static_cast<std::int16_t>(std::lround(value * 32767.0F));
}

/// A positive multiple of the packed vector.
inline Vec3 unpack_normal(const std::int16_t (&n)[3]) {
    return {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])};
}

/// One record a triangle, with zero normals where the mesh has none.
inline std::vector<TriangleRecord> triangle_records(const Mesh& mesh) {
    std::vector<TriangleRecord> records(mesh.triangles.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        records[i].part = mesh.parts.empty() ? 0 : mesh.parts[i];
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[i][corner];
            records[i].positions[corner] = mesh.positions[vertex];
            if (mesh.normals.empty())
                continue;
            for (int axis = 0; axis < 3; ++axis)
                records[i].normals[corner][axis] = pack_unit(mesh.normals[vertex][axis]);
        }
    }
    return records;
}

} // namespace scree
