// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/export_scene.h"

#include "core/file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scree {

const SceneFormat& scene_format(std::span<const SceneFormat> formats, const std::string& path) {
    const std::string ending = extension(path);
    std::vector<std::string> known;
    for (const SceneFormat& format : formats) {
        if (format.ending == ending)
            return format;
        known.push_back("." + format.ending);
    }
    throw Error::usage(fmt::format("{}: cannot bake to .{}; expected one of {}", path, ending,
                                   fmt::join(known, ", ")));
}

Exported export_scene(Session& session, Scene scene, const SceneFormat& format,
                      const std::string& path, const LayoutLook& look, const SolidOptions& solid) {
    std::erase_if(scene.aggregates, [](const Aggregate& a) { return a.generator == "object"; });
    if (scene.aggregates.empty())
        throw Error(Diagnostic{{session.options().path, 0},
                               "scene.objects",
                               "there is no generator to bake; expected a generator.*",
                               ""});
    Exported out{std::move(scene)};
    ExportOptions options{.look = look, .warn = [&session](const std::string& message) {
                              session.watcher().warn(message);
                          }};
    if (format.holds == Holds::solid) {
        out.solid = make_solid(out.scene.aggregates, solid, session);
        options.solid = &out.solid->mesh;
    }
    session.stages().begin("write");
    format.write(out.scene, path, options);
    session.stages().end();
    session.watcher().say("wrote " + path);
    return out;
}

} // namespace scree
