// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"
#include "tests/campaign/child.h"
#include "tests/campaign/parts.h"
#include "tests/support/folder.h"

#include <random>

namespace scree::campaign {

namespace {

constexpr const char* scene =
    "return scene { film = { width = 96, height = 64, samples = 16 },\n"
    "camera = camera.perspective { from = {0, 1, 1.4}, at = {0, 0, 0} }, lights = { light.sky {} "
    "},\n"
    "objects = { generator.layout { domain = region.rectangle { width = 1, depth = 1 }, seed = 3,\n"
    "  components = { { shape = mesh.star { radius = 0.03 } } } } } }";

struct Job {
    std::vector<std::string> arguments;
    std::vector<std::string> outputs;
};

const std::vector<Job>& jobs() {
    static const std::vector<Job> all{
        {{"render", "s.lua", "-o", "a.exr", "--aov", "albedo,N"}, {"a.exr", "a.png"}},
        {{"render", "s.lua", "-o", "a.exr", "--denoise"}, {"a.exr", "a.png"}},
        {{"bake", "s.lua", "-o", "a.json"}, {"a.json"}},
        {{"bake", "s.lua", "-o", "a.svg"}, {"a.svg"}},
        {{"bake", "s.lua", "-o", "a.png"}, {"a.png"}},
        {{"bake", "s.lua", "-o", "a.stl"}, {"a.stl"}}};
    return all;
}

Call call_of(const Job& job, const std::string& folder) {
    Call call{{SCREE_PROGRAM}, folder};
    call.words.insert(call.words.end(), job.arguments.begin(), job.arguments.end());
    return call;
}

std::vector<std::string> contents(const Job& job, const test::Folder& folder) {
    std::vector<std::string> out;
    for (const std::string& name : job.outputs)
        out.push_back(read_file(folder.file(name)));
    return out;
}

std::size_t hidden_files(const test::Folder& folder) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        count += entry.path().filename().string().starts_with(".") ? 1 : 0;
    return count;
}

// Baked facts hold how long the work took.
bool has_times(const std::string& name) { return name.ends_with(".json"); }

} // namespace

long kill_runs(long count) {
    Findings findings;
    std::mt19937_64 random(1);
    long killed = 0;
    for (const Job& job : jobs()) {
        const test::Folder folder;
        folder.write("s.lua", scene);
        const auto start = Clock::now();
        if (run(call_of(job, folder.path().string())).code != 0)
            findings.add(job.arguments[0] + " fails by itself");
        const double seconds = seconds_since(start);
        const std::vector<std::string> whole = contents(job, folder);
        for (long i = 0; i < count / long(jobs().size()); ++i) {
            for (const std::string& name : job.outputs)
                folder.write(name, "old " + name);
            Child child(call_of(job, folder.path().string()));
            const double after = seconds * 1.2 * double(random()) / 1.8e19;
            usleep(static_cast<useconds_t>(after * 1e6));
            child.send(SIGKILL);
            killed += child.wait().signal == SIGKILL ? 1 : 0;
            const std::vector<std::string> now = contents(job, folder);
            for (std::size_t k = 0; k < now.size(); ++k)
                if (now[k] != "old " + job.outputs[k] && now[k] != whole[k] &&
                    !has_times(job.outputs[k]))
                    findings.add("a damaged " + job.outputs[k]);
            if (run(call_of(job, folder.path().string())).code != 0)
                findings.add("the next run of " + job.outputs[0] + " fails");
            if (hidden_files(folder) > 0)
                findings.add("the next run of " + job.outputs[0] + " leaves a temporary file");
        }
    }
    std::printf("%ld of %ld runs killed before their end\n", killed, count);
    return findings.count();
}

} // namespace scree::campaign
