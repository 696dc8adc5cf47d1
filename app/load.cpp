// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/load.h"

#include "core/device.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace scree {

void SceneOptions::add_to(CLI::App& command) {
    command.add_option("SCENE", path, "Scene script (.lua) or description (.json)")->required();
    command.add_option("--set", sets, "Give an arg(...) of the script a value, as in --set seed=9")
        ->type_name("K=V")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_option("--threads", threads, "Threads to use; 0: all")->check(CLI::Range(0, 1024));
    command.add_option("--device", device,
                       "OpenCL device: part of its name, cpu, gpu, or none to do without");
    command.add_flag("--quiet", quiet, "Print errors only");
}

std::map<std::string, std::string> SceneOptions::overrides() const {
    std::map<std::string, std::string> out;
    for (const std::string& set : sets) {
        const std::size_t sign = set.find('=');
        if (sign == std::string::npos || sign == 0)
            throw Error::usage(fmt::format("--set {}: expected name=value", set),
                               "for example --set seed=9");
        out[set.substr(0, sign)] = set.substr(sign + 1);
    }
    return out;
}

Scene load_scene(const SceneOptions& options, Stages& stages) {
    stages.begin("parse");
    const DescriptionNode description = read_description(options.path, options.overrides());
    Scene scene = resolve(description, options.path);
    stages.end();
    return scene;
}

std::vector<Aggregate> bake_scene(const Scene& scene, const SceneOptions& options, Stages& stages,
                                  Console& console, const Cancel& cancel) {
    stages.begin("generate");
    std::optional<Device> device;
    if (options.device != "none")
        device.emplace(options.device);
    Context context;
    context.device = device ? &*device : nullptr;
    context.cancel = &cancel;
    std::vector<Aggregate> aggregates;
    for (const SceneItem& item : scene.items) {
        context.progress = [&](std::string_view what, double fraction) {
            console.progress(item.kind, fraction, " " + std::string(what));
        };
        aggregates.push_back(item.bake(context));
        if (item.kind != "object")
            console.say(describe(aggregates.back()));
    }
    stages.end();
    return aggregates;
}

std::string describe(const Aggregate& aggregate) {
    std::string out =
        fmt::format("{}: {} elements", aggregate.generator, aggregate.instances.size());
    for (const auto& [name, value] : aggregate.facts) {
        if (name == "fill")
            out += fmt::format(", fill {:.3f}", value);
        if (name == "seconds")
            out += fmt::format(", {:.2f} s", value);
    }
    return out;
}

} // namespace scree
