// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/stages.h"

#include <fstream>
#include <sys/resource.h>

namespace scree {

namespace {

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return double(t.tv_sec) + 1e-6 * double(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// On Linux, writing 5 resets the peak of the resident memory (proc(5)).
void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

double peak_memory_mib() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:"))
            return std::stod(line.substr(6)) / 1024;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

} // namespace

void Stages::begin(const std::string& name) {
    end();
    reset_peak_memory();
    costs_.push_back({name, 0, 0, 0});
    wall_start_ = std::chrono::steady_clock::now();
    cpu_start_ = cpu_seconds();
    running_ = true;
}

void Stages::end() {
    if (!running_)
        return;
    StageCost& cost = costs_.back();
    cost.wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start_).count();
    cost.cpu_s = cpu_seconds() - cpu_start_;
    cost.peak_mib = peak_memory_mib();
    running_ = false;
}

} // namespace scree
