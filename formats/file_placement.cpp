// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/file_placement.h"

#include <algorithm>
#include <array>

namespace scree {

namespace {

using Imath::Box3d;
using Imath::V3d;

/// A unit of length that files are in.
struct FileUnit {
    std::string name;
    double metres = 1;
};
const std::array<FileUnit, 5> file_units{
    {{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}};

std::vector<std::string> unit_names() {
    std::vector<std::string> names;
    names.reserve(file_units.size());
    for (const FileUnit& unit : file_units)
        names.push_back(unit.name);
    return names;
}

double metres_of(const std::string& name) {
    return std::ranges::find(file_units, name, &FileUnit::name)->metres;
}

double longest_side(const Box3d& box) {
    return std::max({box.size().x, box.size().y, box.size().z});
}

} // namespace

std::vector<ParamSpec> placement_specs(const std::string& known) {
    return {{.name = "unit",
             .type = ParamType::choice,
             .doc = "The unit of the file's numbers; metres when not given. " + known,
             .optional = true,
             .choices = unit_names()},
            {.name = "size",
             .type = ParamType::number,
             .doc = "Longest side of the bounding box after scaling; the shape is also moved to "
                    "stand on y = 0, centred on the y axis. Unchanged when not given.",
             .unit = "m",
             .optional = true,
             .min = 1e-6,
             .max = 1e6},
            {.name = "centre",
             .type = ParamType::boolean,
             .doc = "Whether the shape is moved as with `size`, but not scaled. Files of millions "
                    "of metres, as those of surveys, need one of both.",
             .fallback = false},
            {.name = "up",
             .type = ParamType::choice,
             .doc = "Which axis of the file points up.",
             .fallback = std::string("y"),
             .choices = {"y", "z"}}};
}

FilePlacement::FilePlacement(const Params& params, const Box3d& box, const std::string& known)
    : z_up_(params.text("up") == "z"), centred_(params.has("size") || params.flag("centre")),
      unit_unknown_(known.empty() && !params.has("unit") && !params.has("size")) {
    if (params.has("unit")) {
        if (!known.empty())
            throw params.error("unit", known,
                               "leave it away; size and object.scale change a shape too");
        unit_ = metres_of(params.text("unit"));
    }
    if (!centred_)
        return;
    Box3d seen(turned(box.min * unit_));
    seen.extendBy(turned(box.max * unit_));
    foot_ = V3d(seen.center().x, seen.min.y, seen.center().z);
    if (const double longest = longest_side(seen); params.has("size") && longest > 0)
        factor_ = params.number("size") / longest; // a point keeps its size
}

} // namespace scree
