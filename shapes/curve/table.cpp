// SPDX-License-Identifier: GPL-3.0-or-later
// curve.polyline and curve.spline: strands whose points a script gives.
#include "shapes/table.h"
#include "core/frame.h"
#include "core/random.h"
#include "core/text.h"
#include "geometry/mesh/strand_spline.h"

#include <fmt/format.h>

namespace scree {

namespace {

/// What a script says of one strand.
struct Given {
    std::vector<Vec3> points;
    std::vector<float> radii; // one per point [m]
};

Given given_strand(const Params& params) {
    Given out{params.points3("points"), {}};
    for (std::size_t i = 1; i < out.points.size(); ++i)
        if (out.points[i] == out.points[i - 1])
            throw params.error("points", fmt::format("points {} and {} are the same", i, i + 1));
    const std::vector<double>& radii = params.numbers("radius");
    if (radii.size() != 1 && radii.size() != out.points.size())
        throw params.error("radius",
                           fmt::format("has {} for {}", counted(radii.size(), "number"),
                                       counted(out.points.size(), "point")),
                           "one number for all points, or one for each");
    for (std::size_t i = 0; i < out.points.size(); ++i)
        out.radii.push_back(static_cast<float>(radii[radii.size() == 1 ? 0 : i]));
    return out;
}

std::vector<Given> given_strands(const Params& params) {
    if (params.has("points") == params.has("strands"))
        throw params.error(params.has("points") ? "strands" : "points",
                           params.has("points") ? "cannot be given together with points"
                                                : "is missing",
                           "points of one strand, or strands = { { points = ... }, ... }");
    if (params.has("points"))
        return {given_strand(params)};
    std::vector<Given> out;
    for (const Params& strand : params.list("strands"))
        out.push_back(given_strand(strand));
    return out;
}

void add_chain(Strands& strands, const Given& given) {
    strands.points.insert(strands.points.end(), given.points.begin(), given.points.end());
    strands.radii.insert(strands.radii.end(), given.radii.begin(), given.radii.end());
    strands.offsets.push_back(static_cast<std::uint32_t>(strands.points.size()));
}

Strands make(const Params& params, CurveKind kind, const char* name) {
    Strands strands;
    strands.name = name;
    strands.kind = kind;
    strands.offsets.push_back(0);
    for (const Given& given : given_strands(params)) {
        const std::size_t number = strands.count();
        if (kind == CurveKind::linear)
            add_chain(strands, given);
        else
            add_spline(strands, given.points, given.radii);
        strands.randoms.push_back(Random(0, Purpose::mesh_shape, number).uniform_float());
        strands.normals.push_back(Frame(unit(given.points[1] - given.points[0])).x);
    }
    return strands;
}

ParamSpec points_spec(bool optional) {
    return {.name = "points",
            .type = ParamType::points3,
            .doc = "Points of the strand, from its root to its tip.",
            .unit = "m",
            .optional = optional,
            .min_items = 2};
}

ParamSpec radius_spec() {
    return {.name = "radius",
            .type = ParamType::numbers,
            .doc = "Of the strand; one number, or one for each point.",
            .unit = "m",
            .fallback = 0.001,
            .min = 0.0,
            .max = 1e6,
            .above_min = true};
}

Plugin<MakeCurve> curve_plugin(const char* name, const char* doc, CurveKind kind) {
    return {name,
            doc,
            {points_spec(true),
             radius_spec(),
             {.name = "strands",
              .type = ParamType::list,
              .doc = "Many strands in one shape, in place of points.",
              .optional = true,
              .fields = {points_spec(false), radius_spec()},
              .min_items = 1}},
            [kind, name](const Params& params) { return make(params, kind, name); }};
}

} // namespace

Registry<MakeCurve> curve_table() {
    Registry<MakeCurve> table("curve");
    table.add(curve_plugin("polyline",
                           "Strands of straight pieces with round joints and ends, through points.",
                           CurveKind::linear));
    table.add(curve_plugin(
        "spline", "Smooth strands with round ends (open ones of material.fibre), through points.",
        CurveKind::bspline));
    return table;
}

} // namespace scree
