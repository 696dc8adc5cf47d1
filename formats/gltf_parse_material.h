// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/gltf_file.h"
#include "formats/json_element.h"

namespace scree::gltf {

/// A material of a file that has so many textures.
MaterialElement parse_material(const JsonElement& element, std::size_t textures);

} // namespace scree::gltf
