// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a glTF primitive.
#pragma once

#include "formats/file_mesh.h"
#include "formats/gltf_data.h"

namespace scree::gltf {

/// The vertices of a primitive: its own attributes with the weighted changes of its morph targets.
/// Attributes are empty or have one entry a vertex.
struct Vertices {
    std::vector<Imath::V3d> positions;
    std::vector<Imath::V3d> normals;
    std::vector<Imath::V2d>
        uvs; // (0, 0) at the lower left of a picture; the file has it upper left
};

/// `weights`: one for each morph target, or none for 0; `uv_set`: N of TEXCOORD_N. Throws Error
/// (input) that names what is damaged.
Vertices vertices_of(const Primitive& primitive, const std::vector<double>& weights,
                     std::size_t uv_set, Data& data);

/// Whether the primitive is of triangles, in any mode, rather than of points or lines.
bool has_triangles(const Primitive& primitive);

/// The triangles of a primitive with `vertices` vertices. Those of strips and fans that name a
/// vertex twice only join others and are left out. `left` counts indices that fill no triangle.
std::vector<Mesh::Triangle> triangles_of(const Primitive& primitive, std::size_t vertices,
                                         Data& data, std::size_t& left);

/// Whether what is placed by the matrix can have an area: it shrinks at most one direction to
/// nothing.
bool keeps_area(const Imath::M44d& matrix);

/// The vertices and triangles where the matrices put them: one for all, or one for each vertex.
/// Mirrored triangles are turned round. Normals are of unit length; where they vanish, those of the
/// faces.
FileMesh placed(const Vertices& vertices, std::vector<Mesh::Triangle> triangles,
                const std::vector<Imath::M44d>& matrices);

/// Gives every triangle vertices of its own with its own normal, as glTF asks for where there are
/// no normals.
void make_flat(FileMesh& mesh);

} // namespace scree::gltf
