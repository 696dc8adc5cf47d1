// SPDX-License-Identifier: GPL-3.0-or-later
// A picture, or one for each of many seeds, as array jobs of Slurm and a job that merges the
// shards.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// What a farm is to render. All paths are absolute.
struct FarmJob {
    std::string program;
    std::string scene;
    std::string scene_hash; // shards of another version of the scene are not taken
    std::string output;     // .exr
    int shards = 1;         // of each picture
    std::optional<std::pair<std::int64_t, std::int64_t>>
        seeds{};                               // first and last; values of `seed`
    std::vector<std::string> sets{};           // "name=value"
    std::vector<std::string> render_options{}; // "--spp", "256"
    std::vector<std::string> batch_options{};  // of sbatch
    int threads = 0;                           // of each task; 0: Slurm's default
};

/// One shard of one picture.
struct FarmTask {
    std::optional<std::int64_t> seed;
    int shard = 1;
};

/// The files of a job and the scripts that make them. Everything lies in a folder beside the
/// output, "toys.farm" for "toys.exr".
class FarmPlan {
  public:
    explicit FarmPlan(FarmJob job);

    const FarmJob& job() const { return job_; }
    const std::string& folder() const { return folder_; }
    const std::vector<FarmTask>& tasks() const { return tasks_; }

    std::string picture(const std::optional<std::int64_t>& seed) const; // "toys.exr", "toys-7.exr"
    std::string shard(const FarmTask& task) const;                      // its .exr
    std::string log(const FarmTask& task) const;                        // what it said
    std::string merge_log() const { return folder_ + "/merge.err"; }
    std::string done_mark() const { return folder_ + "/merged"; } // there when all pictures are
    std::vector<std::string> pictures() const;

    /// The numbers of the tasks, from 0, whose shards are not there yet.
    std::vector<std::size_t> missing() const;

    /// Lines of text that say what is rendered: equal for the same pictures.
    std::string identity() const;

    /// The batch script of an array whose n-th task, from 1, is the task in line n of the file of
    /// numbers `list`.
    std::string array_script(const std::string& list, std::size_t count) const;

    /// The batch script that merges the shards of every picture. It leaves them, so that more seeds
    /// can be added.
    std::string merge_script() const;

  private:
    std::string header(const std::string& name) const;

    FarmJob job_;
    std::string folder_;
    std::vector<FarmTask> tasks_;
};

/// `text` as one word of sh.
std::string shell_word(const std::string& text);

} // namespace scree
