// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"
#include "tests/campaign/child.h"
#include "tests/campaign/parts.h"
#include "tests/support/folder.h"

#include <sstream>

namespace scree::campaign {

namespace {

constexpr const char* scene =
    "return scene { film = { width = 24, height = 16, samples = 1 },\n"
    "camera = camera.perspective { from = {0, 1, 1.4}, at = {0, 0, 0} }, lights = { light.sky {} "
    "},\n"
    "objects = { generator.layout { domain = region.rectangle { width = 1, depth = 1 },\n"
    "  method = 'naive', cancellations = 20, components = { { shape = mesh.star {} } } } } }";
constexpr const char* leather =
    "return scene { objects = { generator.leather { size = 0.02, width = 0.02, depth = 0.02,\n"
    "  resolution = 32 } } }";
constexpr const char* stone = "return scene { objects = { object { shape = mesh.box {},\n"
                              "  material = material.matte { color = procedural.marble {} } } } }";

struct Job {
    std::vector<std::string> arguments;
    std::string output;
};

const std::vector<Job>& jobs() {
    static const std::vector<Job> all{
        {{"render", "s.lua", "-o", "a.exr"}, "a.exr"},
        {{"bake", "s.lua", "-o", "a.json"}, "a.json"},
        {{"bake", "s.lua", "-o", "a.svg"}, "a.svg"},
        {{"bake", "s.lua", "-o", "a.png", "--size", "32"}, "a.png"},
        {{"bake", "s.lua", "-o", "a.exr", "--size", "32"}, "a.exr"},
        {{"bake", "s.lua", "-o", "a.stl", "--resolution", "0.05"}, "a.stl"},
        {{"bake", "s.lua", "-o", "a.3mf", "--resolution", "0.05"}, "a.3mf"},
        {{"height", "leather.lua", "-o", "a.exr"}, "a.exr"},
        {{"texture", "stone.lua", "-o", "a.png", "--size", "16"}, "a.png"},
        {{"texture", "stone.lua", "-o", "a.vdb", "--map", "volume", "--size", "8"}, "a.vdb"},
        {{"view", "in.exr", "-o", "a.png"}, "a.png"}};
    return all;
}

// The calls of each kind that a run makes, as the shim counts them.
long calls_made(const std::string& counts, const std::string& kind) {
    std::istringstream lines(counts);
    std::string name;
    long count = 0;
    while (lines >> name >> count)
        if (name == kind)
            return count;
    return 0;
}

} // namespace

long fail_calls(const std::string& shim) {
    Findings findings;
    const std::string preload = "LD_PRELOAD=" + shim;
    for (const Job& job : jobs()) {
        const test::Folder folder;
        folder.write("s.lua", scene);
        folder.write("leather.lua", leather);
        folder.write("stone.lua", stone);
        Call call{{SCREE_PROGRAM}, folder.path().string()};
        run({{SCREE_PROGRAM, "render", "s.lua", "-o", "in.exr"}, folder.path().string()});
        call.words.insert(call.words.end(), job.arguments.begin(), job.arguments.end());
        call.environment = {preload, "FAULT_COUNTS=" + folder.file("counts.txt")};
        if (run(call).code != 0) {
            findings.add(job.arguments[0] + " to " + job.output +
                         " fails by itself: " + read_file(folder.file("err.txt")));
            continue;
        }
        const std::string whole = read_file(folder.file(job.output));
        const std::string counts = read_file(folder.file("counts.txt"));
        std::printf("%s to %s:", job.arguments[0].c_str(), job.output.c_str());
        for (const char* kind : {"open", "write", "fsync", "rename", "close", "malloc"}) {
            const long calls = calls_made(counts, kind);
            long tried = 0;
            // All calls on files; allocations ever farther apart.
            for (long n = 1; n <= calls; n = n < 200 ? n + 1 : n + n / 20) {
                folder.write(job.output, "old");
                call.environment = {preload, std::string("FAULT_KIND=") + kind,
                                    "FAULT_AT=" + std::to_string(n)};
                const Ended ended = run(call);
                const std::string now = read_file(folder.file(job.output));
                const bool kept = now == "old";
                const bool done = ended.code == 0 && !kept; // facts hold times
                if (!(ended.code == 3 && kept) && !done)
                    findings.add(job.arguments[0] + " to " + job.output + ", " + kind + " " +
                                 std::to_string(n) + ": code " + std::to_string(ended.code) +
                                 ", signal " + std::to_string(ended.signal) +
                                 (kept ? ", the old file" : ", not the old file") + ": " +
                                 read_file(folder.file("err.txt")).substr(0, 120));
                ++tried;
            }
            std::printf(" %s %ld of %ld,", kind, tried, calls);
            std::fflush(stdout);
        }
        std::printf("\n");
    }
    return findings.count();
}

} // namespace scree::campaign
