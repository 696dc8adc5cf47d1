// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/read_mesh.h"

#include "core/error.h"
#include "core/file.h"

#include <tiny_gltf.h>

#include <cstring>
#include <filesystem>

namespace scree {

namespace {

constexpr int depth_limit = 64; // of the node tree, which may have cycles in a malicious file
constexpr std::size_t vertex_limit = 100'000'000; // nodes can repeat a mesh at no cost in bytes
constexpr int nesting_limit = 200; // of the JSON, which the library parses recursively

// The elements of a strided accessor, whose bounds are all checked.
struct View {
    const unsigned char* data = nullptr;
    std::size_t stride = 0;
    std::size_t count = 0;
    int component = 0;
};

View view_of(const tinygltf::Model& model, int index, int type) {
    if (index < 0 || std::size_t(index) >= model.accessors.size())
        throw Error("an accessor is missing");
    const tinygltf::Accessor& accessor = model.accessors[std::size_t(index)];
    if (accessor.sparse.isSparse)
        throw Error("sparse accessors are not supported");
    if (accessor.type != type)
        throw Error("an accessor has the wrong type");
    if (accessor.bufferView < 0 || std::size_t(accessor.bufferView) >= model.bufferViews.size())
        throw Error("a buffer view is missing");
    const tinygltf::BufferView& view = model.bufferViews[std::size_t(accessor.bufferView)];
    if (view.buffer < 0 || std::size_t(view.buffer) >= model.buffers.size())
        throw Error("a buffer is missing");
    const std::vector<unsigned char>& buffer = model.buffers[std::size_t(view.buffer)].data;
    const int component = tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType));
    const int components = tinygltf::GetNumComponentsInType(std::uint32_t(type));
    const int stride = accessor.ByteStride(view);
    if (component <= 0 || components <= 0 || stride <= 0)
        throw Error("an accessor is damaged");
    const std::size_t element = std::size_t(component) * std::size_t(components);
    const std::size_t size = buffer.size();
    if (view.byteOffset > size || view.byteLength > size - view.byteOffset ||
        accessor.byteOffset > view.byteLength || accessor.count == 0 ||
        element > view.byteLength - accessor.byteOffset ||
        accessor.count - 1 >
            (view.byteLength - accessor.byteOffset - element) / std::size_t(stride))
        throw Error("an accessor reaches beyond its buffer");
    return {buffer.data() + view.byteOffset + accessor.byteOffset, std::size_t(stride),
            accessor.count, accessor.componentType};
}

template <class Vector>
std::vector<Vector> floats(const View& view) {
    if (view.component != TINYGLTF_COMPONENT_TYPE_FLOAT)
        throw Error("vertices that are not 32-bit floats are not supported");
    std::vector<Vector> out(view.count);
    for (std::size_t i = 0; i < view.count; ++i)
        std::memcpy(&out[i][0], view.data + i * view.stride, sizeof(Vector));
    return out;
}

std::vector<std::uint32_t> indices(const View& view) {
    std::vector<std::uint32_t> out(view.count);
    for (std::size_t i = 0; i < view.count; ++i) {
        const unsigned char* at = view.data + i * view.stride;
        if (view.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) {
            out[i] = *at;
        } else if (view.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
            std::uint16_t value = 0;
            std::memcpy(&value, at, sizeof value);
            out[i] = value;
        } else if (view.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
            std::memcpy(&out[i], at, sizeof out[i]);
        } else {
            throw Error("indices must be unsigned integers");
        }
    }
    return out;
}

Mesh primitive_mesh(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
    Mesh mesh;
    const auto attribute = [&](const char* name) {
        const auto found = primitive.attributes.find(name);
        return found == primitive.attributes.end() ? -1 : found->second;
    };
    mesh.positions = floats<Vec3>(view_of(model, attribute("POSITION"), TINYGLTF_TYPE_VEC3));
    if (const int normals = attribute("NORMAL"); normals >= 0)
        mesh.normals = floats<Vec3>(view_of(model, normals, TINYGLTF_TYPE_VEC3));
    if (const int uvs = attribute("TEXCOORD_0"); uvs >= 0)
        mesh.uvs = floats<Vec2f>(view_of(model, uvs, TINYGLTF_TYPE_VEC2));
    std::vector<std::uint32_t> corners;
    if (primitive.indices >= 0) {
        corners = indices(view_of(model, primitive.indices, TINYGLTF_TYPE_SCALAR));
    } else {
        for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
            corners.push_back(i);
    }
    for (const std::uint32_t corner : corners)
        if (corner >= mesh.positions.size())
            throw Error("a face names vertex " + std::to_string(corner) + " of " +
                        std::to_string(mesh.positions.size()));
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return mesh;
}

Matrix node_matrix(const tinygltf::Node& node) {
    Matrix matrix;
    if (node.matrix.size() == 16) { // column-major for column vectors, as Imath's rows
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = static_cast<float>(node.matrix[std::size_t(i)]);
        return matrix;
    }
    if (node.scale.size() == 3) {
        Matrix scale;
        scale.setScale(Vec3(float(node.scale[0]), float(node.scale[1]), float(node.scale[2])));
        matrix = scale;
    }
    if (node.rotation.size() == 4) {
        const auto [x, y, z, w] = std::tuple(float(node.rotation[0]), float(node.rotation[1]),
                                             float(node.rotation[2]), float(node.rotation[3]));
        const Matrix rotation(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0,
                              2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0,
                              2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0,
                              0, 0, 0, 1);
        matrix = matrix * rotation;
    }
    if (node.translation.size() == 3) {
        Matrix move;
        move.setTranslation(Vec3(float(node.translation[0]), float(node.translation[1]),
                                 float(node.translation[2])));
        matrix = matrix * move;
    }
    return matrix;
}

// Normals and UVs are kept only when both meshes have them.
void merge(Mesh& mesh, Mesh part) {
    const bool first = mesh.positions.empty();
    if (part.normals.size() != part.positions.size() || (!first && mesh.normals.empty())) {
        part.normals.clear();
        mesh.normals.clear();
    }
    if (part.uvs.size() != part.positions.size() || (!first && mesh.uvs.empty())) {
        part.uvs.clear();
        mesh.uvs.clear();
    }
    if (mesh.positions.size() + part.positions.size() > vertex_limit)
        throw Error("it has more than " + std::to_string(vertex_limit) + " vertices");
    append(mesh, part);
}

class Collector {
  public:
    explicit Collector(const tinygltf::Model& model) : model_(model) {}

    void visit(int index, const Matrix& world_from_parent, int depth) {
        if (index < 0 || std::size_t(index) >= model_.nodes.size())
            throw Error("a node is missing");
        if (depth > depth_limit || ++visits_ > model_.nodes.size())
            throw Error("its nodes are nested too deeply, or in a ring");
        const tinygltf::Node& node = model_.nodes[std::size_t(index)];
        const Matrix world_from_node = node_matrix(node) * world_from_parent;
        if (node.mesh >= 0)
            add(node.mesh, world_from_node);
        for (const int child : node.children)
            visit(child, world_from_node, depth + 1);
    }

    void add(int index, const Matrix& world_from_mesh) {
        if (std::size_t(index) >= model_.meshes.size())
            throw Error("a mesh is missing");
        for (const tinygltf::Primitive& primitive : model_.meshes[std::size_t(index)].primitives) {
            if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1)
                continue;
            Mesh part = primitive_mesh(model_, primitive);
            if (std::abs(world_from_mesh.determinant()) > 0)
                transform(part, world_from_mesh);
            merge(mesh, std::move(part));
        }
    }

    Mesh mesh;

  private:
    const tinygltf::Model& model_;
    std::size_t visits_ = 0; // at most the number of nodes in a tree
};

bool ignore_image(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                  const unsigned char*, int, void*) {
    return true; // only shapes are read, and image decoders are a risk with malicious files
}

void check_nesting(std::string_view json) {
    int depth = 0;
    bool in_text = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '"')
            in_text = !in_text;
        else if (in_text && c == '\\')
            ++i;
        else if (!in_text && (c == '[' || c == '{') && ++depth > nesting_limit)
            throw Error("its JSON is nested too deeply");
        else if (!in_text && (c == ']' || c == '}'))
            --depth;
    }
}

// The JSON chunk of a binary file, after a header of 12 bytes, its length and its kind.
std::string_view json_part(std::string_view bytes) {
    if (!bytes.starts_with("glTF"))
        return bytes;
    std::uint32_t length = 0;
    if (bytes.size() < 20)
        throw Error("it ends too early");
    std::memcpy(&length, bytes.data() + 12, sizeof length);
    return bytes.substr(20, length);
}

// Buffers are read by read_file, which checks for folders and limits the size.
bool read_buffer(std::vector<unsigned char>* out, std::string* problem, const std::string& path,
                 void*) {
    try {
        const std::string bytes = read_file(path, std::uint64_t{1} << 32);
        out->assign(bytes.begin(), bytes.end());
        return true;
    } catch (const Error& error) {
        *problem = error.what();
        return false;
    }
}

bool is_regular_file(const std::string& path, void*) {
    std::error_code code;
    return std::filesystem::is_regular_file(path, code); // not pipes or devices
}

template <class Callbacks>
Callbacks file_access() {
    Callbacks callbacks{};
    callbacks.FileExists = is_regular_file;
    callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
    callbacks.ReadWholeFile = read_buffer;
    callbacks.WriteWholeFile = [](std::string*, const std::string&,
                                  const std::vector<unsigned char>&, void*) { return false; };
    if constexpr (requires { callbacks.GetFileSizeInBytes; }) // since 2.9
        callbacks.GetFileSizeInBytes = [](std::size_t* size, std::string*, const std::string& path,
                                          void*) {
            std::error_code code;
            *size = std::filesystem::file_size(path, code);
            return !code;
        };
    return callbacks;
}

} // namespace

FileMesh read_gltf(std::string_view bytes, const std::string& folder) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(ignore_image, nullptr);
    loader.SetFsCallbacks(file_access<tinygltf::FsCallbacks>());
    check_nesting(json_part(bytes));
    tinygltf::Model model;
    std::string errors;
    std::string warnings;
    const auto size = static_cast<unsigned int>(bytes.size());
    bool ok = false;
    try {
        ok = bytes.starts_with("glTF")
                 ? loader.LoadBinaryFromMemory(&model, &errors, &warnings,
                                               reinterpret_cast<const unsigned char*>(bytes.data()),
                                               size, folder)
                 : loader.LoadASCIIFromString(&model, &errors, &warnings, bytes.data(), size,
                                              folder);
    } catch (const std::exception& problem) { // thrown by its JSON library
        errors = problem.what();
    }
    if (!ok)
        throw Error(errors.empty() ? "it is damaged" : errors.substr(0, errors.find('\n')));
    Collector collector(model);
    const int scene = model.defaultScene >= 0 ? model.defaultScene : 0;
    if (std::size_t(scene) < model.scenes.size()) {
        for (const int node : model.scenes[std::size_t(scene)].nodes)
            collector.visit(node, Matrix(), 0);
    } else {
        for (std::size_t i = 0; i < model.meshes.size(); ++i)
            collector.add(int(i), Matrix());
    }
    return to_file_mesh(collector.mesh);
}

} // namespace scree
