// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_container.h"
#include "formats/gltf_materials.h"
#include "formats/gltf_shape.h"
#include "formats/gltf_skin.h"
#include "formats/read_mesh.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace scree {

namespace {

using namespace gltf;

/// Where the instances of a node lie, in its frame; the node itself when it has none.
std::vector<Imath::M44d> instances_of(const Node& node, std::size_t number, Data& data) {
    if (node.instances.empty())
        return {Imath::M44d()};
    std::size_t count = 0;
    const auto numbers = [&](const std::string& name, std::size_t width) -> std::vector<double> {
        const auto found = node.instances.find(name);
        if (found == node.instances.end())
            return {};
        std::vector<double> out = data.numbers(found->second, width);
        if (count != 0 && out.size() / width != count)
            throw Error(fmt::format("nodes[{}]: its instances differ in number: {} and {}", number,
                                    count, out.size() / width));
        count = out.size() / width;
        return out;
    };
    const std::vector<double> move = numbers("TRANSLATION", 3);
    const std::vector<double> turn = numbers("ROTATION", 4);
    const std::vector<double> scale = numbers("SCALE", 3);
    std::vector<Imath::M44d> out;
    for (std::size_t i = 0; i < count; ++i) {
        const auto vector = [&](const std::vector<double>& from, double fallback) {
            return from.empty() ? Imath::V3d(fallback)
                                : Imath::V3d(from[3 * i], from[3 * i + 1], from[3 * i + 2]);
        };
        const Imath::Quatd rotation = turn.empty() ? Imath::Quatd()
                                                   : Imath::Quatd(turn[4 * i + 3], turn[4 * i],
                                                                  turn[4 * i + 1], turn[4 * i + 2]);
        out.push_back(placement(vector(move, 0), rotation, vector(scale, 1)));
    }
    return out;
}

class Collector {
  public:
    Collector(const File& file, Data& data)
        : file_(file), data_(data), places_(node_places(file)), materials_(file, data) {}

    FileMesh collect() && {
        for (std::size_t i = 0; i < file_.nodes.size(); ++i)
            if (file_.nodes[i].mesh) {
                if (places_.seen[i])
                    add_node(i);
                else
                    ++unseen_;
            }
        if (file_.nodes.empty()) // a library of meshes
            for (const MeshElement& mesh : file_.meshes)
                for (const Primitive& primitive : mesh.primitives)
                    add(primitive, mesh.weights, {Imath::M44d()}, std::nullopt);
        check_found();
        FileMesh mesh = merged();
        materials_.give_to(mesh);
        add_warnings(mesh.warnings);
        return mesh;
    }

  private:
    void add_node(std::size_t number) {
        const Node& node = file_.nodes[number];
        const MeshElement& mesh = file_.meshes[*node.mesh];
        const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
        if (node.skin && !node.instances.empty())
            throw Error(fmt::format("nodes[{}] has both a skin and instances", number));
        std::vector<Imath::M44d> places;
        for (const Imath::M44d& instance : instances_of(node, number, data_))
            places.push_back(instance * places_.world_from_node[number]);
        for (const Primitive& primitive : mesh.primitives)
            add(primitive, weights, places, node.skin);
    }

    void add(const Primitive& primitive, const std::vector<double>& weights,
             const std::vector<Imath::M44d>& places, Index skin) {
        if (!has_triangles(primitive)) {
            ++not_triangles_;
            return;
        }
        if (primitive.draco && has_no_other_copy(primitive))
            throw Error(primitive.path + " is compressed by KHR_draco_mesh_compression, which is "
                                         "not read; export it without");
        const Vertices vertices =
            vertices_of(primitive, weights, materials_.uv_set(primitive), data_);
        const std::vector<Mesh::Triangle> triangles =
            triangles_of(primitive, vertices.positions.size(), data_, indices_left_);
        colored_ += primitive.attributes.contains("COLOR_0") ? 1 : 0;
        if (skin) {
            add_part(primitive, placed(vertices, triangles,
                                       skin_matrices(file_, *skin, primitive,
                                                     vertices.positions.size(), places_, data_)));
            return;
        }
        for (const Imath::M44d& place : places) {
            if (keeps_area(place))
                add_part(primitive, placed(vertices, triangles, {place}));
            else
                ++shrunk_;
        }
    }

    /// Whether an accessor of a compressed primitive has no data of its own.
    bool has_no_other_copy(const Primitive& primitive) const {
        const auto is_empty = [&](std::size_t accessor) {
            return !file_.accessors[accessor].view && !file_.accessors[accessor].sparse;
        };
        return (primitive.indices && is_empty(*primitive.indices)) ||
               std::any_of(primitive.attributes.begin(), primitive.attributes.end(),
                           [&](const auto& attribute) { return is_empty(attribute.second); });
    }

    void add_part(const Primitive& primitive, FileMesh part) {
        vertices_ += part.positions.size();
        if (vertices_ > vertex_limit)
            throw Error(fmt::format("it has more than {} vertices", vertex_limit));
        part.parts.assign(part.triangles.size(), materials_.number_of(primitive));
        parts_.push_back(std::move(part));
    }

    void check_found() const {
        const bool any = std::any_of(parts_.begin(), parts_.end(),
                                     [](const FileMesh& part) { return !part.triangles.empty(); });
        if (any)
            return;
        if (shrunk_ > 0)
            throw Error("all it shows is shrunk to nothing by a scale of 0");
        if (not_triangles_ > 0)
            throw Error("it has only points and lines; a mesh needs triangles");
        if (unseen_ > 0)
            throw Error("its scene shows no mesh");
    }

    /// All parts in one. Where some have normals, the others get those of their faces; where some
    /// have UVs, those of the others are 0.
    FileMesh merged() {
        const auto some = [&](auto has) { return std::any_of(parts_.begin(), parts_.end(), has); };
        const bool normals = some([](const FileMesh& part) { return !part.normals.empty(); });
        const bool uvs = some([](const FileMesh& part) { return !part.uvs.empty(); });
        FileMesh mesh;
        for (FileMesh& part : parts_) {
            if (normals && part.normals.empty())
                make_flat(part);
            if (uvs)
                part.uvs.resize(part.positions.size(), Vec2f(0.0F));
            append(mesh, std::exchange(part, {}));
        }
        return mesh;
    }

    void add_warnings(std::vector<std::string>& warnings) const {
        if (not_triangles_ > 0)
            warnings.push_back(fmt::format(
                "{} of its primitives are points or lines, which are not read", not_triangles_));
        if (indices_left_ > 0)
            warnings.push_back(fmt::format("{} of its vertex numbers, at the ends of primitives, "
                                           "make no triangle and are not read",
                                           indices_left_));
        if (unseen_ > 0)
            warnings.push_back(fmt::format("{} of its nodes with meshes are hidden, or not in the "
                                           "scene that it shows, and are not read",
                                           unseen_));
        if (colored_ > 0)
            warnings.emplace_back("its vertex colours are not read");
    }

    const File& file_;
    Data& data_;
    NodePlaces places_;
    FileMaterials materials_;
    std::vector<FileMesh> parts_;
    std::size_t vertices_ = 0;
    std::size_t not_triangles_ = 0; // primitives
    std::size_t shrunk_ = 0;        // primitives
    std::size_t unseen_ = 0;        // nodes
    std::size_t colored_ = 0;       // primitives
    std::size_t indices_left_ = 0;
};

} // namespace

FileMesh read_gltf(std::string_view bytes, const std::string& folder) {
    const Container container = container_of(bytes);
    const File file = parse(container.json);
    Data data(file, container.binary, folder);
    FileMesh mesh = Collector(file, data).collect();
    if (container.beyond > 0)
        mesh.warnings.push_back(fmt::format("the {} bytes beyond the length that its header names "
                                            "are not read",
                                            container.beyond));
    return mesh;
}

} // namespace scree
