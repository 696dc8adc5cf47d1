// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"

#include <string>

namespace scree::bench {

/// Whether Blender is installed, whose renderer Cycles is.
bool has_blender();

/// A picture of Cycles.
struct CyclesRun {
    Image picture;          // R, G, B, linear
    double cpu_seconds = 0; // of taking the samples
};

/// Renders the scene that `write_peer_scene` has put into the folder, with two threads. Throws
/// Error (resource) when Blender fails, naming the file of its messages.
CyclesRun run_cycles(const std::string& folder, int samples, int seed);

} // namespace scree::bench
