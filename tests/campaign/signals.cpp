// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"
#include "tests/campaign/child.h"
#include "tests/campaign/parts.h"
#include "tests/support/folder.h"

#include <algorithm>

namespace scree::campaign {

namespace {

constexpr double allowed_s = 0.5;

struct Job {
    const char* what;
    std::vector<std::string> arguments;
    std::string output;
};

// Every stage of each takes long enough to be met.
constexpr const char* scene = R"(
local stage = arg("stage", "render")
if stage == "script" then while true do end end
local heap = generator.pile { target = mesh.sphere { radius = 0.05 }, cover = 0.999, settle = 100,
  components = { { shape = mesh.banana { length = 0.004 } } } }
local leather = generator.leather { size = 0.2, width = 0.2, depth = 0.2 }
local toys = generator.layout { method = "saturated", domain = region.rectangle { width = 4, depth = 4 },
  components = { { shape = mesh.star { radius = 0.004 } } } }
local ball = object { shape = mesh.sphere { radius = 0.05 },
  material = material.matte { color = procedural.marble {} } }
local what = { pile = heap, leather = leather, layout = toys, render = ball, texture = ball }
return scene { film = { width = 2000, height = 2000, samples = 100000 },
  camera = camera.perspective { from = {0, 0.2, 0.3}, at = {0, 0, 0} }, lights = { light.sky {} },
  objects = { what[stage] } }
)";

} // namespace

long send_signals() {
    const std::vector<Job> jobs{
        {"check, a script", {"check", "s.lua", "--set", "stage=script"}, ""},
        {"bake, a pile", {"bake", "s.lua", "--set", "stage=pile", "-o", "a.json"}, "a.json"},
        {"bake, a layout", {"bake", "s.lua", "--set", "stage=layout", "-o", "a.svg"}, "a.svg"},
        {"height, leather", {"height", "s.lua", "--set", "stage=leather", "-o", "a.exr"}, "a.exr"},
        {"render", {"render", "s.lua", "-o", "a.exr"}, "a.exr"},
        {"render, a pile", {"render", "s.lua", "--set", "stage=pile", "-o", "a.exr"}, "a.exr"},
        {"texture",
         {"texture", "s.lua", "--set", "stage=texture", "-o", "a.png", "--size", "16384"},
         "a.png"},
        {"analyse", {"analyse", "s.lua", "--set", "stage=layout", "-o", "a.json"}, "a.json"}};
    Findings findings;
    for (const Job& job : jobs)
        for (const int signal : {SIGINT, SIGTERM}) {
            std::vector<double> answers;
            for (const double after : {0.3, 0.6, 1.2, 2.0, 3.0, 4.0}) {
                const test::Folder folder;
                folder.write("s.lua", scene);
                if (!job.output.empty())
                    folder.write(job.output, "old");
                Call call{{SCREE_PROGRAM}, folder.path().string()};
                call.words.insert(call.words.end(), job.arguments.begin(), job.arguments.end());
                Child child(call);
                usleep(static_cast<useconds_t>(after * 1e6));
                const auto sent = Clock::now();
                child.send(signal);
                const Ended ended = child.wait();
                const std::string where =
                    std::string(job.what) + " after " + std::to_string(after) + " s";
                if (ended.code == 0)
                    continue; // it was faster
                answers.push_back(seconds_since(sent));
                if (answers.back() > allowed_s)
                    findings.add(where + ": answered after " + std::to_string(answers.back()) +
                                 " s");
                if (ended.code != 128 + signal)
                    findings.add(where + ": exit code " + std::to_string(ended.code) + ", signal " +
                                 std::to_string(ended.signal));
                if (!job.output.empty() && read_file(folder.file(job.output)) != "old")
                    findings.add(where + ": the old file is gone");
            }
            std::printf("%s, signal %d: %zu answers, the slowest after %.2f s\n", job.what, signal,
                        answers.size(),
                        answers.empty() ? 0.0 : *std::max_element(answers.begin(), answers.end()));
        }
    return findings.count();
}

} // namespace scree::campaign
