// SPDX-License-Identifier: GPL-3.0-or-later
// description -> scene: every value checked against its declaration, every object made.
#pragma once

#include "core/context.h"
#include "render/table.h"
#include "scenes/reader/description.h"

#include <functional>
#include <optional>

namespace scree {

/// Something that bakes to an aggregate: a generator, or a single object.
struct SceneItem {
    std::string kind; // "layout", "object"
    std::function<Aggregate(const Context& context)> bake;
    Location where{}; // of its constructor
};

/// A checked scene, ready to be baked and rendered.
struct Scene {
    std::string name;       // file name of the script: "toys.lua"
    std::uint64_t hash = 0; // of `settings`
    std::string settings;   // the description's JSON without locations, for the picture's header
    FilmSettings film;
    std::optional<Camera> camera;    // baking does without; a picture needs one
    std::vector<Material> materials; // by MaterialId; index 0 is the default material
    std::vector<Light> lights;
    std::vector<SceneItem> items;
};

/// Checks the whole description, collecting all mistakes into one Error, and makes its objects.
Scene resolve(const DescriptionNode& root, const std::string& path);

} // namespace scree
