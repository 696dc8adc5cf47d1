// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/script.h"

#include "core/file.h"
#include "core/utf8.h"
#include "scenes/reader/json.h"
#include "scenes/reader/sandbox.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace scree {

namespace {

// Limits of the operating system, larger than those that the sandbox enforces itself.
ChildLimits backstop(const ScriptLimits& limits) {
    return {.cpu_seconds = 2 * limits.seconds + 5,
            .wall_seconds = 10 * limits.seconds + 20,
            .memory = 4 * limits.memory + (std::size_t{256} << 20)};
}

std::string time_message(const ScriptLimits& limits) {
    return fmt::format("the script ran for more than {} s; is there a loop that never ends?",
                       limits.seconds);
}

// The messages of the child.
class Answer {
  public:
    Answer(const std::string& path, const ScriptOptions& options)
        : path_(path), options_(options) {}

    void receive(char type, std::string bytes) {
        if (type == ScriptMessage::file)
            files_.push_back(std::move(bytes));
        else if (type == ScriptMessage::print)
            print(bytes);
        else
            last_.emplace(type, std::move(bytes));
    }

    DescriptionNode result(ChildEnd end) {
        if (end == ChildEnd::time)
            fail({path_, 0}, time_message(options_.limits));
        if (end == ChildEnd::crashed || !last_)
            fail({path_, 0}, "the script's process crashed");
        const auto& [type, bytes] = *last_;
        if (type == ScriptMessage::time)
            fail(location(bytes), time_message(options_.limits));
        if (type == ScriptMessage::memory)
            fail(location(bytes), fmt::format("the script used more than {} MiB of memory",
                                              options_.limits.memory >> 20));
        if (type == ScriptMessage::mistakes)
            throw Error(Fault::input, mistakes(bytes));
        return description_from_json(bytes, path_);
    }

  private:
    [[noreturn]] static void fail(Location where, std::string message) {
        throw Error(Diagnostic{std::move(where), {}, std::move(message), {}});
    }

    void print(const std::string& text) const {
        if (options_.print)
            return options_.print(text);
        const std::string shown = visible(text);
        std::fwrite(shown.data(), 1, shown.size(), stderr);
    }

    Location location(const std::string& bytes) const {
        Place place;
        std::memcpy(&place, bytes.data(), std::min(bytes.size(), sizeof place));
        if (place.file < 0 || static_cast<std::size_t>(place.file) >= files_.size())
            return {path_, 0};
        return {files_[static_cast<std::size_t>(place.file)], place.line};
    }

    static std::vector<Diagnostic> mistakes(const std::string& json) {
        std::vector<Diagnostic> out;
        for (const nlohmann::json& d : nlohmann::json::parse(json))
            out.push_back({{d[0], d[1]}, d[2], d[3], d[4]});
        return out;
    }

    std::string path_;
    const ScriptOptions& options_;
    std::vector<std::string> files_;
    std::optional<std::pair<char, std::string>> last_;
};

} // namespace

DescriptionNode run_script(const std::string& path, const ScriptOptions& options) {
    Answer answer(path, options);
    const ChildEnd end = run_in_child(
        backstop(options.limits),
        [&](const Channel& channel) { Sandbox(channel, options).run(path); },
        [&](char type, std::string bytes) { answer.receive(type, std::move(bytes)); });
    return answer.result(end);
}

DescriptionNode read_description(const std::string& path,
                                 const std::map<std::string, std::string>& overrides,
                                 const std::vector<std::string>& families,
                                 const std::vector<std::string>& readable_folders) {
    const std::string ending = extension(path);
    if (!ending.empty() && ending != "lua" && ending != "json")
        throw Error(path + ": is not a scene; expected .lua or .json");
    if (ending != "json")
        return run_script(
            path,
            {.families = families, .overrides = overrides, .readable_folders = readable_folders});
    if (!overrides.empty())
        throw Error(Diagnostic{{path, 0},
                               "--set " + overrides.begin()->first,
                               "a .json scene has no arg(...) to set; set it in the script",
                               {}});
    return description_from_json(read_file(path), path);
}

} // namespace scree
