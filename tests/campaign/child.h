// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program as a user's shell would, and measures what it takes.
#pragma once

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <functional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace scree::campaign {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How a run of the program ended.
struct Ended {
    int code = -1;  // of exit; -1: by a signal
    int signal = 0; // that ended it
    double cpu_s = 0;
    double peak_mib = 0;
    bool timed_out = false; // and was killed
};

struct Call {
    std::vector<std::string> words;         // the program and its arguments
    std::string folder;                     // to run in; stderr goes to err.txt there
    std::vector<std::string> environment{}; // "NAME=value"
};

/// A program that runs.
class Child {
  public:
    explicit Child(const Call& call) : id_(fork()) {
        if (id_ != 0)
            return;
        if (chdir(call.folder.c_str()) != 0)
            _exit(99);
        for (const std::string& setting : call.environment)
            putenv(const_cast<char*>(setting.c_str()));
        for (const int heeded : {SIGINT, SIGTERM, SIGHUP})
            std::signal(heeded, SIG_DFL); // whatever this was started with
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        dup2(open("err.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
        std::vector<char*> words;
        for (const std::string& word : call.words)
            words.push_back(const_cast<char*>(word.c_str()));
        words.push_back(nullptr);
        execv(words[0], words.data());
        _exit(98);
    }

    void send(int signal) const { kill(id_, signal); }

    /// Waits until it ends, at most `limit` seconds, after which it is killed.
    Ended wait(double limit = 120) {
        const auto start = Clock::now();
        Ended out;
        int status = 0;
        rusage usage{};
        while (wait4(id_, &status, WNOHANG, &usage) == 0) {
            if (!out.timed_out && seconds_since(start) > limit) {
                out.timed_out = true;
                send(SIGKILL);
            }
            usleep(500);
        }
        const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * t.tv_usec; };
        out.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
        out.peak_mib = double(usage.ru_maxrss) / 1024;
        if (WIFEXITED(status))
            out.code = WEXITSTATUS(status);
        else
            out.signal = WTERMSIG(status);
        return out;
    }

  private:
    pid_t id_;
};

inline Ended run(const Call& call, double limit = 120) { return Child(call).wait(limit); }

/// Counts what went wrong, and shows the first cases of it.
class Findings {
  public:
    void add(const std::string& what) {
        if (++count_ <= 40)
            std::printf("  found: %s\n", what.c_str());
        std::fflush(stdout);
    }
    long count() const { return count_; }

  private:
    long count_ = 0;
};

} // namespace scree::campaign
