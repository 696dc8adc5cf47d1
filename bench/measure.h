// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <ctime>
#include <fstream>
#include <malloc.h>
#include <unistd.h>
#include <vector>

namespace scree {

/// CPU seconds that the whole process spends on the work; less affected by other load than wall
/// time.
double cpu_seconds_of(const auto& work) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

/// What the process has in memory now, without what was freed [B].
inline double resident_bytes() {
    malloc_trim(0);
    std::ifstream file("/proc/self/statm");
    double pages = 0;
    file >> pages >> pages; // the second
    return pages * double(sysconf(_SC_PAGESIZE));
}

/// The median; of an even number of values the upper one. `values` must not be empty.
inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

} // namespace scree
