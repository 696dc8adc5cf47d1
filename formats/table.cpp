// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/table.h"

#include "core/display_encoding.h"
#include "core/file.h"
#include "formats/element_color.h"
#include "formats/layout_picture.h"
#include "formats/write_3mf.h"
#include "formats/write_bake_json.h"
#include "formats/write_stl.h"

namespace scree {

namespace {

void to_json_file(const Scene& scene, const std::string& path, const ExportOptions& /*options*/) {
    write_file(path, bake_json(scene.aggregates, {scene.name, scene.aggregates.front().seed}));
}

void to_svg(const Scene& scene, const std::string& path, const ExportOptions& /*options*/) {
    write_file(path, layout_svg(scene.aggregates, element_color));
}

void to_png(const Scene& scene, const std::string& path, const ExportOptions& options) {
    write_png(path, display_image(layout_image(scene.aggregates, element_color, options.pixels)));
}

void to_exr(const Scene& scene, const std::string& path, const ExportOptions& options) {
    const ImagePart part{"layout", layout_image(scene.aggregates, element_color, options.pixels)};
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
