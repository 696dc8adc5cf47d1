// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer harness of one mesh reader, chosen at compile time by SCREE_FUZZ_ENDING.
#include "core/error.h"
#include "formats/read_mesh.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        scree::read_mesh_bytes("x." SCREE_FUZZ_ENDING, {reinterpret_cast<const char*>(data), size});
    } catch (const scree::Error&) {
        return 0; // rejected with an Error, as required
    }
    return 0;
}
