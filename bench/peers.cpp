// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/peers.h"

#include <cstdio>
#include <memory>

namespace scree::bench {

std::vector<Peer> elements_peers() {
    const std::string source = SCREE_SOURCE_DIR;
    const std::string drivers = source + "/bench/peers/";
    const std::string npm =
        "NODE_PATH=\"" + source + "/build/peers/node_modules\" node " + drivers + "npm.js ";
    return {
        {"npm fast-2d-poisson-disk-sampling", npm + "fast-2d-poisson-disk-sampling", 1000000},
        {"npm poisson-disk-sampling", npm + "poisson-disk-sampling", 1000000},
        {"Debian python3-scipy qmc", "/usr/bin/python3 " + drivers + "qmc.py", 10000},
        {"Debian r-cran-spatstat rSSI", "Rscript " + drivers + "spatstat.R", 10000},
    };
}

std::optional<PeerRun> run(const Peer& peer, double radius) {
    char distance[40];
    std::snprintf(distance, sizeof distance, " %.17g 2>/dev/null", radius);
    const auto close = [](std::FILE* file) { return file != nullptr ? pclose(file) : 0; };
    const std::unique_ptr<std::FILE, decltype(close)> pipe(
        popen((peer.command + distance).c_str(), "r"), close);
    PeerRun out;
    if (pipe == nullptr || std::fscanf(pipe.get(), "%lf", &out.seconds) != 1)
        return {};
    Vec2 point;
    while (std::fscanf(pipe.get(), "%lf %lf", &point.x, &point.y) == 2)
        out.points.push_back(point);
    return out;
}

} // namespace scree::bench
