// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <optional>
#include <string>
#include <vector>

namespace scree::bench {

/// Another program that fills the unit square with Poisson-disk samples.
struct Peer {
    std::string name;
    std::string command; // the distance is appended
    int most = 0;        // maximum number of points, so that it does not take minutes
};

std::vector<Peer> elements_peers();

/// Its points, and the CPU seconds that it measured itself, without start-up.
struct PeerRun {
    double seconds = 0;
    std::vector<Vec2> points; // in the unit square
};

/// Runs it; empty when it is not installed.
std::optional<PeerRun> run(const Peer& peer, double radius);

} // namespace scree::bench
