// SPDX-License-Identifier: GPL-3.0-or-later
// Mattes by which a compositor selects objects, instances or materials with their antialiased
// edges: Cryptomatte 1.2 (Friedman & Jones 2015, "Fully automatic ID mattes with support for motion
// blur and transparency", and its specification).
#pragma once

#include "core/image.h"
#include "model/aggregate.h"
#include "render/film/film.h"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace scree {

/// The layers that there are. An object is an item of the scene.
inline constexpr std::array<std::string_view, 3> cryptomatte_layers{
    "crypto_object", "crypto_instance", "crypto_material"};

/// What one layer adds to an .exr.
struct Cryptomatte {
    std::vector<ImagePart> parts; // LAYER00 to LAYER02: two names and their coverages in each
    Metadata metadata;            // with the names, unless there are more than 10,000
};

/// A layer of a film with mattes. `materials` by Seen::material. Objects and instances are called
/// by the scene's names, or else by their generators: "stones" and "stones/pebble.17".
Cryptomatte make_cryptomatte(std::string_view layer, const Film& film,
                             std::span<const Aggregate> aggregates,
                             std::span<const std::shared_ptr<const Material>> materials);

/// The 32 bits that stand for a name: MurmurHash3_x86_32 (Appleby 2011) with seed 0, with bit 23
/// flipped where the bits would not be those of a normal float.
std::uint32_t cryptomatte_id(std::string_view name);

} // namespace scree
