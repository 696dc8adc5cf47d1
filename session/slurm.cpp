// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/slurm.h"

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace scree {

namespace {

constexpr std::size_t largest_array = 1000; // Slurm's default MaxArraySize allows ids up to that
constexpr std::chrono::milliseconds shortest_pause{500}; // between looks at the queue
constexpr std::chrono::milliseconds longest_pause{8000};
constexpr std::size_t most_errors = 10; // that are shown

struct Answer {
    int code = -1;
    std::string text; // stdout and stderr
};

// Without the signals that this program blocks or ignores, so that what hangs can be ended.
class Spawned {
  public:
    explicit Spawned(const std::string& command) {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0)
            throw Error::resource("cannot run " + command + ": " + std::strerror(errno));
        posix_spawn_file_actions_t streams;
        posix_spawn_file_actions_init(&streams);
        posix_spawn_file_actions_adddup2(&streams, ends[1], STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&streams, ends[1], STDERR_FILENO);
        posix_spawnattr_t signals;
        posix_spawnattr_init(&signals);
        sigset_t all;
        sigset_t none;
        sigfillset(&all);
        sigemptyset(&none);
        posix_spawnattr_setsigdefault(&signals, &all);
        posix_spawnattr_setsigmask(&signals, &none);
        posix_spawnattr_setflags(&signals, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
        std::string words[] = {"sh", "-c", command};
        char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
        const int failed = posix_spawn(&id_, "/bin/sh", &streams, &signals, arguments, environ);
        posix_spawnattr_destroy(&signals);
        posix_spawn_file_actions_destroy(&streams);
        close(ends[1]);
        out_ = ends[0];
        if (failed != 0) {
            close(out_);
            throw Error::resource("cannot run " + command + ": " + std::strerror(failed));
        }
    }
    Spawned(const Spawned&) = delete;
    Spawned& operator=(const Spawned&) = delete;
    ~Spawned() { close(out_); }

    Answer answer() const {
        Answer out;
        std::array<char, 4096> block;
        for (ssize_t count = 0; (count = read(out_, block.data(), block.size())) > 0;)
            out.text.append(block.data(), static_cast<std::size_t>(count));
        int status = 0;
        while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
        }
        out.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return out;
    }

  private:
    pid_t id_ = 0;
    int out_ = -1; // what it writes
};

Answer ask(const std::string& command) { return Spawned(command).answer(); }

class Farm {
  public:
    Farm(const FarmPlan& plan, Watcher& watcher, const Cancel& cancel)
        : plan_(plan), watcher_(watcher), cancel_(cancel), jobs_file_(plan.folder() + "/jobs.txt") {
        const std::string identity = plan_.folder() + "/job.txt";
        std::filesystem::create_directories(plan_.folder());
        if (!std::filesystem::exists(identity))
            write_file(identity, plan_.identity());
        else if (read_file(identity) != plan_.identity())
            throw Error(Diagnostic{{},
                                   {},
                                   plan_.folder() + ": holds another job, or the scene has changed",
                                   "give another -o, or remove the folder to begin anew"});
        if (std::filesystem::exists(jobs_file_))
            read_jobs(read_file(jobs_file_));
    }

    bool is_done() const {
        return std::filesystem::exists(plan_.done_mark()) &&
               std::ranges::all_of(plan_.pictures(), [](const std::string& picture) {
                   return std::filesystem::exists(picture);
               });
    }

    /// What is missing and not queued.
    void submit() {
        if (is_queued())
            return;
        const KeepingWork keeping(&cancel_); // or jobs would be queued that nobody knows of
        const std::vector<std::size_t> missing = plan_.missing();
        std::filesystem::remove(plan_.done_mark());
        jobs_.clear();
        for (std::size_t first = 0; first < missing.size(); first += largest_array) {
            const std::size_t count = std::min(largest_array, missing.size() - first);
            const std::string name =
                fmt::format("{}/array{}", plan_.folder(), first / largest_array);
            write_file(
                name + ".txt",
                fmt::format("{}\n",
                            fmt::join(missing.begin() + std::ptrdiff_t(first),
                                      missing.begin() + std::ptrdiff_t(first + count), "\n")));
            write_file(name + ".sh", plan_.array_script(name + ".txt", count));
            batch("", name + ".sh");
        }
        watcher_.say(fmt::format("{} of {} submitted", missing.size(),
                                 counted(plan_.tasks().size(), "task")));
        const std::string after =
            jobs_.empty() ? ""
                          : fmt::format("--kill-on-invalid-dep=yes --dependency=afterok:{} ",
                                        fmt::join(jobs_, ":"));
        write_file(plan_.folder() + "/merge.sh", plan_.merge_script());
        batch(after, plan_.folder() + "/merge.sh");
    }

    /// Until nothing of it is queued any more.
    void wait() {
        auto pause = shortest_pause;
        while (is_queued()) {
            cancel_.check();
            const auto all = double(plan_.tasks().size());
            watcher_.progress("farm", 1 - double(plan_.missing().size()) / all, states_);
            std::this_thread::sleep_for(pause);
            pause = std::min(pause * 2, longest_pause);
        }
    }

    /// What the tasks without a shard said last; "" for nothing.
    std::string errors() const {
        std::string out;
        std::size_t shown = 0;
        for (const std::size_t i : plan_.missing())
            add_error(plan_.shard(plan_.tasks()[i]), plan_.log(plan_.tasks()[i]), out, shown);
        add_error("merge", plan_.merge_log(), out, shown);
        return out;
    }

  private:
    static void add_error(const std::string& what, const std::string& log, std::string& out,
                          std::size_t& shown) {
        if (!std::filesystem::exists(log) || shown == most_errors)
            return;
        const std::string said(trimmed(read_file(log)));
        if (said.empty())
            return;
        out += fmt::format("{}{}: {}", out.empty() ? "" : "\n", file_name(what), said);
        ++shown;
    }

    void read_jobs(const std::string& text) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            jobs_.push_back(line);
    }

    void batch(const std::string& options, const std::string& script) {
        const Answer answer = ask("sbatch --parsable " + options + shell_word(script));
        if (answer.code != 0)
            throw Error::resource("sbatch: " + std::string(trimmed(answer.text)));
        const std::string id(trimmed(answer.text));
        jobs_.push_back(id.substr(0, id.find(';'))); // ";cluster" may follow
        write_file(jobs_file_, fmt::format("{}\n", fmt::join(jobs_, "\n")));
    }

    // While the controller does not answer the jobs may be queued.
    bool is_queued() {
        if (jobs_.empty())
            return false;
        const Answer answer = ask("squeue --noheader --me --format='%F %i %T %r'");
        if (answer.code != 0) {
            if (!std::exchange(is_silent_, true))
                watcher_.warn("the queue does not answer, and is asked again: " +
                              std::string(trimmed(answer.text)));
            return true;
        }
        is_silent_ = false;
        const std::set<std::string> own(jobs_.begin(), jobs_.end());
        std::map<std::string, int> states;
        std::istringstream lines(answer.text);
        std::string job;
        std::string task;
        std::string state;
        std::string reason;
        while (lines >> job >> task >> state && std::getline(lines, reason))
            if (own.contains(job)) {
                ++states[lower_case(state)];
                if (reason.find("launch failed") != std::string::npos)
                    release(task);
            }
        states_.clear();
        for (const auto& [name, count] : states)
            states_ += fmt::format(" {} {}", count, name);
        return !states.empty();
    }

    // Slurm holds a task that a node failed to start, until somebody says that it may start again.
    void release(const std::string& task) {
        watcher_.say(task + " could not be started, and is tried again");
        ask("scontrol release " + shell_word(task));
    }

    const FarmPlan& plan_;
    Watcher& watcher_;
    const Cancel& cancel_;
    std::string jobs_file_;
    std::vector<std::string> jobs_; // ids
    std::string states_;
    bool is_silent_ = false;
};

} // namespace

void run_on_slurm(const FarmPlan& plan, int tries, bool wait, Watcher& watcher,
                  const Cancel& cancel) {
    Farm farm(plan, watcher, cancel);
    for (int i = 0; i < tries && !farm.is_done(); ++i) {
        farm.submit();
        if (!wait)
            return;
        farm.wait();
    }
    if (farm.is_done())
        return;
    const std::string errors = farm.errors();
    throw Error(errors.empty() ? fmt::format("{} of {} ended without a word; {} has what is there",
                                             plan.missing().size(),
                                             counted(plan.tasks().size(), "task"), plan.folder())
                               : errors);
}

} // namespace scree
