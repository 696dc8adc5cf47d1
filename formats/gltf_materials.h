// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/file_mesh.h"
#include "formats/gltf_data.h"
#include "geometry/mesh/mesh_material.h"

namespace scree::gltf {

/// The materials of a file that its primitives use, numbered in the order of their first use.
class FileMaterials {
  public:
    FileMaterials(const File& file, Data& data) : file_(file), data_(data) {}

    /// Throws Error (input) when there are more than `Mesh::parts` can number.
    std::uint16_t number_of(const Primitive& primitive);

    /// N of the TEXCOORD_N that the primitive's picture asks for; 0 without a picture.
    std::size_t uv_set(const Primitive& primitive) const;

    /// Describes all that were numbered; nothing when the file has no materials.
    void give_to(FileMesh& mesh);

  private:
    MeshMaterial described(const MaterialElement& element);
    std::optional<MeshPicture> picture(const MaterialElement& element);
    void find_content(const Picture& source, MeshPicture& picture);
    void note(const MaterialElement& element, const std::string& what);

    const File& file_;
    Data& data_;
    std::map<Index, std::uint16_t> numbers_;
    std::vector<Index> used_;
    std::map<std::size_t, MeshPicture> pictures_; // by image
    std::vector<std::string> not_read_;
};

} // namespace scree::gltf
