// SPDX-License-Identifier: GPL-3.0-or-later
// scree farm with commands in place of Slurm's, which run every task at once.
#include "tests/cli/cli_fixture.h"

#include <filesystem>
#include <sys/stat.h>

namespace scree {
namespace {

using tests::Outcome;

// Tasks whose numbers are in the file `killed` are not run, once; after a failure no dependent job.
constexpr const char* fake_sbatch = R"sh(#!/bin/sh
for script; do :; done
cd "$(dirname "$0")"
id=$(($(cat count 2>/dev/null || echo 100) + 1))
echo "$*" >>calls
echo $id >count
last=$(sed -n 's/^#SBATCH --array=1-//p' "$script")
case "$*" in
  *afterok*) [ -e failed ] || sh "$script" ;;
  *)
    rm -f failed
    for SLURM_ARRAY_TASK_ID in $(seq "${last:-0}"); do
      export SLURM_ARRAY_TASK_ID
      if grep -qx "$SLURM_ARRAY_TASK_ID" killed 2>/dev/null || ! sh "$script"; then touch failed; fi
    done
    rm -f killed
    ;;
esac
echo "$id;cluster"
)sh";

// Is away for the first question when there is a file `away`.
constexpr const char* fake_squeue = R"sh(#!/bin/sh
cd "$(dirname "$0")"
if rm away 2>/dev/null; then
  echo "slurm_load_jobs error: Unable to contact slurm controller"
  exit 1
fi
if rm held 2>/dev/null; then echo "101 101_2 PENDING launch failed requeued held"; fi
echo "7 7 RUNNING None"
)sh";

class FarmCli : public tests::CliTest {
  protected:
    FarmCli() {
        std::filesystem::create_directory(path("bin"));
        for (const auto& [name, text] :
             {std::pair{"sbatch", fake_sbatch}, std::pair{"squeue", fake_squeue},
              std::pair{"scontrol", "#!/bin/sh\necho \"$*\" >>\"$(dirname \"$0\")/released\"\n"}}) {
            write_file(path(std::string("bin/") + name), text);
            chmod(path(std::string("bin/") + name).c_str(), 0755);
        }
        write_file(path("ball.lua"),
                   "local grey = arg('seed', 1) / 10\n"
                   "return scene { film = { width = 70, height = 40, samples = 4 },\n"
                   "camera = camera.perspective { from = {0, 1, 3}, at = {0, 0, 0} },\n"
                   "lights = { light.sky {} }, objects = { object { shape = mesh.sphere {},\n"
                   "  material = material.matte { color = { grey, grey, grey } } } } }");
    }

    Outcome farm(const std::string& arguments) const {
        return run("farm ball.lua " + arguments, "PATH=\"" + path("bin") + ":$PATH\"");
    }
    void expect_same(const std::string& a, const std::string& b) const {
        EXPECT_TRUE(read_file(path(a)) == read_file(path(b))) << a << " and " << b;
    }
};

TEST_F(FarmCli, ThePictureIsThatOfOneMachine) {
    EXPECT_EQ(run("render ball.lua --quiet --spp 6 --aov N -o whole.exr").code, 0);
    const Outcome outcome = farm("--shards 5 -o a.exr -- --spp 6 --aov N");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("5 of 5 tasks submitted"), std::string::npos) << outcome.err;
    expect_same("a.exr", "whole.exr");
    expect_same("a.png", "whole.png");
    // Given again, it has nothing to do; of another picture it does not take the shards.
    EXPECT_EQ(farm("--shards 5 -o a.exr -- --spp 6 --aov N").code, 0);
    const Outcome other = farm("--shards 5 -o a.exr -- --spp 7 --aov N");
    EXPECT_EQ(other.code, 1);
    EXPECT_EQ(other.err, path("a.farm") +
                             ": holds another job, or the scene has changed\n"
                             "  give another -o, or remove the folder to begin anew\n");
}

TEST_F(FarmCli, WhatIsKilledIsSubmittedAgainAndAQueueThatIsAwayIsWaitedFor) {
    EXPECT_EQ(run("render ball.lua --quiet -o whole.exr").code, 0);
    write_file(path("bin/killed"), "2\n4\n");
    write_file(path("bin/away"), "");
    write_file(path("bin/held"), "");
    const Outcome outcome = farm("--shards 5 -o a.exr --sbatch=--partition=day");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("warning: the queue does not answer, and is asked again: "
                               "slurm_load_jobs error: Unable to contact slurm controller"),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("2 of 5 tasks submitted"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("101_2 could not be started, and is tried again"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(read_file(path("bin/released")), "release 101_2\n");
    expect_same("a.exr", "whole.exr");
}

TEST_F(FarmCli, EverySeedHasItsPicture) {
    EXPECT_EQ(run("render ball.lua --quiet --set seed=3 -o whole.exr").code, 0);
    EXPECT_EQ(farm("--shards 2 --seeds 2..3 -o a.exr").code, 0);
    expect_same("a-3.exr", "whole.exr");
    EXPECT_NE(read_file(path("a-2.exr")), read_file(path("a-3.exr")));
}

TEST_F(FarmCli, WhatTheTasksSayIsShown) {
    write_file(path("bin/sbatch"),
               "#!/bin/sh\necho 'sbatch: error: invalid partition' >&2\nexit 1\n");
    const Outcome refused = farm("--shards 2 -o a.exr");
    EXPECT_EQ(refused.code, 3);
    EXPECT_EQ(refused.err, "sbatch: sbatch: error: invalid partition\n");
    // A file that is there when the farm is checked, and not when its tasks run.
    write_file(path("bin/sbatch"),
               std::string(fake_sbatch)
                   .insert(10, "chmod a-w " + path("b.farm") + "; mv " + path("ball.lua") + " " +
                                   path("gone.lua") + " 2>/dev/null\n"));
    const Outcome failed = farm("--shards 2 -o b.exr --tries 1");
    EXPECT_EQ(failed.code, 1);
    EXPECT_NE(failed.err.find("shard1.exr: " + path("ball.lua") + ": no such file"),
              std::string::npos)
        << failed.err;
}

TEST_F(FarmCli, ADryRunPrintsTheScriptsAndSubmitsNothing) {
    const Outcome outcome = farm("--shards 3 --seeds 4..5 -o 'a b.exr' --threads 2 --dry-run");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(path("bin/calls")));
    EXPECT_FALSE(std::filesystem::exists(path("a b.farm")));
    for (const char* line :
         {"# 6 tasks, which ", "#SBATCH --array=1-6\n", "#SBATCH --cpus-per-task=2\n",
          "shard=$((task % 3 + 1))\n", "seed=$((task / 3 + 4))\n", "a b.farm'\n",
          "merge seed4-shard*.exr -o '", "merge seed5-shard*.exr -o '"})
        EXPECT_NE(outcome.out.find(line), std::string::npos) << line << outcome.out;
}

TEST_F(FarmCli, WhatNoTaskCouldDoIsRefusedAtOnce) {
    const auto refused = [&](const std::string& arguments, const std::string& message) {
        const Outcome outcome = farm("--shards 2 -o a.exr " + arguments);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.err, message + "\n");
    };
    refused("-- --denoise", "--denoise is not for the shards of a farm");
    refused("-- --seed x", "after --: --seed: expected a whole number from 0 to "
                           "18446744073709551615; got x\n  see scree render --help");
    refused("--seeds 5", "--seeds 5: expected FIRST..LAST\n  for example --seeds 1..20");
    refused("--seeds 5..3", "--seeds 5..3: expected FIRST..LAST\n  for example --seeds 1..20");
    refused("--seeds 0..9999999",
            "--seeds 0..9999999: with 2 shards each are more than 1000000 tasks");
    EXPECT_FALSE(std::filesystem::exists(path("a.farm")));
}

} // namespace
} // namespace scree
