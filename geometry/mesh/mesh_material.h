// SPDX-License-Identifier: GPL-3.0-or-later
// What a file says of the look of its mesh, in terms of no renderer.
#pragma once

#include "core/math.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scree {

/// A picture that a mesh's file names, or holds.
struct MeshPicture {
    std::string name;                           // as shown to users
    std::string path{};                         // of its own file; empty: the mesh's file holds it,
    std::shared_ptr<const std::string> bytes{}; // and this is its content: a PNG or JPEG
    std::string problem{};                      // why there is neither
    bool repeats = true;                        // beyond its borders; else those extend outwards
    // For row vectors (u, v, 1); UVs are (0, 0) at the picture's lower left.
    Imath::M33d picture_from_uv{};
};

/// A surface by base colour, metalness and roughness (Burley 2012).
struct MeshMaterial {
    std::string name;
    Color color{0.5F, 0.5F, 0.5F};        // linear Rec. 709; of a metal its reflectance
    std::optional<MeshPicture> picture{}; // multiplied with the colour
    double metallic = 0;                  // from 0 to 1
    double roughness = 1;                 // perceptual, from 0 to 1
    double ior = 1.5;
    double transmission = 0;            // the share of light that passes through, from 0 to 1
    Color absorption{0.0F, 0.0F, 0.0F}; // of the inside where light passes through [1/m]
    bool coated = false;                // reflects at its surface, unless metal

    /// How the file says some of these, for messages: "d 0.75" is a transmission of 0.25.
    struct Words {
        std::string metallic{};
        std::string ior{};
        std::string transmission{};
    };
    Words words{};
};

/// The materials of a mesh.
struct MeshMaterials {
    std::vector<MeshMaterial> list;      // by the numbers in Mesh::parts
    std::vector<std::string> not_read{}; // what else the file says of them, in words
    std::string problem{};               // why those that the file names cannot be had
};

} // namespace scree
