// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/peer_scene.h"

#include "core/file.h"
#include "geometry/mesh/strand_spline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace scree::bench {

namespace {

constexpr int texture_size = 1024; // pixels per side

/// A name of JSON with its value, which is JSON already.
std::string field(const std::string& name, const std::string& value) {
    return fmt::format("\"{}\": {}", name, value);
}
std::string field(const std::string& name, double value) {
    return fmt::format("\"{}\": {}", name, value);
}
std::string word(const std::string& text) { return '"' + text + '"'; }
std::string object(const std::vector<std::string>& fields) {
    return fmt::format("{{{}}}", fmt::join(fields, ", "));
}
std::string array(const std::vector<std::string>& items) {
    return fmt::format("[{}]", fmt::join(items, ",\n"));
}
template <class V>
std::string vector(const V& v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

/// Three rows of four, as in baked JSON: takes a column vector to the world.
std::string matrix(const WideVec3& x, const WideVec3& y, const WideVec3& z, const WideVec3& at) {
    std::vector<double> numbers;
    for (int row = 0; row < 3; ++row)
        numbers.insert(numbers.end(), {x[row], y[row], z[row], at[row]});
    return fmt::format("[{}]", fmt::join(numbers, ", "));
}
WideVec3 row(const WideMatrix& m, int i) { return {m[i][0], m[i][1], m[i][2]}; }
std::string matrix(const WideMatrix& m) {
    return matrix(row(m, 0), row(m, 1), row(m, 2), row(m, 3));
}

[[noreturn]] void refuse(const std::string& what) {
    throw Error::usage("no peer is known to show the same: " + what);
}

class Writer {
  public:
    explicit Writer(std::string folder) : folder_(std::move(folder)) {}

    void write(const Scene& scene) {
        std::vector<std::string> lights;
        for (const Light& light : scene.lights)
            lights.push_back(std::visit([&](const auto& of) { return light_json(of); }, light));
        for (const Aggregate& aggregate : scene.aggregates)
            add(aggregate);
        const FilmSettings& film = scene.film;
        write_file(folder_ + "/scene.bin", data_);
        write_file(folder_ + "/scene.json",
                   object({field("width", film.width), field("height", film.height),
                           field("depth", film.depth), field("camera", camera_json(*scene.camera)),
                           field("lights", array(lights)), field("materials", array(materials_)),
                           field("shapes", array(shapes_)), field("objects", array(objects_))}));
    }

  private:
    /// Where an array of 32-bit numbers lies in the file of numbers: its first one and how many.
    template <class T>
    std::string numbers(const std::vector<T>& values) {
        const std::size_t first = data_.size() / 4;
        data_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        return fmt::format("[{}, {}]", first, values.size() * sizeof(T) / 4);
    }

    static std::string camera_json(const Camera& camera) {
        const WideVec3 back = (camera.from - camera.at).normalized();
        const WideVec3 right = WideVec3(camera.up).cross(back).normalized();
        return object({field("matrix", matrix(right, back.cross(right), back, camera.from)),
                       field("fov", double(camera.fov))});
    }

    static std::string light_json(const Sky& sky) {
        if (sky.image != nullptr)
            refuse("a sky with an image");
        return object({field("kind", word("sky")),
                       field("zenith", vector(sky.zenith * sky.strength)),
                       field("horizon", vector(sky.horizon * sky.strength)),
                       field("ground", vector(sky.ground * sky.strength))});
    }
    static std::string light_json(const Sun& sun) {
        return object({field("kind", word("sun")), field("direction", vector(sun.direction)),
                       field("angle", double(sun.angle)),
                       field("irradiance", vector(sun.color * sun.strength))});
    }
    static std::string light_json(const AreaLight& light) {
        const WideVec3 x(light.edge_u.normalized());
        const WideVec3 z(light.normal());
        return object(
            {field("kind", word("area")), field("matrix", matrix(x, z.cross(x), z, light.centre)),
             field("size", fmt::format("[{}, {}]", light.edge_u.length(), light.edge_v.length())),
             field("radiance", vector(light.radiance))});
    }

    // A constant colour, "instance" for that of the object, or the name of a picture.
    std::string paint_json(const Paint& paint) {
        if (!paint.palette.empty())
            return word("instance");
        if (paint.texture.procedural == nullptr)
            return vector(paint.texture.constant);
        return word(picture(*paint.texture.procedural));
    }

    // Evaluates a texture over the UV square.
    std::string picture(const Procedural& procedural) {
        if (procedural.solid())
            refuse("a solid texture");
        Image image(texture_size, texture_size, {"R", "G", "B"});
        std::vector<ShadingPoint> points;
        for (int y = 0; y < texture_size; ++y)
            for (int x = 0; x < texture_size; ++x) {
                ShadingPoint point;
                point.uv = {(float(x) + 0.5F) / texture_size, 1 - (float(y) + 0.5F) / texture_size};
                point.uv_footprint = 1.0F / texture_size;
                points.push_back(point);
            }
        std::vector<ShadingSample> samples(points.size());
        procedural.bake(points, samples, nullptr);
        for (std::size_t i = 0; i < samples.size(); ++i)
            for (int channel = 0; channel < 3; ++channel)
                image.pixels[3 * i + std::size_t(channel)] = samples[i].color[channel];
        std::string name = fmt::format("texture{}.exr", ++pictures_);
        const ImagePart part{"texture", std::move(image), false};
        write_exr(folder_ + "/" + name, {&part, 1}, {});
        return name;
    }

    std::string material_json(const Material& material) {
        if (const auto* matte = std::get_if<Matte>(&material))
            return object({field("kind", word("matte")), field("color", paint_json(matte->paint))});
        if (const auto* plastic = std::get_if<Plastic>(&material))
            return object({field("kind", word("plastic")),
                           field("color", paint_json(plastic->paint)),
                           field("roughness", double(plastic->roughness)),
                           field("ior", double(plastic->ior))});
        if (const auto* metal = std::get_if<Metal>(&material))
            return object({field("kind", word("metal")), field("color", paint_json(metal->paint)),
                           field("roughness", double(metal->roughness))});
        const auto* glass = std::get_if<Glass>(&material);
        if (glass == nullptr || glass->absorption.length2() > 0)
            refuse("a material that is none of matte, plastic, metal and clear glass");
        return object({field("kind", word("glass")), field("roughness", double(glass->roughness)),
                       field("ior", double(glass->ior))});
    }

    std::size_t material(const std::shared_ptr<const Material>& material) {
        const auto [found, is_new] = material_index_.try_emplace(material, materials_.size());
        if (is_new)
            materials_.push_back(
                material_json(material == nullptr ? Material(Matte{}) : *material));
        return found->second;
    }

    std::string mesh_json(const Mesh& mesh, std::size_t material) {
        return object({field("material", double(material)),
                       field("positions", numbers(mesh.positions)),
                       field("normals", numbers(mesh.normals)), field("uvs", numbers(mesh.uvs)),
                       field("triangles", numbers(mesh.triangles))});
    }

    // The points that the splines pass, which do for Catmull-Rom's, too.
    std::string strands_json(const Strands& strands, std::size_t material) {
        if (strands.kind != CurveKind::bspline)
            refuse("a chain of straight strands");
        std::vector<Vec3> points;
        std::vector<std::uint32_t> ends;
        for (std::size_t i = 0; i < strands.count(); ++i) {
            const std::uint32_t last = strands.offsets[i + 1] - 4;
            for (std::uint32_t piece = strands.offsets[i]; piece <= last; ++piece)
                points.push_back(spline_point(&strands.points[piece], 0));
            points.push_back(spline_point(&strands.points[last], 1));
            ends.push_back(static_cast<std::uint32_t>(points.size()));
        }
        return object({field("material", double(material)), field("points", numbers(points)),
                       field("ends", numbers(ends)), field("radius", double(strands.radii[0]))});
    }

    // Prototypes of one shape and material share it, as single objects of one mesh do.
    std::size_t shape(const Prototype& prototype) {
        if (prototype.materials.size() > 1)
            refuse("a mesh of several materials");
        const std::size_t of =
            material(prototype.materials.empty() ? nullptr : prototype.materials.front());
        const auto [found, is_new] =
            shape_index_.try_emplace({prototype.shape, of}, shapes_.size());
        if (is_new)
            shapes_.push_back(prototype.strands() != nullptr
                                  ? strands_json(*prototype.strands(), of)
                                  : mesh_json(*prototype.mesh(), of));
        return found->second;
    }

    void add(const Aggregate& aggregate) {
        for (const Instance& instance : aggregate.instances) {
            const Prototype& prototype = aggregate.prototypes[instance.prototype];
            const Paint* paint = paint_of(prototype.materials);
            const std::optional<Color> color =
                paint == nullptr ? std::nullopt : paint->one_color(instance.random);
            objects_.push_back(object({field("shape", double(shape(prototype))),
                                       field("matrix", matrix(instance.world_from_object)),
                                       field("color", vector(color.value_or(Color(1.0F))))}));
        }
    }

    std::string folder_;
    std::string data_; // scene.bin
    std::vector<std::string> materials_;
    std::vector<std::string> shapes_;
    std::vector<std::string> objects_;
    std::map<std::shared_ptr<const Material>, std::size_t> material_index_;
    std::map<std::pair<Shape, std::size_t>, std::size_t> shape_index_; // by shape and material
    int pictures_ = 0;
};

} // namespace

void write_peer_scene(const Scene& scene, const std::string& folder) {
    Writer(folder).write(scene);
}

} // namespace scree::bench
