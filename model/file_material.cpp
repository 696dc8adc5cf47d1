// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file_material.h"

#include "core/located.h"
#include "core/picture.h"
#include "geometry/mesh/mesh_material.h"
#include "model/picture_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>

namespace scree {

namespace {

/// The materials of a file, and what of them is not honoured.
struct Made {
    Materials materials;
    std::vector<std::string> not_honoured;
};

class Maker {
  public:
    Maker(const MeshMaterials& described, std::string name) : name_(std::move(name)) {
        made.not_honoured = described.not_read;
        for (const MeshMaterial& material : described.list)
            made.materials.push_back(std::make_shared<const Material>(material_from(material)));
    }

    Made made;

  private:
    Material material_from(const MeshMaterial& from) {
        const auto roughness = static_cast<float>(from.roughness);
        if (mostly(from, from.words.transmission, from.transmission, "clear", "opaque"))
            return glass_from(from, roughness);
        const Paint paint{texture_from(from), {}};
        if (mostly(from, from.words.metallic, from.metallic, "metal", "no metal"))
            return Metal{paint, roughness};
        if (from.coated)
            return Plastic{paint, roughness, ior_of(from)};
        return Matte{paint};
    }

    Material glass_from(const MeshMaterial& from, float roughness) {
        if (from.picture || from.color != Color(1.0F))
            note(from, "the colour", "which is clear");
        return Glass{ior_of(from), from.absorption, roughness};
    }

    /// A surface is either this or not.
    bool mostly(const MeshMaterial& from, const std::string& what, double share,
                const std::string& yes, const std::string& no) {
        if (share > 0 && share < 1)
            note(from, what, "taken as " + (share < 0.5 ? no : yes));
        return share >= 0.5;
    }

    float ior_of(const MeshMaterial& from) {
        const double ior = std::clamp(from.ior, least_ior, largest_ior);
        if (ior != from.ior)
            note(from, from.words.ior, fmt::format("taken as {}", ior));
        return static_cast<float>(ior);
    }

    Texture texture_from(const MeshMaterial& from) {
        if (!from.picture)
            return {from.color, nullptr};
        const MeshPicture& picture = *from.picture;
        PictureLook look;
        look.tint = from.color;
        look.picture_from_uv = picture.picture_from_uv;
        const Beyond beyond = picture.repeats ? Beyond::repeated : Beyond::clamped;
        return {from.color, picture_texture(filter_of(picture, beyond), look)};
    }

    /// Materials share the pictures that they have in common.
    std::shared_ptr<const PictureFilter> filter_of(const MeshPicture& picture, Beyond beyond) {
        std::shared_ptr<const PictureFilter>& known =
            pictures_[{picture.path, picture.bytes.get(), beyond}];
        if (!known) {
            const std::string name = name_ + ": " + picture.name;
            if (!picture.problem.empty())
                throw Error(name + ": " + picture.problem);
            const Picture read = picture.bytes == nullptr
                                     ? read_picture(picture.path)
                                     : read_picture_bytes(name, *picture.bytes);
            known = std::make_shared<const PictureFilter>(read.image, beyond);
        }
        return known;
    }

    void note(const MeshMaterial& from, const std::string& what, const std::string& instead) {
        made.not_honoured.push_back(fmt::format("{} of {} ({})", what, from.name, instead));
    }

    std::string name_;
    using Key = std::tuple<std::string, const std::string*, Beyond>;
    std::map<Key, std::shared_ptr<const PictureFilter>> pictures_;
};

/// Made once for all that show a mesh, and kept as long as the mesh is in use. `name`: of the mesh.
std::shared_ptr<const Made> made_from(const std::shared_ptr<const MeshMaterials>& described,
                                      const std::string& name) {
    static std::mutex mutex;
    static std::map<std::weak_ptr<const MeshMaterials>, std::shared_ptr<const Made>,
                    std::owner_less<>>
        known;
    const std::lock_guard lock(mutex);
    std::erase_if(known, [](const auto& entry) { return entry.first.expired(); });
    const auto found = known.find(described);
    if (found != known.end())
        return found->second;
    auto made = std::make_shared<const Made>(Maker(*described, name).made);
    known.emplace(described, made);
    return made;
}

bool shows_pictures(const MeshMaterials& materials) {
    return std::any_of(materials.list.begin(), materials.list.end(),
                       [](const MeshMaterial& material) { return material.picture.has_value(); });
}

std::string in_words(const std::vector<std::string>& items) {
    constexpr std::size_t most = 8;
    std::string out;
    for (std::size_t i = 0; i < std::min(most, items.size()); ++i)
        out += (i == 0 ? "" : ", ") + items[i];
    return items.size() > most ? fmt::format("{} and {} more", out, items.size() - most) : out;
}

} // namespace

ParamSpec shape_material_spec(const std::string& doc) {
    ParamSpec spec = material_spec(doc + ", or \"file\" for those of the shape's file");
    spec.choices = {"file"};
    return spec;
}

Materials materials_of(const Params& params, const Mesh* shape) {
    if (auto material = params.object<Material>("material")) {
        if (shape != nullptr && std::holds_alternative<Fibre>(*material))
            throw params.error("material", shape->name + " is a mesh; material.fibre is for curves",
                               "shape = curve.polyline { ... } or another curve.*");
        if (shape != nullptr && shape->uvs.empty() && shows_picture(*material))
            params.warn("material", shape->name +
                                        ": a picture on it is of one colour, since it has "
                                        "no texture coordinates");
        return {std::move(material)};
    }
    if (!params.has("material"))
        return {};
    const std::string name = shape == nullptr ? "the shape" : shape->name;
    if (shape == nullptr || shape->materials == nullptr)
        throw params.error("material", name + " is from no file that could have materials",
                           "expected a material.*, or shape = mesh.file { ... }");
    if (shape->materials->list.empty())
        throw params.error(
            "material",
            name + " has no materials" +
                (shape->materials->problem.empty() ? "" : ": " + shape->materials->problem),
            "expected a material.*, such as material.matte {}");
    const std::shared_ptr<const Made> made =
        located(params, "material", [&] { return made_from(shape->materials, name); });
    if (!made->not_honoured.empty())
        params.warn("material",
                    fmt::format("{}: not honoured: {}", name, in_words(made->not_honoured)));
    if (shape->uvs.empty() && shows_pictures(*shape->materials))
        params.warn("material", name + ": its pictures are not shown, since it has no texture "
                                       "coordinates");
    return made->materials;
}

} // namespace scree
