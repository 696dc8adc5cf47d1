// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace scree {

void SceneOptions::add_to(CLI::App& command) {
    command.add_option("SCENE", path, "Scene script (.lua) or description (.json)")->required();
    command.add_option("--set", sets, "Give an arg(...) of the script a value, as in --set seed=9")
        ->type_name("K=V")
        ->allow_extra_args(false) // or it would take the scene's name too
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        .add_option("--allow-read", readable_folders,
                    "Folder from which the script may include files, beside its own")
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->check(CLI::ExistingDirectory);
    command.add_option("--threads", threads, "Threads to use; 0: all")->check(CLI::Range(0, 1024));
    command.add_option("--device", device,
                       "OpenCL device: part of its name, cpu, gpu, or none to do without");
    command.add_flag("--quiet", quiet, "Print errors only");
}

SessionOptions SceneOptions::session() const {
    SessionOptions out{path, {}, readable_folders, device, threads};
    for (const std::string& set : sets) {
        const std::size_t sign = set.find('=');
        if (sign == std::string::npos || sign == 0)
            throw Error::usage(fmt::format("--set {}: expected name=value", set),
                               "for example --set seed=9");
        out.overrides[set.substr(0, sign)] = set.substr(sign + 1);
    }
    return out;
}

} // namespace scree
