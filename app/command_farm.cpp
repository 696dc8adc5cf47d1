// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/file_option.h"
#include "app/picture_output.h"
#include "app/scene_options.h"
#include "app/standard_streams.h"
#include "core/text.h"
#include "session/slurm.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <memory>

namespace scree {

namespace {

struct FarmOptions {
    SceneOptions scene;
    std::string output;
    std::string seeds;
    std::vector<std::string> batch_options;
    std::vector<std::string> render_options;
    int shards = 0;
    int tries = 3;
    bool no_wait = false;
    bool dry_run = false;
};

constexpr std::int64_t most_tasks = 1'000'000;

// "3..12"
std::pair<std::int64_t, std::int64_t> parse_seeds(const std::string& text, int shards) {
    std::int64_t first = 0;
    std::int64_t last = 0;
    const char* end = text.data() + text.size();
    const auto [dots, code] = std::from_chars(text.data(), end, first);
    const bool has_dots = code == std::errc() && end - dots > 2 && dots[0] == '.' && dots[1] == '.';
    const auto [rest, second] = std::from_chars(has_dots ? dots + 2 : end, end, last);
    if (!has_dots || second != std::errc() || rest != end || first < 0 || last < first)
        throw Error::usage("--seeds " + text + ": expected FIRST..LAST",
                           "for example --seeds 1..20");
    if (last - first >= most_tasks / shards)
        throw Error::usage(fmt::format("--seeds {}: with {} shards each are more than {} tasks",
                                       text, shards, most_tasks));
    return {first, last};
}

// What every task would refuse is refused here.
void check_render_options(const FarmOptions& options) {
    constexpr std::array reserved{"-o",        "--output",  "--shard",   "--resume", "--time",
                                  "--preview", "--partial", "--denoise", "--stats"};
    for (const std::string& word : options.render_options)
        for (const std::string_view name : reserved)
            if (word == name || word.starts_with(std::string(name) + "="))
                throw Error::usage(fmt::format("{} is not for the shards of a farm", word));
    CLI::App app;
    Run ignored;
    add_render_command(app, ignored);
    std::vector<std::string> words = options.render_options;
    words.insert(words.begin(), {"render", options.scene.path});
    std::ranges::reverse(words); // as CLI11 takes them
    try {
        app.parse(words);
    } catch (const CLI::ParseError& problem) {
        throw Error::usage(std::string("after --: ") + problem.what(), "see scree render --help");
    }
}

std::string own_path() {
    std::error_code code;
    const auto path = std::filesystem::read_symlink("/proc/self/exe", code);
    return code ? "scree" : path.string();
}

FarmJob job_of(const FarmOptions& options, std::uint64_t scene_hash) {
    FarmJob job;
    job.program = own_path();
    job.scene = std::filesystem::absolute(options.scene.path).string();
    job.scene_hash = fmt::format("{:016x}", scene_hash);
    job.output = std::filesystem::absolute(options.output).string();
    job.shards = options.shards;
    if (!options.seeds.empty())
        job.seeds = parse_seeds(options.seeds, options.shards);
    job.sets = options.scene.sets;
    job.render_options = options.render_options;
    if (!options.scene.device.empty())
        job.render_options.insert(job.render_options.end(), {"--device", options.scene.device});
    for (const std::string& folder : options.scene.readable_folders)
        job.render_options.insert(job.render_options.end(),
                                  {"--allow-read", std::filesystem::absolute(folder).string()});
    job.batch_options = options.batch_options;
    job.threads = options.scene.threads;
    return job;
}

int farm(FarmOptions options) {
    if (options.output.empty())
        options.output = default_picture(options.scene.path);
    check_picture_output(options.output);
    check_render_options(options);
    SceneOptions here = options.scene;
    here.device.clear(); // the machines that render have it, this one need not
    SceneRun run(here);
    const FarmPlan plan(job_of(options, run.session.load().scene.hash));
    if (options.dry_run) {
        const std::string list = plan.folder() + "/array0.txt";
        print_result(fmt::format("# {}, which {} names by their number, from 0, one a line:\n{}\n"
                                 "# When all have ended well:\n{}",
                                 counted(plan.tasks().size(), "task"), list,
                                 plan.array_script(list, plan.tasks().size()),
                                 plan.merge_script()));
        return 0;
    }
    run_on_slurm(plan, options.tries, !options.no_wait, run.console, interruption());
    if (options.no_wait)
        run.console.say("the same command shows how far it is");
    else
        for (const std::string& picture : plan.pictures())
            run.console.say("wrote " + picture + " and " + beside(picture, "png"));
    return 0;
}

} // namespace

void add_farm_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<FarmOptions>();
    CLI::App* command = app.add_subcommand(
        "farm", "Render a picture in shards as array jobs of Slurm, and merge them.");
    options->scene.add_to(*command);
    command->add_option("--shards", options->shards, "How many tasks share a picture")
        ->required()
        ->check(CLI::Range(1, 65536));
    add_file_option(*command, "-o,--output", options->output,
                    "File to write: .exr (default: SCENE.exr here)");
    command
        ->add_option("--seeds", options->seeds,
                     "A picture for each of these values of the script's arg(\"seed\"), -o with "
                     "-SEED before its ending")
        ->type_name("A..B");
    command
        ->add_option("--sbatch", options->batch_options,
                     "An option for sbatch, as in --sbatch=--partition=day")
        ->type_name("OPTION")
        ->allow_extra_args(false);
    command->add_option("--tries", options->tries, "How often a task is submitted at most")
        ->check(CLI::Range(1, 100));
    command->add_flag("--no-wait", options->no_wait, "Submit, and end");
    command->add_flag("--dry-run", options->dry_run,
                      "Print the scripts, for another scheduler, and submit nothing");
    command->add_option("RENDER_OPTION", options->render_options,
                        "Options of scree render, after --");
    command->footer(
        "The program, the scene and the output must be under the same paths on all machines.\n"
        "A task that is killed or requeued goes on from its checkpoint; the same command, given\n"
        "again, watches a farm that runs, and submits what is missing of one that failed.\n"
        "Ctrl-C ends the watching alone.\n"
        "Example:\n  scree farm scenes/toys.lua --shards 64 -o toys.exr -- --spp 1024");
    command->callback([options, &run] { run = [options] { return farm(*options); }; });
}

} // namespace scree
