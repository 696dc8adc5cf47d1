// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/table.h"

#include "core/display_encoding.h"
#include "core/file.h"
#include "formats/element_color.h"
#include "formats/write_3mf.h"
#include "formats/write_bake_json.h"
#include "formats/write_stl.h"

namespace scree {

namespace {

void to_json_file(const Scene& scene, const std::string& path, const ExportOptions& /*options*/) {
    write_file(path, bake_json(scene.aggregates, {scene.name, scene.aggregates.front().seed}));
}

/// What `draw` makes of the aggregates; errors, such as that nothing can be seen, name the file.
template <class Draw>
auto drawn(const Scene& scene, const std::string& path, const ExportOptions& options,
           const Draw& draw) {
    warn_of_plain_colors(scene.aggregates, options.warn);
    try {
        return draw(scene.aggregates);
    } catch (const Error& error) {
        if (error.fault() != Fault::input)
            throw;
        throw error.located({path, 0}, "");
    }
}

void to_svg(const Scene& scene, const std::string& path, const ExportOptions& options) {
    write_file(path, drawn(scene, path, options, [&](const auto& aggregates) {
                   return layout_svg(aggregates, element_color, options.look);
               }));
}

Image picture_of(const Scene& scene, const std::string& path, const ExportOptions& options) {
    return drawn(scene, path, options, [&](const auto& aggregates) {
        return layout_image(aggregates, element_color, options.look);
    });
}

void to_png(const Scene& scene, const std::string& path, const ExportOptions& options) {
    write_png(path, display_image(picture_of(scene, path, options)));
}

void to_exr(const Scene& scene, const std::string& path, const ExportOptions& options) {
    const ImagePart part{"layout", picture_of(scene, path, options)};
    const Box2 box = picture_box(scene.aggregates);
    write_exr(
        path, {&part, 1}, provenance(scene),
        {{"worldSize", {static_cast<float>(box.size().x), static_cast<float>(box.size().y)}}});
}

void to_stl(const Scene& /*scene*/, const std::string& path, const ExportOptions& options) {
    write_stl(path, *options.solid);
}

void to_3mf(const Scene& scene, const std::string& path, const ExportOptions& options) {
    write_3mf(path, *options.solid, scene.name);
}

} // namespace

std::vector<SceneFormat> scene_formats() {
    return {{"json", Holds::generated, to_json_file},
            {"svg", Holds::generated, to_svg},
            {"png", Holds::generated, to_png},
            {"exr", Holds::generated, to_exr},
            {"stl", Holds::solid, to_stl},
            {"3mf", Holds::solid, to_3mf}};
}

} // namespace scree
