// SPDX-License-Identifier: GPL-3.0-or-later
// The scene as data: what is rendered, exported and shown.
#pragma once

#include "core/context.h"
#include "core/error.h"
#include "core/image.h"
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
    std::string settings;   // the description's JSON without locations, for the picture's header
    FilmSettings film;
    std::optional<Camera> camera; // a picture needs one; baking and exports do without
    std::vector<Light> lights;
    std::vector<Aggregate> aggregates; // one per item of the script's `objects`
};

/// Where a file came from, for its header: version, scene, hash and settings; no times, so that the
/// same scene gives the same bytes.
Metadata provenance(const Scene& scene);

/// One item of a script's `objects`, checked but not made yet: a generator, or a single object.
struct SceneItem {
    std::string kind; // "layout", "object"
    /// `number`: of the item in its scene, from 0; it seeds what differs between equal objects.
    std::function<Aggregate(const Context& context, std::uint64_t number)> bake;
    Location where{}; // of its constructor
};

/// A scene whose items have still to be baked; until then it has no aggregates.
struct SceneDraft {
    Scene scene;
    std::vector<std::shared_ptr<const SceneItem>> items;
};

} // namespace scree
