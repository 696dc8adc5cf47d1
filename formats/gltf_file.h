// SPDX-License-Identifier: GPL-3.0-or-later
// A glTF 2.0 file as plain values (Khronos Group, glTF 2.0 specification, 2021). Numbers of other
// elements are in range: whoever holds a File may use them as they are.
#pragma once

#include "core/math.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scree::gltf {

/// Type of an accessor's numbers, by the file's codes.
enum class Component : int {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126,
};

/// Bytes of a number.
std::size_t size_of(Component component);

using Index = std::optional<std::size_t>;

struct Buffer {
    std::optional<std::string> uri; // none: the binary chunk of a .glb file
    std::size_t length = 0;         // [bytes]
};

struct BufferView {
    std::size_t buffer = 0;
    std::size_t offset = 0; // [bytes], as all below
    std::size_t length = 0;
    std::size_t stride = 0;  // 0: no gaps
    std::string compression; // the extension by which its bytes are compressed; usually empty
};

/// Elements that replace some of an accessor's.
struct Sparse {
    std::size_t count = 0;
    std::size_t indices_view = 0;
    std::size_t indices_offset = 0;
    Component indices_component = Component::uint32;
    std::size_t values_view = 0;
    std::size_t values_offset = 0;
};

struct Accessor {
    Index view; // none: zeros
    std::size_t offset = 0;
    Component component = Component::float32;
    bool normalized = false;
    std::size_t count = 0;
    std::size_t width = 1; // numbers of an element: 3 for a VEC3
    std::optional<Sparse> sparse;
};

/// Accessors by the names of what they hold: "POSITION".
using Attributes = std::map<std::string, std::size_t>;

struct Primitive {
    std::string path; // "meshes[0].primitives[1]"
    Attributes attributes;
    Index indices;
    std::size_t mode = 4;
    std::vector<Attributes> targets; // of its morphs
    Index material;
    bool draco = false; // it has a compressed copy, which may be all there is
};

struct MeshElement {
    std::vector<Primitive> primitives;
    std::vector<double> weights; // of the morph targets
};

struct Node {
    Imath::M44d parent_from_node;
    std::vector<std::size_t> children;
    Index mesh;
    Index skin;
    std::vector<double> weights; // replace those of the mesh
    Attributes instances;        // of EXT_mesh_gpu_instancing
    bool visible = true;         // by KHR_node_visibility, with all below
};

struct Skin {
    std::vector<std::size_t> joints;
    Index inverse_bind_matrices;
};

/// A texture as a material uses it.
struct TextureUse {
    std::size_t texture = 0;
    std::size_t uv_set = 0;
    Imath::M33d picture_from_uv; // of KHR_texture_transform
};

struct MaterialElement {
    std::string name;
    Color color{1.0F, 1.0F, 1.0F};
    std::optional<TextureUse> color_texture;
    double metallic = 1;
    double roughness = 1;
    double ior = 1.5;
    double transmission = 0;
    double specular = 1;
    Color absorption{0.0F, 0.0F, 0.0F}; // [1/m]
    std::vector<std::string> ignored;   // what of it is not read: "normalTexture"
};

struct Texture {
    Index image; // none: of a kind that cannot be read
    bool repeats = true;
    std::vector<std::string> ignored;
};

struct Picture {
    std::optional<std::string> uri;
    Index view;
};

struct File {
    std::vector<Buffer> buffers;
    std::vector<BufferView> views;
    std::vector<Accessor> accessors;
    std::vector<MeshElement> meshes;
    std::vector<Node> nodes;
    std::vector<Skin> skins;
    std::vector<MaterialElement> materials;
    std::vector<Texture> textures;
    std::vector<Picture> pictures;
    std::vector<std::vector<std::size_t>> scenes; // the nodes of each
    Index scene;                                  // the one to be shown
};

/// Reads the JSON of a file. Throws Error (input) that names the element: not JSON, not glTF 2.0, a
/// value of the wrong type or out of range, a required extension that is not known.
File parse(std::string_view json);

} // namespace scree::gltf
