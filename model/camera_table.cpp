// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/table.h"

#include "model/table_tools.h"

namespace scree {

namespace {

Plugin<MakeCamera> perspective_plugin() {
    return {
        "perspective",
        "A pinhole or thin-lens camera.",
        {{.name = "from", .type = ParamType::point3, .doc = "Position of the eye.", .unit = "m"},
         {.name = "at",
          .type = ParamType::point3,
          .doc = "Point that it looks at.",
          .unit = "m",
          .fallback = WideVec3(0)},
         {.name = "up",
          .type = ParamType::vector3,
          .doc = "Direction that is up in the picture.",
          .fallback = Vec3(0.0F, 1.0F, 0.0F)},
         {.name = "fov",
          .type = ParamType::number,
          .doc = "Full vertical angle of view.",
          .unit = "deg",
          .fallback = 35.0,
          .min = 0.1,
          .max = 170.0},
         {.name = "aperture",
          .type = ParamType::number,
          .doc = "Diameter of the lens; 0 keeps everything in focus.",
          .unit = "m",
          .fallback = 0.0,
          .min = 0.0,
          .max = 10.0},
         {.name = "focus",
          .type = ParamType::number,
          .doc = "Distance of the plane in focus; that of `at` when not given.",
          .unit = "m",
          .optional = true,
          .min = 1e-4,
          .max = 1e6}},
        [](const Params& params) -> Camera {
            Camera camera;
            camera.from = params.point3("from");
            camera.at = params.point3("at");
            camera.up = params.vector3("up");
            camera.fov = float_number(params, "fov");
            camera.aperture = float_number(params, "aperture");
            camera.focus = params.has("focus") ? float_number(params, "focus") : 0.0F;
            const Vec3 view(camera.at - camera.from);
            if (!(is_finite(view) && view.length() > 0))
                throw params.error("at", "must differ from `from`");
            if (!(view.normalized().cross(camera.up.normalized()).length() > 1e-6F))
                throw params.error("up", "must not be parallel to the view direction");
            return camera;
        }};
}

} // namespace

Registry<MakeCamera> camera_table() {
    Registry<MakeCamera> table("camera");
    table.add(perspective_plugin());
    return table;
}

} // namespace scree
