// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/farm.h"

#include "core/file.h"

#include <filesystem>
#include <fmt/format.h>
#include <set>

namespace scree {

namespace {

std::string words(const std::vector<std::string>& list) {
    std::string out;
    for (const std::string& word : list)
        out += " " + shell_word(word);
    return out;
}

std::string without_ending(const std::string& path) { return path.substr(0, path.rfind('.')); }

} // namespace

std::string shell_word(const std::string& text) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                       "0123456789_-./=:,+%@";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos)
        return text;
    std::string out = "'";
    for (const char c : text)
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

FarmPlan::FarmPlan(FarmJob job)
    : job_(std::move(job)), folder_(without_ending(job_.output) + ".farm") {
    std::vector<std::optional<std::int64_t>> seeds{std::nullopt};
    if (job_.seeds) {
        seeds.clear();
        for (std::int64_t seed = job_.seeds->first; seed <= job_.seeds->second; ++seed)
            seeds.emplace_back(seed);
    }
    for (const auto& seed : seeds)
        for (int shard = 1; shard <= job_.shards; ++shard)
            tasks_.push_back({seed, shard});
}

std::string FarmPlan::picture(const std::optional<std::int64_t>& seed) const {
    return seed ? fmt::format("{}-{}.exr", without_ending(job_.output), *seed) : job_.output;
}

std::vector<std::string> FarmPlan::pictures() const {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < tasks_.size(); i += static_cast<std::size_t>(job_.shards))
        out.push_back(picture(tasks_[i].seed));
    return out;
}

std::string FarmPlan::shard(const FarmTask& task) const {
    const std::string seed = task.seed ? fmt::format("seed{}-", *task.seed) : "";
    return fmt::format("{}/{}shard{}.exr", folder_, seed, task.shard);
}

std::string FarmPlan::log(const FarmTask& task) const {
    return without_ending(shard(task)) + ".err";
}

std::vector<std::size_t> FarmPlan::missing() const {
    std::set<std::string> there;
    std::error_code code;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, code))
        there.insert(entry.path().filename().string());
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < tasks_.size(); ++i)
        if (!there.contains(file_name(shard(tasks_[i]))))
            out.push_back(i);
    return out;
}

std::string FarmPlan::identity() const {
    return fmt::format("scene {} {}\nshards {}\nset{}\nrender{}\n", job_.scene, job_.scene_hash,
                       job_.shards, words(job_.sets), words(job_.render_options));
}

std::string FarmPlan::header(const std::string& name) const {
    std::string out = fmt::format("#!/bin/sh\n#SBATCH --job-name={}\n", shell_word(name));
    for (const std::string& option : job_.batch_options)
        out += "#SBATCH " + option + "\n";
    return out;
}

// What is killed or requeued goes on from its checkpoint. `exec` lets the program itself get
// Slurm's signals.
std::string FarmPlan::array_script(const std::string& list, std::size_t count) const {
    const std::string threads =
        job_.threads > 0 ? fmt::format("#SBATCH --cpus-per-task={}\n", job_.threads) : "";
    std::string sets;
    for (const std::string& set : job_.sets)
        sets += " --set " + shell_word(set);
    const bool has_seeds = job_.seeds.has_value();
    return header("scree-" + file_name(without_ending(job_.output))) + threads +
           fmt::format("#SBATCH --array=1-{}\n#SBATCH --requeue\n#SBATCH --open-mode=append\n"
                       "#SBATCH --output=/dev/null\n\n",
                       count) +
           fmt::format("set -eu\ntask=$(sed -n \"${{SLURM_ARRAY_TASK_ID}}p\" {})\n"
                       ": \"${{task:?}}\"\nshard=$((task % {} + 1))\n",
                       shell_word(list), job_.shards) +
           (has_seeds ? fmt::format("seed=$((task / {} + {}))\nname=seed$seed-shard$shard\n",
                                    job_.shards, job_.seeds->first)
                      : std::string("name=shard$shard\n")) +
           fmt::format("cd {}\n", shell_word(folder_)) +
           fmt::format("exec {} render {}{}{} --quiet --resume{} --shard \"$shard/{}\" "
                       "-o \"$name.exr\"{} 2>>\"$name.err\"\n",
                       shell_word(job_.program), shell_word(job_.scene), sets,
                       has_seeds ? " --set \"seed=$seed\"" : "",
                       job_.threads > 0 ? fmt::format(" --threads {}", job_.threads) : "",
                       job_.shards, words(job_.render_options));
}

std::string FarmPlan::merge_script() const {
    std::string out = header("scree-merge") + "#SBATCH --output=/dev/null\n\nset -e\n" +
                      fmt::format("cd {}\nexec 2>merge.err\n", shell_word(folder_));
    for (std::size_t i = 0; i < tasks_.size(); i += static_cast<std::size_t>(job_.shards)) {
        const std::string first = without_ending(file_name(shard(tasks_[i])));
        const std::string stem = first.substr(0, first.size() - 1); // without the number
        out += fmt::format("{} merge {}*.exr -o {}\n", shell_word(job_.program), stem,
                           shell_word(picture(tasks_[i].seed)));
    }
    out += "touch merged\nrm -f *shard*.png *shard*.checkpoint merge.err\n";
    return out;
}

} // namespace scree
