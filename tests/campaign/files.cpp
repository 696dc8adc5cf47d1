// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"
#include "tests/campaign/child.h"
#include "tests/campaign/parts.h"
#include "tests/fuzz/mesh_seeds.h"
#include "tests/support/damaged.h"
#include "tests/support/folder.h"

#include <algorithm>
#include <map>

namespace scree::campaign {

namespace {

constexpr double allowed_cpu_s = 2;
constexpr double allowed_mib = 512;

struct Seed {
    std::string name; // file name
    std::string bytes;
};

/// How files of one ending are given to the program: by a scene, or alone when it is empty.
struct Use {
    std::string scene; // FILE stands for the name
    std::vector<std::string> words;
};

std::string scene_with(const std::string& object) {
    return "return scene { film = { width = 8, height = 8, samples = 1 },\n"
           "camera = camera.perspective {}, lights = { light.sky {} }, objects = { " +
           object + " } }";
}

const std::map<std::string, Use>& uses() {
    static const std::map<std::string, Use> table = [] {
        std::map<std::string, Use> out;
        for (const char* mesh : {"obj", "ply", "stl", "gltf", "glb", "3ds"})
            out[mesh] = {scene_with("object { shape = mesh.file { path = 'FILE' }, "
                                    "material = 'file' }"),
                         {"bake", "s.lua", "-o", "a.json"}};
        for (const char* picture : {"png", "jpg", "exr"})
            out[picture] = {scene_with("object { shape = mesh.plane {}, material = material.matte {"
                                       " color = procedural.image { path = 'FILE' } } }"),
                            {"render", "s.lua", "--device", "none", "-o", "a.exr"}};
        out["hdr"] = {
            "return scene { film = { width = 8, height = 8, samples = 1 },\n"
            "camera = camera.perspective {}, objects = { object { shape = mesh.sphere {} } "
            "}, lights = { light.environment { path = 'FILE' } } }",
            {"render", "s.lua", "--device", "none", "-o", "a.exr"}};
        out["svg"] = {scene_with("generator.layout { domain = region.svg { path = 'FILE' }, "
                                 "cancellations = 50, components = { { shape = mesh.star {} } } }"),
                      {"bake", "s.lua", "-o", "a.json"}};
        out["lua"] = {"", {"check", "FILE"}};
        out["json"] = {"", {"check", "FILE"}};
        return out;
    }();
    return table;
}

std::vector<Seed> seeds_in(const std::string& folder) {
    std::vector<Seed> out;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.file_size() < 300'000 &&
            uses().contains(extension(entry.path().string())))
            out.push_back({entry.path().filename().string(), read_file(entry.path().string())});
    for (const MeshSeed& seed : mesh_seeds()) {
        const std::string ending = seed.name.substr(0, seed.name.find('_'));
        if (uses().contains(ending))
            out.push_back({seed.name + "." + ending, seed.bytes});
    }
    std::ranges::sort(out, {}, [](const Seed& seed) { return seed.name + seed.bytes; });
    return out;
}

// Numbers and words that readers have stumbled over.
const std::vector<std::string>& pieces() {
    using namespace std::string_literals;
    static const std::vector<std::string> all{"-1",
                                              "0",
                                              "4294967295",
                                              "1e38",
                                              "nan",
                                              "inf",
                                              "1e-320",
                                              "99999999999999999999",
                                              "\xff\xff\xff\xff"s,
                                              "\x7f\xff\xff\xff"s,
                                              "\0\0\0\0"s,
                                              "\0\0\0\x80"s,
                                              "\n",
                                              "\r",
                                              " ",
                                              "\t",
                                              "\"",
                                              "{",
                                              "}",
                                              "[",
                                              "]",
                                              "<",
                                              "/>",
                                              "<svg>",
                                              "<g>",
                                              "&#1;",
                                              "%00",
                                              "f 1 2 3\n",
                                              "v 0 0 0\n",
                                              "element face 1000000000\n",
                                              "facet normal",
                                              "\"count\":1000000000",
                                              "while true do end ",
                                              "string.rep('x', 1e9)",
                                              "\x1b[31m",
                                              "../",
                                              "data:,"};
    return all;
}

} // namespace

long damage_files(const std::string& folder, long count) {
    Findings findings;
    Random random(1, Purpose::test);
    const std::vector<Seed> seeds = seeds_in(folder);
    std::map<std::string, std::vector<const Seed*>> by_ending; // each format gets as many
    for (const Seed& seed : seeds)
        by_ending[extension(seed.name)].push_back(&seed);
    std::map<int, long> codes;
    double most_cpu = 0;
    double most_mib = 0;
    const long each = count / long(by_ending.size()) + 1;
    long tried = 0;
    for (const auto& [ending, known] : by_ending)
        for (long i = 0; i < each; ++i, ++tried) {
            const Seed& seed = *known[random.below(static_cast<std::uint32_t>(known.size()))];
            const test::Folder place;
            const std::string name = "file." + ending;
            place.write(name, damaged(seed.bytes, pieces(), random));
            const Use& use = uses().at(ending);
            const auto with_name = [&](std::string text) {
                if (const std::size_t at = text.find("FILE"); at != std::string::npos)
                    text.replace(at, 4, name);
                return text;
            };
            Call call{{SCREE_PROGRAM}, place.path().string()};
            for (const std::string& word : use.words)
                call.words.push_back(with_name(word));
            if (!use.scene.empty())
                place.write("s.lua", with_name(use.scene));
            const Ended ended = run(call, 30);
            const std::string said = read_file(place.file("err.txt"));
            const std::string what = seed.name + ", damaged (" + std::to_string(tried) + "): ";
            ++codes[ended.code];
            most_cpu = std::max(most_cpu, ended.cpu_s);
            most_mib = std::max(most_mib, ended.peak_mib);
            std::string problem;
            if (ended.timed_out)
                problem = "does not end";
            else if (ended.signal != 0)
                problem = "signal " + std::to_string(ended.signal);
            else if (ended.code > 3)
                problem = "exit code " + std::to_string(ended.code) + ": " + said;
            else if (ended.code == 1 && said.find(name) == std::string::npos)
                problem = "no file in the message: " + said;
            else if (ended.cpu_s > allowed_cpu_s)
                problem = "took " + std::to_string(ended.cpu_s) + " s";
            else if (ended.peak_mib > allowed_mib)
                problem = "took " + std::to_string(ended.peak_mib) + " MiB";
            if (problem.empty())
                continue;
            findings.add(what + problem);
            write_file("found-" + std::to_string(findings.count()) + "." + ending,
                       read_file(place.file(name)));
        }
    for (const auto& [code, times] : codes)
        std::printf("exit code %d: %ld\n", code, times);
    std::printf("%ld files of %zu formats; at most %.2f s of processor time and %.0f MiB\n", tried,
                by_ending.size(), most_cpu, most_mib);
    return findings.count();
}

} // namespace scree::campaign
