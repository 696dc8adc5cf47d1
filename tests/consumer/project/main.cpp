// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a scene, bakes it and counts the instances, using only the installed headers.
#include "core/version.h"
#include "session/session.h"

#include <cstdio>
#include <fstream>

int main() {
    const char* path = "consumer_scene.lua";
    std::ofstream(path) << "return scene {\n"
                           "  camera = camera.perspective { from = {0, 1, 1} },\n"
                           "  objects = { generator.layout {\n"
                           "    domain = region.rectangle { width = 1, depth = 1 },\n"
                           "    components = { { shape = mesh.box {} } },\n"
                           "    cancellations = 100, seed = 1 } } }\n";
    try {
        scree::Session session({.path = path});
        const scree::Scene scene = session.bake(session.load());
        const scree::Aggregate& aggregate = scene.aggregates.front();
        std::printf("scree %s placed %zu boxes\n", SCREE_VERSION, aggregate.instances.size());
        return aggregate.instances.empty() ? 1 : 0;
    } catch (const scree::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
