// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_parse_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scree::gltf {

namespace {

/// Where in a picture a UV lies, both from the upper left: scaled, turned clockwise, then moved.
Imath::M33d picture_from_uv(const JsonElement& transform) {
    const std::vector<double> move = transform.numbers("offset", {0, 0});
    const std::vector<double> scale = transform.numbers("scale", {1, 1});
    const double angle = transform.number("rotation", 0);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // For row vectors, as all matrices: (u, v, 1) * M.
    return {scale[0] * c, -scale[0] * s, 0, scale[1] * s, scale[1] * c, 0, move[0], move[1], 1};
}

TextureUse texture_use(const JsonElement& element, std::size_t textures) {
    TextureUse use;
    use.texture = element.at("index").reference(textures, "textures");
    use.uv_set = element.integer("texCoord", 0);
    if (const auto extensions = element.find("extensions"))
        if (const auto transform = extensions->find("KHR_texture_transform")) {
            use.picture_from_uv = picture_from_uv(*transform);
            use.uv_set = transform->integer("texCoord", use.uv_set);
        }
    return use;
}

/// A number from 0 to 1; others are brought into that range, and noted.
double share(double value, const std::string& name, std::vector<std::string>& ignored) {
    if (value >= 0 && value <= 1)
        return value;
    ignored.push_back(fmt::format("{} {}", name, value));
    return std::clamp(value, 0.0, 1.0);
}

double share(const JsonElement& element, const std::string& name, double fallback,
             MaterialElement& out) {
    return share(element.number(name, fallback), name, out.ignored);
}

/// The first three numbers of a colour factor, linear.
Color color(const JsonElement& element, const std::string& name,
            const std::vector<double>& fallback, MaterialElement& out) {
    const std::vector<double> numbers = element.numbers(name, fallback);
    Color color;
    for (int i = 0; i < 3; ++i)
        color[i] = static_cast<float>(share(numbers[std::size_t(i)], name, out.ignored));
    return color;
}

/// Names the fields of an object that are not among the known ones.
void note_others(const JsonElement& element, std::initializer_list<const char*> known,
                 std::vector<std::string>& ignored) {
    for (const std::string& name : element.names())
        if (std::find(known.begin(), known.end(), name) == known.end())
            ignored.push_back(name);
}

void parse_metallic_roughness(const JsonElement& element, std::size_t textures,
                              MaterialElement& out) {
    out.color = color(element, "baseColorFactor", {1, 1, 1, 1}, out);
    if (const auto texture = element.find("baseColorTexture"))
        out.color_texture = texture_use(*texture, textures);
    out.metallic = share(element, "metallicFactor", 1, out);
    out.roughness = share(element, "roughnessFactor", 1, out);
    note_others(
        element,
        {"baseColorFactor", "baseColorTexture", "metallicFactor", "roughnessFactor", "extras"},
        out.ignored);
}

void parse_volume(const JsonElement& element, MaterialElement& out) {
    const Color transmitted = color(element, "attenuationColor", {1, 1, 1}, out);
    const double distance = element.number("attenuationDistance", 0); // infinite when absent
    if (distance < 0)
        out.ignored.push_back(fmt::format("attenuationDistance {}", distance));
    constexpr double least = 1e-6; // what a channel of 0 lets through: Beer's law has no 0
    for (int i = 0; i < 3 && distance > 0; ++i)
        out.absorption[i] =
            static_cast<float>(-std::log(std::max(double(transmitted[i]), least)) / distance);
}

void parse_extension(const std::string& name, const JsonElement& element, MaterialElement& out) {
    if (name == "KHR_materials_ior") {
        out.ior = element.number("ior", 1.5);
    } else if (name == "KHR_materials_transmission") {
        out.transmission = share(element, "transmissionFactor", 0, out);
        note_others(element, {"transmissionFactor", "extras"}, out.ignored);
    } else if (name == "KHR_materials_volume") {
        parse_volume(element, out);
        note_others(element,
                    {"attenuationColor", "attenuationDistance", "thicknessFactor", "extras"},
                    out.ignored);
    } else if (name == "KHR_materials_specular") {
        out.specular = element.number("specularFactor", 1);
        note_others(element, {"specularFactor", "extras"}, out.ignored);
    } else {
        out.ignored.push_back(name);
    }
}

} // namespace

MaterialElement parse_material(const JsonElement& element, std::size_t textures) {
    MaterialElement out;
    out.name = element.text("name", element.path());
    if (const auto metallic_roughness = element.find("pbrMetallicRoughness"))
        parse_metallic_roughness(*metallic_roughness, textures, out);
    if (const auto extensions = element.find("extensions"))
        for (const std::string& name : extensions->names())
            parse_extension(name, extensions->at(name), out);
    if (const std::string mode = element.text("alphaMode", "OPAQUE"); mode != "OPAQUE")
        out.ignored.push_back("alphaMode " + mode);
    // Surfaces scatter on both sides, whatever doubleSided says.
    note_others(element,
                {"name", "pbrMetallicRoughness", "extensions", "alphaMode", "alphaCutoff",
                 "doubleSided", "extras"},
                out.ignored);
    return out;
}

} // namespace scree::gltf
