// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <optional>
#include <string>
#include <vector>

namespace scree::bench {

/// Another program that fills the unit square with points that keep a distance.
struct Peer {
    std::string name;
    std::string command; // to which the distance is appended
    int most = 0;        // points that it is asked for: minutes otherwise
};

std::vector<Peer> elements_peers();

/// What it returned, and the CPU seconds that it measured itself, start-up excluded.
struct PeerRun {
    double seconds = 0;
    std::vector<Vec2> points; // in the unit square
};

/// Nothing when it is not installed.
std::optional<PeerRun> run(const Peer& peer, double radius);

} // namespace scree::bench
