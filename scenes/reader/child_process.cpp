// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/child_process.h"

#include "core/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace scree {

namespace {

constexpr int channel_descriptor = 3;
constexpr rlim_t max_descriptors = 8; // stdio, the pipe, one script at a time

void limit(int resource, rlim_t value) {
    rlimit now{};
    getrlimit(resource, &now);
    const rlimit wanted{std::min(value, now.rlim_max), std::min(value, now.rlim_max)};
    setrlimit(resource, &wanted);
}

// The virtual memory of this process in bytes, which includes that of all libraries.
std::size_t mapped_bytes() {
    unsigned long pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%lu", &pages) != 1)
            pages = 0;
        std::fclose(file);
    }
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

[[noreturn]] void be_child(int pipe_end, pid_t parent, const ChildLimits& limits,
                           const std::function<void(const Channel&)>& body) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(1);
    // What ends the parent ends this too, by the signal asked for above.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        std::signal(signal, SIG_IGN);
    for (const int signal : {SIGPIPE, SIGPROF, SIGXCPU, SIGXFSZ})
        std::signal(signal, SIG_DFL);
    if (pipe_end != channel_descriptor)
        dup2(pipe_end, channel_descriptor);
    close_range(channel_descriptor + 1, ~0U, 0);
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    close(nothing);
    const auto cpu = static_cast<rlim_t>(std::ceil(limits.cpu_seconds));
    limit(RLIMIT_AS, mapped_bytes() + limits.memory);
    limit(RLIMIT_CPU, cpu);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_NOFILE, max_descriptors);
    limit(RLIMIT_NPROC, 0);
    limit(RLIMIT_CORE, 0);
    body(Channel(channel_descriptor));
    _exit(0);
}

// Splits the bytes of the pipe into messages.
class Messages {
  public:
    void add(const char* bytes, std::size_t count,
             const std::function<void(char, std::string)>& receive) {
        pending_.append(bytes, count);
        std::size_t at = 0;
        std::uint64_t length = 0;
        while (pending_.size() - at >= 1 + sizeof length) {
            std::memcpy(&length, pending_.data() + at + 1, sizeof length);
            if (pending_.size() - at - 1 - sizeof length < length)
                break;
            receive(pending_[at], pending_.substr(at + 1 + sizeof length, length));
            at += 1 + sizeof length + length;
        }
        pending_.erase(0, at);
    }

  private:
    std::string pending_;
};

using Clock = std::chrono::steady_clock;

// Reads until the child closes the pipe; false when the deadline passes first.
bool read_all(int pipe_end, Clock::time_point deadline,
              const std::function<void(char, std::string)>& receive) {
    Messages messages;
    std::array<char, std::size_t{1} << 16> block;
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0)
            return false;
        pollfd wait{pipe_end, POLLIN, 0};
        if (poll(&wait, 1, static_cast<int>(std::min<std::int64_t>(left, 60'000))) <= 0)
            continue; // interrupted by a signal, or timed out: check the deadline
        const ssize_t count = read(pipe_end, block.data(), block.size());
        if (count == 0)
            return true;
        if (count > 0)
            messages.add(block.data(), static_cast<std::size_t>(count), receive);
        else if (errno != EINTR)
            return true;
    }
}

// Kills and reaps the child on every exit from run_in_child.
class Child {
  public:
    Child(pid_t id, int pipe_end) : id_(id), pipe_end_(pipe_end) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        close(pipe_end_);
        if (id_ > 0) {
            kill(id_, SIGKILL);
            wait();
        }
    }

    int wait() {
        int status = 0;
        while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
        }
        id_ = 0;
        return status;
    }

  private:
    pid_t id_;
    int pipe_end_;
};

} // namespace

void Channel::send(char type, std::string_view bytes) const noexcept {
    const std::uint64_t length = bytes.size();
    std::array<char, 1 + sizeof length> head{type};
    std::memcpy(head.data() + 1, &length, sizeof length);
    for (std::string_view rest : {std::string_view(head.data(), head.size()), bytes})
        while (!rest.empty()) {
            const ssize_t count = write(descriptor_, rest.data(), rest.size());
            if (count < 0 && errno != EINTR)
                return;
            rest.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
        }
}

ChildEnd run_in_child(const ChildLimits& limits, const std::function<void(const Channel&)>& body,
                      const std::function<void(char type, std::string bytes)>& receive) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw Error::resource(std::string("cannot run the script: ") + std::strerror(errno));
    const pid_t parent = getpid();
    const pid_t id = fork();
    if (id < 0) {
        const int code = errno;
        close(ends[0]);
        close(ends[1]);
        throw Error::resource(std::string("cannot run the script: ") + std::strerror(code));
    }
    if (id == 0)
        be_child(ends[1], parent, limits, body);
    close(ends[1]);
    Child child(id, ends[0]);
    const auto wall = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(limits.wall_seconds));
    if (!read_all(ends[0], Clock::now() + wall, receive))
        return ChildEnd::time;
    const int status = child.wait();
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return ChildEnd::done;
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    // When the soft limit equals the hard limit, the kernel sends SIGKILL at RLIMIT_CPU.
    if (signal == SIGXCPU || signal == SIGKILL)
        return ChildEnd::time;
    return ChildEnd::crashed;
}

} // namespace scree
