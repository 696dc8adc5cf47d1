// SPDX-License-Identifier: GPL-3.0-or-later
// The scene as data: what is rendered, exported and shown.
#pragma once

#include "core/context.h"
#include "core/error.h"
#include "core/image.h"
#include "core/params.h"
#include "model/aggregate.h"
#include "model/camera.h"
#include "model/film_settings.h"
#include "model/light.h"

#include <functional>
#include <optional>

namespace scree {

/// A finished scene.
struct Scene {
    std::string name;       // file name of the script: "toys.lua"
    std::uint64_t hash = 0; // of `settings`
    std::string settings;   // JSON of the description without locations, for file headers
    FilmSettings film;
    std::optional<Camera> camera; // required for rendering only
    std::vector<Light> lights;
    std::vector<Aggregate> aggregates; // one for each item of the script's `objects`
};

/// The provenance of a file, for its header: version, scene, hash and settings; without times, so
/// that the same scene gives the same bytes.
Metadata provenance(const Scene& scene);

/// One item of a script's `objects`, checked but not baked: a generator or a single object.
struct SceneItem {
    std::string kind; // "layout", "object"
    /// `number` is the index of the item in the scene, so that equal objects get different random
    /// numbers.
    std::function<Aggregate(const Context& context, std::uint64_t number)> bake;
    Location where{};   // of its constructor
    std::string name{}; // given in the script; may be empty
};

/// A scene whose items are not baked yet, so that it has no aggregates.
struct SceneDraft {
    Scene scene;
    std::vector<std::shared_ptr<const SceneItem>> items;
    std::shared_ptr<Warnings> warnings = std::make_shared<Warnings>(); // items add theirs
};

} // namespace scree
