// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_file.h"
#include "formats/gltf_nodes.h"
#include "formats/gltf_parse_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace scree::gltf {

namespace {

// What is required beyond these changes shapes in ways that are not known here. Those that begin so
// say nothing of shapes.
constexpr std::array known_extensions{"KHR_mesh_quantization", "EXT_mesh_gpu_instancing",
                                      "KHR_node_visibility"};
constexpr std::array unrelated_extensions{"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                          "MSFT_texture_",  "KHR_lights_",  "EXT_lights_",
                                          "KHR_animation_", "KHR_xmp"};

void check_required(const JsonElement& root) {
    const auto required = root.find("extensionsRequired");
    if (!required)
        return;
    for (const JsonElement& item : required->items()) {
        const std::string name = item.text();
        const bool known = std::find(known_extensions.begin(), known_extensions.end(), name) !=
                               known_extensions.end() ||
                           std::any_of(unrelated_extensions.begin(), unrelated_extensions.end(),
                                       [&](const char* start) { return name.starts_with(start); });
        if (!known)
            throw Error(fmt::format("it requires the extension {}, which is not read; export it "
                                    "without",
                                    name));
    }
}

void check_version(const JsonElement& root) {
    const JsonElement asset = root.at("asset");
    const std::string version = asset.at("version").text();
    if (!version.starts_with("2."))
        throw Error(fmt::format("it is of glTF version {}; only version 2 is read", version));
    const std::string least = asset.text("minVersion", "2.0");
    if (least != "2.0")
        throw Error(fmt::format("it needs a reader of glTF {}; only version 2.0 is known", least));
}

/// The lists of the file, and elements that name items of them by their numbers.
class Parser {
  public:
    explicit Parser(const JsonElement& root) {
        for (const char* name : {"accessors", "buffers", "bufferViews", "images", "materials",
                                 "meshes", "nodes", "samplers", "scenes", "skins", "textures"})
            lists_.emplace(name, root.items(name));
    }

    const std::vector<JsonElement>& list(const std::string& name) const { return lists_.at(name); }

    template <class T, class Parse>
    std::vector<T> list(const std::string& name, const Parse& parse) const {
        std::vector<T> out;
        for (const JsonElement& item : list(name))
            out.push_back(parse(item));
        return out;
    }

    std::size_t reference(const JsonElement& number, const std::string& list) const {
        return number.reference(lists_.at(list).size(), list);
    }

    Index find(const JsonElement& element, const std::string& name, const std::string& list) const {
        const auto found = element.find(name);
        return found ? Index(reference(*found, list)) : std::nullopt;
    }

    std::size_t at(const JsonElement& element, const std::string& name,
                   const std::string& list) const {
        return reference(element.at(name), list);
    }

    std::vector<std::size_t> all(const JsonElement& element, const std::string& name,
                                 const std::string& list) const {
        std::vector<std::size_t> out;
        for (const JsonElement& item : element.items(name))
            out.push_back(reference(item, list));
        return out;
    }

    Attributes attributes(const JsonElement& element) const {
        Attributes out;
        for (const std::string& name : element.names())
            out.emplace(name, at(element, name, "accessors"));
        return out;
    }

  private:
    std::map<std::string, std::vector<JsonElement>> lists_;
};

std::optional<JsonElement> extension(const JsonElement& element, const std::string& name) {
    const auto extensions = element.find("extensions");
    return extensions ? extensions->find(name) : std::nullopt;
}

Component component_of(const JsonElement& element) {
    const std::size_t code = element.at("componentType").integer();
    for (const Component known : {Component::int8, Component::uint8, Component::int16,
                                  Component::uint16, Component::uint32, Component::float32})
        if (std::size_t(known) == code)
            return known;
    throw element.error(fmt::format("has the unknown componentType {}", code));
}

std::size_t width_of(const JsonElement& element) {
    static const std::map<std::string, std::size_t> widths{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3},
                                                           {"VEC4", 4},   {"MAT2", 4}, {"MAT3", 9},
                                                           {"MAT4", 16}};
    const std::string type = element.at("type").text();
    const auto found = widths.find(type);
    if (found == widths.end())
        throw element.error("has the unknown type " + type);
    return found->second;
}

BufferView buffer_view(const Parser& parser, const JsonElement& element) {
    BufferView view;
    view.buffer = parser.at(element, "buffer", "buffers");
    view.offset = element.integer("byteOffset", 0);
    view.length = element.at("byteLength").integer();
    view.stride = element.integer("byteStride", 0);
    if (const auto extensions = element.find("extensions"))
        for (const std::string& name : extensions->names())
            if (name.ends_with("_meshopt_compression"))
                view.compression = name;
    return view;
}

Sparse sparse(const Parser& parser, const JsonElement& element) {
    Sparse out;
    out.count = element.at("count").integer();
    const JsonElement indices = element.at("indices");
    out.indices_view = parser.at(indices, "bufferView", "bufferViews");
    out.indices_offset = indices.integer("byteOffset", 0);
    out.indices_component = component_of(indices);
    const JsonElement values = element.at("values");
    out.values_view = parser.at(values, "bufferView", "bufferViews");
    out.values_offset = values.integer("byteOffset", 0);
    return out;
}

Accessor accessor(const Parser& parser, const JsonElement& element) {
    Accessor out;
    out.view = parser.find(element, "bufferView", "bufferViews");
    out.offset = element.integer("byteOffset", 0);
    out.component = component_of(element);
    out.normalized = element.flag("normalized", false);
    out.count = element.at("count").integer();
    out.width = width_of(element);
    if (const auto replaced = element.find("sparse"))
        out.sparse = sparse(parser, *replaced);
    return out;
}

MeshElement mesh(const Parser& parser, const JsonElement& element) {
    MeshElement out;
    for (const JsonElement& item : element.items("primitives")) {
        Primitive primitive;
        primitive.path = item.path();
        primitive.attributes = parser.attributes(item.at("attributes"));
        primitive.indices = parser.find(item, "indices", "accessors");
        primitive.mode = item.integer("mode", 4);
        if (primitive.mode > 6)
            throw item.error(fmt::format("has the unknown mode {}", primitive.mode));
        for (const JsonElement& target : item.items("targets"))
            primitive.targets.push_back(parser.attributes(target));
        primitive.material = parser.find(item, "material", "materials");
        primitive.draco = extension(item, "KHR_draco_mesh_compression").has_value();
        out.primitives.push_back(std::move(primitive));
    }
    out.weights = element.numbers("weights", {});
    return out;
}

Imath::M44d matrix_of(const JsonElement& element) {
    Imath::M44d matrix;
    if (const auto given = element.find("matrix")) {
        const std::vector<double> numbers = given->numbers(16);
        for (int i = 0; i < 16; ++i) // columns for column vectors are Imath's rows
            matrix[i / 4][i % 4] = numbers[std::size_t(i)];
        if (matrix[0][3] != 0 || matrix[1][3] != 0 || matrix[2][3] != 0 || matrix[3][3] != 1)
            throw given->error("must have 0, 0, 0, 1 in its last row");
        return matrix;
    }
    const std::vector<double> move = element.numbers("translation", {0, 0, 0});
    const std::vector<double> turn = element.numbers("rotation", {0, 0, 0, 1});
    const std::vector<double> scale = element.numbers("scale", {1, 1, 1});
    if (std::all_of(turn.begin(), turn.end(), [](double x) { return x == 0; }))
        throw element.error("has a rotation of four zeros, which is none");
    return placement({move[0], move[1], move[2]}, {turn[3], turn[0], turn[1], turn[2]},
                     {scale[0], scale[1], scale[2]});
}

Node node(const Parser& parser, const JsonElement& element) {
    Node out;
    out.parent_from_node = matrix_of(element);
    out.children = parser.all(element, "children", "nodes");
    out.mesh = parser.find(element, "mesh", "meshes");
    out.skin = parser.find(element, "skin", "skins");
    out.weights = element.numbers("weights", {});
    if (const auto instancing = extension(element, "EXT_mesh_gpu_instancing"))
        out.instances = parser.attributes(instancing->at("attributes"));
    if (const auto visibility = extension(element, "KHR_node_visibility"))
        out.visible = visibility->flag("visible", true);
    return out;
}

Texture texture(const Parser& parser, const JsonElement& element) {
    constexpr std::size_t clamped = 33071;
    constexpr std::size_t mirrored = 33648;
    constexpr std::size_t repeated = 10497;
    Texture out;
    out.image = parser.find(element, "source", "images");
    if (const Index sampler = parser.find(element, "sampler", "samplers")) {
        const JsonElement& settings = parser.list("samplers")[*sampler];
        const std::size_t along_u = settings.integer("wrapS", repeated);
        const std::size_t along_v = settings.integer("wrapT", repeated);
        out.repeats = along_u != clamped;
        if (along_u != along_v)
            out.ignored.emplace_back("wrapT other than wrapS");
        if (along_u == mirrored)
            out.ignored.emplace_back("mirrored repeats");
    }
    return out;
}

} // namespace

std::size_t size_of(Component component) {
    switch (component) {
    case Component::int8:
    case Component::uint8:
        return 1;
    case Component::int16:
    case Component::uint16:
        return 2;
    default:
        return 4;
    }
}

File parse(std::string_view json) {
    const JsonDocument document(json);
    const JsonElement root = document.root();
    check_version(root);
    check_required(root);
    const Parser parser(root);
    const auto with_parser = [&](auto parse) {
        return [&parser, parse](const JsonElement& element) { return parse(parser, element); };
    };
    File file;
    file.buffers = parser.list<Buffer>("buffers", [](const JsonElement& element) {
        Buffer buffer;
        if (const auto uri = element.find("uri"))
            buffer.uri = uri->text();
        buffer.length = element.at("byteLength").integer();
        return buffer;
    });
    file.views = parser.list<BufferView>("bufferViews", with_parser(buffer_view));
    file.accessors = parser.list<Accessor>("accessors", with_parser(accessor));
    file.meshes = parser.list<MeshElement>("meshes", with_parser(mesh));
    file.nodes = parser.list<Node>("nodes", with_parser(node));
    file.skins = parser.list<Skin>("skins", [&](const JsonElement& element) {
        return Skin{parser.all(element, "joints", "nodes"),
                    parser.find(element, "inverseBindMatrices", "accessors")};
    });
    file.textures = parser.list<Texture>("textures", with_parser(texture));
    file.pictures = parser.list<Picture>("images", [&](const JsonElement& element) {
        Picture picture;
        if (const auto uri = element.find("uri"))
            picture.uri = uri->text();
        picture.view = parser.find(element, "bufferView", "bufferViews");
        return picture;
    });
    const std::size_t textures = file.textures.size();
    file.materials = parser.list<MaterialElement>(
        "materials", [&](const JsonElement& element) { return parse_material(element, textures); });
    file.scenes = parser.list<std::vector<std::size_t>>("scenes", [&](const JsonElement& element) {
        return parser.all(element, "nodes", "nodes");
    });
    file.scene = parser.find(root, "scene", "scenes");
    return file;
}

} // namespace scree::gltf
