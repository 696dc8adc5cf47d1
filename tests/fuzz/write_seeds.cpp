// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the seed files to a given folder, as the initial corpus of the fuzzers.
#include "tests/fuzz/mesh_seeds.h"

#include "core/file.h"

int main(int count, char** arguments) {
    for (const scree::MeshSeed& seed : scree::mesh_seeds())
        if (count > 1)
            scree::write_file(std::string(arguments[1]) + "/" + seed.name, seed.bytes);
}
