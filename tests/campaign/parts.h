// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the campaign. Each prints what it did and returns the number of findings.
#pragma once

#include <string>

namespace scree::campaign {

/// Damages files of every format below the folder `seeds` and gives them to the program: it must
/// end by itself, within 2 s of processor time and 512 MiB, and a message must name the file.
long damage_files(const std::string& seeds, long count);

/// Kills renders and bakes at random times: what they write must be as before or whole, and the
/// next run must take away what was left.
long kill_runs(long count);

/// Interrupts commands in each of their stages: they must end within half a second with 128 + the
/// signal, and leave their outputs as before or whole.
long send_signals();

/// Lets the n-th open, write, fsync, rename, close and allocation fail, for every n and every
/// output format: exit code 3 and the old file, or success and a whole new one. `shim` is
/// fault_shim.so.
long fail_calls(const std::string& shim);

} // namespace scree::campaign
