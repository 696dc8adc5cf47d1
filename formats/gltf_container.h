// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace scree::gltf {

/// The parts of a .glb file, or of a .gltf file, which is all JSON.
struct Container {
    std::string_view json;
    std::string_view binary; // data() is null when there is none
    std::size_t beyond = 0;  // bytes after the end that a .glb file's header names
};

/// Throws Error (input) when a .glb file is of another version, or a length in it is wrong.
Container container_of(std::string_view bytes);

} // namespace scree::gltf
