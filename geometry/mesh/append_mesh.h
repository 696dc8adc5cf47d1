// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

namespace scree {

/// Appends `other` to `mesh`: for all types of meshes, whatever the precision of their positions.
/// Both must have the same optional arrays, but for the parts; the numbers of parts stay as they
/// are.
template <class M>
void append_mesh(M& mesh, const M& other) {
    assert(mesh.positions.empty() || mesh.normals.empty() == other.normals.empty());
    assert(mesh.positions.empty() || mesh.uvs.empty() == other.uvs.empty());
    const auto add = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    if (!mesh.parts.empty() || !other.parts.empty()) {
        mesh.parts.resize(mesh.triangles.size());
        add(mesh.parts, other.parts);
        mesh.parts.resize(mesh.triangles.size() + other.triangles.size());
    }
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    add(mesh.positions, other.positions);
    add(mesh.normals, other.normals);
    add(mesh.uvs, other.uvs);
    for (const auto& t : other.triangles)
        mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

} // namespace scree
