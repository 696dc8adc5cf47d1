// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes moved by a height map. All cover their shape with tiles at the map's true size.
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/height_field.h"

namespace scree {

/// One tile lying flat in the x-z plane, centred on the origin, displaced upwards: a grid of at
/// most `triangles` triangles whose UVs are the map's. With `thickness` above 0 [m] the base plane
/// lies at that height and cut edges, which count too, go down to y = 0.
Mesh displaced_swatch(const HeightField& field, double thickness, std::size_t triangles);

/// A sphere displaced along its normals. The map is laid on by Lambert's azimuthal equal-area
/// projection (1772) centred on the direction `facing`: no seam and no pole on that side, where
/// shapes are stretched by less than 1.42 up to the silhouette; all distortion is gathered at the
/// opposite point, around which the relief fades out.
Mesh displaced_sphere(const HeightField& field, const Vec3& centre, double radius,
                      const Vec3& facing, std::size_t triangles);

/// Any mesh with UVs: edges are halved, the longest first and then those along which the map bends
/// most, as long as there are at most `triangles` triangles, or as many as the mesh has, along
/// curves that follow its normals (Vlachos et al. 2001), then moved along those normals. The tile
/// repeats a whole number of times over the unit square, as near to its true size as can be, so
/// that closed surfaces stay seamless. Points at one place stay at one place: seams do not open,
/// and the maps of their two sides fade into each other within `blend` [m].
Mesh displaced_mesh(const HeightField& field, const Mesh& mesh, std::size_t triangles,
                    double blend);

/// How many triangles `displaced_mesh` needs about for edges no longer than `edge` [m]; counting
/// stops above `most`.
std::size_t triangles_needed(const Mesh& mesh, double edge, std::size_t most);

/// Whether all points of the mesh lie on one sphere, to 1e-4 of its radius, and which.
bool is_sphere(const Mesh& mesh, Vec3& centre, double& radius);

} // namespace scree
