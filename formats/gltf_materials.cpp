// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_materials.h"

#include "core/error.h"
#include "formats/uri.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree::gltf {

namespace {

// Coordinates from the upper left and from the lower left into each other.
Imath::M33d upside_down() { return {1, 0, 0, 0, -1, 0, 0, 1, 1}; }

} // namespace

std::uint16_t FileMaterials::number_of(const Primitive& primitive) {
    const auto next = static_cast<std::uint16_t>(used_.size());
    const auto [known, first] = numbers_.try_emplace(primitive.material, next);
    if (first) {
        if (used_.size() == Mesh::most_parts)
            throw Error(fmt::format("it uses more than {} materials", Mesh::most_parts));
        used_.push_back(primitive.material);
    }
    return known->second;
}

std::size_t FileMaterials::uv_set(const Primitive& primitive) const {
    if (!primitive.material)
        return 0;
    const auto& texture = file_.materials[*primitive.material].color_texture;
    return texture ? texture->uv_set : 0;
}

void FileMaterials::note(const MaterialElement& element, const std::string& what) {
    std::string text = fmt::format("{} of {}", what, element.name);
    if (std::find(not_read_.begin(), not_read_.end(), text) == not_read_.end())
        not_read_.push_back(std::move(text));
}

std::optional<MeshPicture> FileMaterials::picture(const MaterialElement& element) {
    if (!element.color_texture)
        return std::nullopt;
    const TextureUse& use = *element.color_texture;
    const Texture& texture = file_.textures[use.texture];
    for (const std::string& what : texture.ignored)
        note(element, what);
    if (!texture.image) {
        note(element, fmt::format("textures[{}], which is no PNG or JPEG,", use.texture));
        return std::nullopt;
    }
    const auto [known, first] = pictures_.try_emplace(*texture.image);
    if (first) {
        known->second.name = fmt::format("images[{}]", *texture.image);
        try {
            find_content(file_.pictures[*texture.image], known->second);
        } catch (const Error& problem) { // told to whoever wants the picture
            known->second.problem = problem.diagnostics().front().message;
        }
    }
    MeshPicture picture = known->second;
    picture.repeats = texture.repeats;
    picture.picture_from_uv = upside_down() * use.picture_from_uv * upside_down();
    return picture;
}

void FileMaterials::find_content(const Picture& source, MeshPicture& picture) {
    if (source.view) {
        picture.bytes = std::make_shared<const std::string>(data_.bytes_of(*source.view));
    } else if (!source.uri) {
        throw Error("it has neither a uri nor a bufferView");
    } else if (auto bytes = data_of_uri(*source.uri)) {
        picture.bytes = std::make_shared<const std::string>(*std::move(bytes));
    } else {
        picture.path = file_of_uri(*source.uri, data_.folder());
    }
}

MeshMaterial FileMaterials::described(const MaterialElement& element) {
    for (const std::string& what : element.ignored)
        note(element, what);
    MeshMaterial out;
    out.name = element.name;
    out.color = element.color;
    out.picture = picture(element);
    out.metallic = element.metallic;
    out.roughness = element.roughness;
    out.ior = element.ior;
    out.transmission = element.transmission;
    out.absorption = element.absorption;
    out.coated = element.specular > 0;
    out.words = {.metallic = fmt::format("metallicFactor {:.3g}", element.metallic),
                 .ior = fmt::format("ior {:.3g}", element.ior),
                 .transmission = fmt::format("transmissionFactor {:.3g}", element.transmission)};
    return out;
}

void FileMaterials::give_to(FileMesh& mesh) {
    if (file_.materials.empty())
        return;
    MeshMaterials materials;
    for (const Index& material : used_)
        materials.list.push_back(material ? described(file_.materials[*material]) : MeshMaterial{});
    materials.not_read = std::move(not_read_);
    mesh.materials = std::make_shared<const MeshMaterials>(std::move(materials));
}

} // namespace scree::gltf
