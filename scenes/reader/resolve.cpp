// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"
#include "core/random.h"
#include "scenes/reader/maker.h"
#include "scenes/reader/scene.h"
#include "scenes/reader/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scree {

namespace {

// Row vectors: scaled first, then turned about x, y and z, then moved.
Matrix object_matrix(const Params& params) {
    const Vec3& turn = params.vector3("rotation");
    Matrix scale;
    Matrix about_x;
    Matrix about_y;
    Matrix about_z;
    Matrix move;
    scale.setScale(params.vector3("scale"));
    about_x.setAxisAngle(Vec3(1, 0, 0), turn.x);
    about_y.setAxisAngle(Vec3(0, 1, 0), turn.y);
    about_z.setAxisAngle(Vec3(0, 0, 1), turn.z);
    move.setTranslation(params.vector3("position"));
    return scale * about_x * about_y * about_z * move;
}

Aggregate bake_object(const Params& params, std::uint64_t index) {
    Aggregate out;
    out.generator = "object";
    const auto mesh = params.mesh("shape");
    out.prototypes.push_back({mesh->name, mesh, nullptr, params.material("material")});
    Instance instance;
    instance.world_from_object = object_matrix(params);
    instance.random = Random(0, Purpose::instance_attribute, index).uniform_float();
    out.instances.push_back(instance);
    return out;
}

class SceneMaker {
  public:
    explicit SceneMaker(Scene& scene) : scene_(scene), maker_(mistakes_) {}

    void make(const Description& root) {
        if (root.kind != "scene")
            throw Error(Diagnostic{root.where,
                                   {},
                                   "expected scene { ... }, got " + in_words(root),
                                   "a script ends with: return scene { ... }"});
        const auto* fields = std::get_if<Description::Table>(&root.data);
        if (fields == nullptr) {
            mistakes_.add(root.where, "scene",
                          "expected fields with names, got " +
                              in_words(Description{{}, {}, root.data}));
        } else {
            for (const auto& [name, item] : *fields)
                field(name, {*item.value, {root.where.file, item.line}, "scene." + name});
            if (!fields->contains("objects"))
                mistakes_.add(root.where, "scene.objects",
                              "is missing; expected a list of generator.* and object");
            if (!fields->contains("film")) {
                const Description empty{root.where, {}, Description::Table{}};
                film({empty, root.where, "scene.film"});
            }
        }
        mistakes_.throw_if_any();
        scene_.materials = maker_.materials();
    }

  private:
    void field(const std::string& name, const Given& given) {
        if (name == "film")
            film(given);
        else if (name == "camera")
            camera(given);
        else if (name == "lights")
            for_each(given, "a list of light.*", [&](const Given& item) { light(item); });
        else if (name == "objects")
            objects(given);
        else
            mistakes_.add(given.where, given.path, "unknown field", hint_for(name));
    }

    static std::string hint_for(const std::string& name) {
        const std::vector<std::string> known{"film", "camera", "lights", "objects"};
        const std::string hint = did_you_mean(name, known);
        return hint.empty() ? fmt::format("there are: {}", fmt::join(known, ", ")) : hint;
    }

    void wrong(const Given& given, const std::string& expected) {
        mistakes_.add(given.where, given.path,
                      fmt::format("expected {}, got {}", expected, in_words(given.value)));
    }

    template <class Visit>
    void for_each(const Given& given, const std::string& expected, const Visit& visit) {
        const Description::List* items = maker_.list(given, expected);
        for (std::size_t i = 0; items != nullptr && i < items->size(); ++i)
            visit(Given{*(*items)[i].value,
                        {given.value.where.file, (*items)[i].line},
                        fmt::format("{}[{}]", given.path, i + 1)});
    }

    void film(const Given& given) {
        if (!given.value.kind.empty())
            return wrong(given, "a table with named fields");
        const Plugin<MakeFilm>& plugin = tables().film.plugins().front();
        const std::size_t before = mistakes_.count();
        const Params params = maker_.params(given.value, given.path, plugin.params);
        if (mistakes_.count() != before)
            return;
        try {
            scene_.film = plugin.make(params);
        } catch (const Error& error) {
            mistakes_.add(error, given.where, given.path);
        }
    }

    void camera(const Given& given) {
        if (family_of(given.value) != "camera")
            return wrong(given, "a camera.*");
        scene_.camera = maker_.make<Camera>(tables().camera, given);
    }

    void light(const Given& given) {
        if (family_of(given.value) != "light")
            return wrong(given, "a light.*");
        if (auto made = maker_.make<Light>(tables().light, given))
            scene_.lights.push_back(std::move(*made));
    }

    void objects(const Given& given) {
        const std::string expected = "a list of generator.* and object";
        for_each(given, expected, [&](const Given& item) {
            if (family_of(item.value) == "generator")
                generator(item);
            else if (item.value.kind == "object")
                object(item);
            else
                wrong(item, "a generator.* or object");
        });
        if (is_empty(given.value))
            mistakes_.add(given.where, given.path, "is empty; expected " + expected);
    }

    static bool is_empty(const Description& value) {
        const auto* list = std::get_if<Description::List>(&value.data);
        const auto* table = std::get_if<Description::Table>(&value.data);
        return value.kind.empty() &&
               ((list != nullptr && list->empty()) || (table != nullptr && table->empty()));
    }

    void generator(const Given& given) {
        const Plugin<Bake>* plugin = maker_.plugin(tables().generator, given);
        if (plugin == nullptr)
            return;
        Params params = maker_.params(given.value, given.value.kind, plugin->params);
        const std::string kind = given.value.kind;
        scene_.items.push_back(
            {plugin->name,
             [bake = plugin->make, params = std::move(params), kind](const Context& context) {
                 try {
                     return bake(params, context);
                 } catch (const Error& error) {
                     if (error.fault() != Fault::input)
                         throw;
                     Mistakes mistakes;
                     mistakes.add(error, params.where(), kind);
                     mistakes.throw_if_any();
                     throw;
                 }
             },
             given.value.where});
    }

    // One number scales all three axes.
    static Description with_scale_vector(const Description& object) {
        Description out = object;
        auto* fields = std::get_if<Description::Table>(&out.data);
        if (fields == nullptr)
            return out;
        const auto scale = fields->find("scale");
        if (scale == fields->end())
            return out;
        const DescriptionNode value = scale->second.value;
        const bool number =
            value->kind.empty() && (std::holds_alternative<double>(value->data) ||
                                    std::holds_alternative<std::int64_t>(value->data));
        if (number) {
            const Description::Item part{value, scale->second.line};
            scale->second.value = std::make_shared<const Description>(
                Description{value->where, {}, Description::List{part, part, part}});
        }
        return out;
    }

    void object(const Given& given) {
        const std::size_t before = mistakes_.count();
        const Params params =
            maker_.params(with_scale_vector(given.value), "object", object_params());
        if (mistakes_.count() != before)
            return;
        scene_.items.push_back({"object",
                                [params, index = std::uint64_t{scene_.items.size()}](
                                    const Context&) { return bake_object(params, index); },
                                given.value.where});
    }

    Scene& scene_;
    Mistakes mistakes_;
    Maker maker_;
};

} // namespace

Scene resolve(const DescriptionNode& root, const std::string& path) {
    Scene scene;
    scene.name = file_name(path);
    scene.settings = to_json(*root, {.locations = false, .indent = false});
    scene.hash = hash_bytes(scene.settings);
    SceneMaker(scene).make(*root);
    return scene;
}

} // namespace scree
