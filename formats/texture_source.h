// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by all ways of baking procedurals to files.
#pragma once

#include "core/context.h"
#include "core/image.h"
#include "geometry/mesh/mesh.h"
#include "model/procedural.h"

#include <functional>
#include <memory>
#include <string>

namespace scree {

/// The part of a procedural's samples that a file holds.
enum class TextureChannel { color, height, roughness, value, normal };

/// "R", "G", "B" for a colour or a normal, "Y" for a scalar.
std::vector<std::string> channel_names(TextureChannel channel);

/// Writes a channel of a sample, other than the normal, to one float for each of its names.
void put_channel(TextureChannel channel, const ShadingSample& sample, float* pixel);

/// A mesh with the procedural to bake on it.
struct TextureSource {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Procedural> procedural;
    float random = 0;                       // of the instance
    Vec3 stretch{1.0F, 1.0F, 1.0F};         // by the instance, of the object's axes
    float roughness = ShadingSample::unset; // of the material, where the procedural gives none
    Device* device = nullptr;               // null: the procedural runs on the host

    /// Evaluates `count` points in blocks on all threads (or the device). `place` gives the point
    /// of an index, `take` receives its sample; both are called from several threads at once.
    /// Reports progress.
    void evaluate(std::size_t count, const std::function<ShadingPoint(std::size_t)>& place,
                  const std::function<void(std::size_t, const ShadingSample&)>& take,
                  const Context& context) const;
};

} // namespace scree
