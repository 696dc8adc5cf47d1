// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/checkpoint.h"

#include "core/error.h"
#include "core/file.h"
#include "core/version.h"
#include "render/tiles.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace scree {

namespace {

constexpr std::string_view title_line = "scree checkpoint 2";
constexpr const char* anew = "to begin anew, delete it or render without --resume";

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

} // namespace

Checkpoint::Checkpoint(std::string path, const Scene& scene, const RenderOptions& options)
    : path_(std::move(path)) {
    const FilmSettings& film = scene.film;
    const Crop crop = options.crop.value_or(Crop{0, 0, film.width, film.height});
    picture_ = fmt::format("program {}\nscene {} ({:016x})\nsize {}x{}\ncrop {},{},{},{}\n"
                           "shard {}\nseed {}\nmattes {}\n",
                           SCREE_VERSION, scene.name, scene.hash, film.width, film.height, crop.x,
                           crop.y, crop.width, crop.height, shard_text(options.shard), options.seed,
                           options.mattes ? "yes" : "no");
}

bool Checkpoint::exists() const { return std::filesystem::exists(path_); }

void Checkpoint::write(const Rendering& rendering) const {
    write_stream(path_, [&](std::ostream& out) {
        out << title_line << '\n' << picture_;
        rendering.save(out);
    });
}

void Checkpoint::read(Rendering& rendering) const {
    const auto refuse = [&](const std::string& message) {
        return Error(Diagnostic{{}, {}, path_ + ": " + message, anew});
    };
    check_is_file(path_);
    std::ifstream in(path_, std::ios::binary);
    std::string line;
    if (!std::getline(in, line) || line != title_line)
        throw refuse("is not a checkpoint of this version of Scree");
    for (const std::string& expected : lines_of(picture_))
        if (!std::getline(in, line) || line != expected)
            throw refuse(fmt::format("is of another picture: {} instead of {}", line, expected));
    try {
        rendering.restore(in);
    } catch (const Error& error) {
        throw refuse(error.diagnostics().front().message);
    }
}

} // namespace scree
