// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace scree {

struct MeshMaterials;

/// Indexed triangles, counter-clockwise seen from outside [m]. `normals` and `uvs` are either empty
/// or one per position; a seam or a crease repeats the position. Plain data: validity is the
/// business of `check_mesh`.
struct Mesh {
    using Triangle = std::array<std::uint32_t, 3>;

    std::string name; // as shown to users: "banana", "bunny.obj"
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;
    std::vector<Vec2f> uvs;
    std::vector<Triangle> triangles;

    static constexpr std::size_t most_parts = 65536;
    std::vector<std::uint16_t> parts{}; // of each triangle the number of its part; empty: all are 0
    // Of the parts, as the mesh's file describes them; null: the mesh is from no file.
    std::shared_ptr<const MeshMaterials> materials{};
    bool unit_unknown = false; // from a file whose numbers are taken as metres unasked
};

Box3 bounds(const Mesh& mesh);

/// Surface area [m^2].
double area(const Mesh& mesh);

/// Signed enclosed volume [m^3]; positive for a closed mesh whose normals point outwards.
double volume(const Mesh& mesh);

/// For every vertex the lowest index of a vertex at exactly the same position, so that seams and
/// creases do not count as borders.
std::vector<std::uint32_t> weld(const Mesh& mesh);

/// Facts about a mesh's connectivity after welding equal positions.
struct MeshFacts {
    std::size_t boundary_edges = 0;     // edges of one triangle
    std::size_t non_manifold_edges = 0; // edges of three or more, or of two that disagree in turn
    std::size_t degenerate_triangles = 0;
    bool finite = true;

    bool closed() const { return boundary_edges == 0 && non_manifold_edges == 0; }
};
MeshFacts inspect(const Mesh& mesh);

/// How much a face counts in the normal of its vertex: by its angle there (Thürmer & Wüthrich
/// 1998), best for curved surfaces; or by angle and area, which keeps the large faces between
/// small bevels flat.
enum class NormalWeight { angle, angle_and_area };

/// Fills `normals` with weighted vertex normals. Edges whose faces meet at more than `crease` [rad]
/// become sharp: their vertices are split. So are all where more than 4096 faces meet.
void compute_normals(Mesh& mesh, double crease, NormalWeight weight = NormalWeight::angle);

/// The normal at a place on a triangle, of length 1: interpolated between those of its corners; the
/// triangle's own, `facet`, where there are none.
Vec3 smooth_normal(const Mesh& mesh, std::uint32_t triangle, const Imath::V3d& position,
                   const Vec3& facet);

/// Moves the mesh so that its bounding box is centred on the y axis and stands on y = 0, then
/// scales it so that its longest side is `size` [m].
void normalise_size(Mesh& mesh, double size);

/// Appends `other` to `mesh`; both must have the same optional arrays, but for the parts.
void append(Mesh& mesh, const Mesh& other);

/// Transforms positions and normals; a mirroring matrix also turns the triangles round.
void transform(Mesh& mesh, const Matrix& matrix);

} // namespace scree
