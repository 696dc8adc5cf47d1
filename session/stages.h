// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace scree {

/// The cost of one stage of a run.
struct StageCost {
    std::string name; // parse, generate, build, render, denoise, write
    double wall_s = 0;
    double cpu_s = 0;    // of all threads
    double peak_mib = 0; // largest resident memory during the stage
};

/// Measures stages one after the other.
class Stages {
  public:
    /// Ends the running stage, if any, and starts another.
    void begin(const std::string& name);
    void end();
    const std::vector<StageCost>& costs() const { return costs_; }

  private:
    std::vector<StageCost> costs_;
    bool running_ = false;
    std::chrono::steady_clock::time_point wall_start_;
    double cpu_start_ = 0;
};

} // namespace scree
