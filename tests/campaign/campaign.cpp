// SPDX-License-Identifier: GPL-3.0-or-later
// A campaign against the program: damaged files, kills, signals and failing calls of the system.
//   campaign files SEEDS COUNT | kills COUNT | signals | faults SHIM
#include "tests/campaign/parts.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    using namespace scree::campaign;
    const std::string part = argc > 1 ? argv[1] : "";
    long found = -1;
    if (part == "files" && argc == 4)
        found = damage_files(argv[2], std::atol(argv[3]));
    else if (part == "kills" && argc == 3)
        found = kill_runs(std::atol(argv[2]));
    else if (part == "signals" && argc == 2)
        found = send_signals();
    else if (part == "faults" && argc == 3)
        found = fail_calls(argv[2]);
    if (found < 0) {
        std::fprintf(stderr, "campaign files SEEDS COUNT | kills COUNT | signals | faults SHIM\n");
        return 2;
    }
    std::printf("%s: %ld findings\n", part.c_str(), found);
    return found == 0 ? 0 : 1;
}
