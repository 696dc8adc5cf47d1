// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/cycles.h"

#include "core/error.h"
#include "core/file.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

namespace scree::bench {

bool has_blender() { return std::system("command -v blender >/dev/null 2>&1") == 0; }

CyclesRun run_cycles(const std::string& folder, int samples, int seed) {
    const std::string picture = folder + "/cycles.exr";
    const std::string messages = folder + "/cycles.txt";
    std::filesystem::remove(picture); // an old one must not stand for one that fails
    const std::string command = fmt::format(
        "blender -b --factory-startup -noaudio -t 2 --python-exit-code 1 --python '{}' -- '{}' {} "
        "{} '{}' >'{}' 2>&1",
        SCREE_SOURCE_DIR "/bench/peers/cycles.py", folder, samples, seed, picture, messages);
    const bool done = std::system(command.c_str()) == 0;
    const std::string said = read_file(messages);
    const std::string label = "CPU_SECONDS ";
    const std::size_t found = said.rfind(label);
    if (!done || found == std::string::npos || !std::filesystem::exists(picture))
        throw Error::resource("blender failed; its messages are in " + messages);
    return {read_image(picture), std::strtod(said.c_str() + found + label.size(), nullptr)};
}

} // namespace scree::bench
