// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/placed_mesh.h"

#include <algorithm>

namespace scree {

using Imath::V3d;

Rounding rounding(const FileMesh& mesh) {
    Rounding out;
    Imath::Box3d box;
    for (const V3d& p : mesh.positions) {
        box.extendBy(p);
        for (const double exact : {p.x, p.y, p.z}) // as vectors GCC 12 gets this wrong at -O2
            out.moved = std::max(out.moved, std::abs(exact - double(static_cast<float>(exact))));
        out.distance = std::max(out.distance, p.length());
    }
    out.longest = std::max({box.size().x, box.size().y, box.size().z});
    for (const Mesh::Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            out.mean_edge += (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).length();
    out.mean_edge /= 3 * double(std::max<std::size_t>(mesh.triangles.size(), 1));
    return out;
}

} // namespace scree
