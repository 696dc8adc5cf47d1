// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/placed_mesh.h"

#include <algorithm>

namespace scree {

using Imath::V3d;

namespace {

Imath::Box3d bounds_of(const FileMesh& mesh) {
    Imath::Box3d box;
    for (const V3d& p : mesh.positions)
        box.extendBy(p);
    return box;
}

double longest_side(const Imath::Box3d& box) {
    return std::max({box.size().x, box.size().y, box.size().z});
}

} // namespace

double longest_side(const FileMesh& mesh) { return longest_side(bounds_of(mesh)); }

void scale(FileMesh& mesh, double factor) {
    for (V3d& p : mesh.positions)
        p *= factor;
}

void turn_z_up(FileMesh& mesh) {
    for (V3d& p : mesh.positions)
        p = V3d(p.x, p.z, -p.y);
    for (Vec3& n : mesh.normals)
        n = Vec3(n.x, n.z, -n.y);
}

void centre(FileMesh& mesh, std::optional<double> size) {
    const Imath::Box3d box = bounds_of(mesh);
    const double longest = longest_side(box);
    const V3d foot(box.center().x, box.min.y, box.center().z);
    const double factor = size && longest > 0 ? *size / longest : 1; // a point keeps its size
    for (V3d& p : mesh.positions)
        p = (p - foot) * factor;
}

Rounding rounding(const FileMesh& mesh) {
    Rounding out;
    out.longest = longest_side(mesh);
    for (const V3d& p : mesh.positions) {
        for (const double exact : {p.x, p.y, p.z}) // as vectors GCC 12 gets this wrong at -O2
            out.moved = std::max(out.moved, std::abs(exact - double(static_cast<float>(exact))));
        out.distance = std::max(out.distance, p.length());
    }
    for (const Mesh::Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            out.mean_edge += (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).length();
    out.mean_edge /= 3 * double(std::max<std::size_t>(mesh.triangles.size(), 1));
    return out;
}

} // namespace scree
