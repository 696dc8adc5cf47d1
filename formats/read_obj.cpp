// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/obj_statements.h"
#include "formats/read_mesh.h"
#include "formats/read_mtl.h"
#include "formats/vertex_merger.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

/// Makes a mesh of the faces: OBJ indexes positions, texture coordinates and normals separately;
/// each combination that is used becomes one vertex.
class Builder {
  public:
    explicit Builder(const Obj& obj) : obj_(obj) {}

    FileMesh build() {
        has_uvs_ = all_have(1, "texture coordinates");
        has_normals_ = all_have(2, "normals");
        Tally crossing;
        std::vector<std::uint32_t> vertices;
        for (const Obj::Face& face : obj_.faces) {
            vertices.clear();
            for (const ObjCorner& corner : obj_.corners_of(face))
                vertices.push_back(vertex(corner));
            if (append_face(mesh_, vertices))
                crossing.add(face.line);
            mesh_.parts.resize(mesh_.triangles.size(), face.material);
        }
        if (crossing.count() > 0)
            mesh_.warnings.push_back(
                fmt::format("{} of its faces cross themselves, the first in line {}",
                            crossing.count(), crossing.first()));
        return std::move(mesh_);
    }

  private:
    // Whether every corner has an index of this kind; a warning if only some have.
    bool all_have(std::size_t kind, const char* what) {
        Tally without;
        for (const Obj::Face& face : obj_.faces)
            if (std::ranges::any_of(obj_.corners_of(face),
                                    [kind](const auto& c) { return c[kind] == Obj::absent; }))
                without.add(face.line);
        const bool some = std::ranges::any_of(
            obj_.corners, [kind](const auto& c) { return c[kind] != Obj::absent; });
        if (some && without.count() > 0)
            mesh_.warnings.push_back(fmt::format("its {} are not read, since faces lack them ({})",
                                                 what, without.text("line")));
        return without.count() == 0;
    }

    std::uint32_t vertex(ObjCorner corner) {
        if (!has_uvs_)
            corner[1] = Obj::absent;
        if (!has_normals_)
            corner[2] = Obj::absent;
        const auto [entry, added] =
            known_.try_emplace(corner, static_cast<std::uint32_t>(mesh_.positions.size()));
        if (added) {
            mesh_.positions.push_back(obj_.positions[std::size_t(corner[0])]);
            if (has_uvs_)
                mesh_.uvs.push_back(obj_.uvs[std::size_t(corner[1])]);
            if (has_normals_)
                mesh_.normals.push_back(obj_.normals[std::size_t(corner[2])]);
        }
        return entry->second;
    }

    const Obj& obj_;
    FileMesh mesh_;
    bool has_uvs_ = false;
    bool has_normals_ = false;
    std::unordered_map<ObjCorner, std::uint32_t, IntegersHash> known_;
};

} // namespace

FileMesh read_obj(std::string_view bytes, const std::string& folder) {
    const Obj obj = parse_obj(bytes);
    std::map<std::string, Tally> all_unread = obj.unread;
    for (const Obj::Face& line : obj.lines)
        all_unread["lines"].add(line.line);
    std::string unread;
    for (const auto& [what, tally] : all_unread)
        unread += fmt::format("{}{} ({})", unread.empty() ? "not read: " : ", ", what,
                              tally.text("line"));
    if (obj.faces.empty())
        throw Error("it has no triangles" + (unread.empty() ? "" : "; " + unread));
    FileMesh mesh = Builder(obj).build();
    if (obj.materials.size() != 1 || !obj.materials.front().name.empty())
        mesh.materials =
            std::make_shared<const MeshMaterials>(read_mtl(obj.libraries, obj.materials, folder));
    if (!unread.empty())
        mesh.warnings.push_back(unread);
    return mesh;
}

} // namespace scree
