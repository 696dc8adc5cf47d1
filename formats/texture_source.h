// SPDX-License-Identifier: GPL-3.0-or-later
// What the baking of procedurals to files shares.
#pragma once

#include "core/context.h"
#include "core/image.h"
#include "geometry/mesh/mesh.h"
#include "model/procedural.h"

#include <functional>
#include <memory>
#include <string>

namespace scree {

/// What of a procedural a file holds.
enum class TextureChannel { color, height, roughness, value, normal };

/// "R", "G", "B" of a colour or a normal, "Y" of a number.
std::vector<std::string> channel_names(TextureChannel channel);

/// The sample's channel, all but the normal, to as many floats as it has names.
void put_channel(TextureChannel channel, const ShadingSample& sample, float* pixel);

/// A mesh with the procedural to bake on it.
struct TextureSource {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Procedural> procedural;
    float random = 0;                       // of the instance
    float roughness = ShadingSample::unset; // where the procedural leaves it to the material
    Device* device = nullptr;               // null: the procedural runs on the host

    /// Evaluates `count` points in blocks on all threads (or the device): `place` and `take` are
    /// called from many threads at once. Reports its progress.
    void evaluate(std::size_t count, const std::function<ShadingPoint(std::size_t)>& place,
                  const std::function<void(std::size_t, const ShadingSample&)>& take,
                  const Context& context) const;
};

} // namespace scree
