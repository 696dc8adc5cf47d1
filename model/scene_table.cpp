// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/table.h"

namespace scree {

std::vector<ParamSpec> scene_params() {
    return {{.name = "film",
             .type = ParamType::record,
             .doc = "Settings of the picture: see film.",
             .fields = film_params()},
            {.name = "camera",
             .type = ParamType::object,
             .families = {"camera"},
             .doc = "The camera; baking does not need one.",
             .optional = true},
            {.name = "lights",
             .type = ParamType::list,
             .doc = "The lights.",
             .optional = true,
             .fields = {{.name = "light",
                         .type = ParamType::object,
                         .families = {"light"},
                         .doc = "One of the lights."}}},
            {.name = "objects",
             .type = ParamType::list,
             .doc = "The objects and generators.",
             .fields = {{.name = "object",
                         .type = ParamType::object,
                         .families = {"generator", "object"},
                         .doc = "One of the objects."}},
             .min_items = 1}};
}

SceneDraft scene_draft(const Params& params) {
    SceneDraft draft;
    draft.scene.film = film_settings(params.record("film"));
    if (const auto camera = params.object<Camera>("camera"))
        draft.scene.camera = *camera;
    if (params.has("lights"))
        for (const Params& item : params.list("lights"))
            draft.scene.lights.push_back(*item.object<Light>("light"));
    for (const Params& item : params.list("objects"))
        draft.items.push_back(item.object<SceneItem>("object"));
    return draft;
}

} // namespace scree
