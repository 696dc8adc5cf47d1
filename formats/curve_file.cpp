// SPDX-License-Identifier: GPL-3.0-or-later
// curve.file: strands from a baked file or the lines of an OBJ file.
#include "core/file.h"
#include "core/frame.h"
#include "core/located.h"
#include "core/random.h"
#include "formats/obj_statements.h"
#include "formats/read_bake_json.h"
#include "formats/table.h"
#include "geometry/mesh/strand_spline.h"

#include <fmt/format.h>

namespace scree {

namespace {

/// The lines of an OBJ file; one that begins where the last one ends goes on with it, since many
/// programs write each piece alone.
std::vector<std::vector<Vec3>> lines_of(const Obj& obj) {
    std::vector<std::vector<Vec3>> out;
    std::int32_t last = Obj::absent;
    for (const Obj::Face& line : obj.lines) {
        const std::span<const ObjCorner> corners = obj.corners_of(line);
        const bool goes_on = corners.front()[0] == last;
        if (!goes_on)
            out.emplace_back();
        for (const ObjCorner& corner : corners.subspan(goes_on ? 1 : 0)) {
            const Vec3 p(obj.positions[std::size_t(corner[0])]);
            if (out.back().empty() || out.back().back() != p)
                out.back().push_back(p);
        }
        last = corners.back()[0];
    }
    std::erase_if(out, [](const auto& points) { return points.size() < 2; });
    return out;
}

Strands strands_of(const Obj& obj, float radius, CurveKind kind) {
    Strands strands;
    strands.kind = kind;
    strands.offsets.push_back(0);
    for (const std::vector<Vec3>& points : lines_of(obj)) {
        const std::vector<float> radii(points.size(), radius);
        if (kind == CurveKind::bspline) {
            add_spline(strands, points, radii);
            continue;
        }
        strands.points.insert(strands.points.end(), points.begin(), points.end());
        strands.radii.insert(strands.radii.end(), radii.begin(), radii.end());
        strands.offsets.push_back(static_cast<std::uint32_t>(strands.points.size()));
    }
    if (strands.count() == 0)
        throw Error("it has no lines (l)");
    return strands;
}

void append(Strands& strands, const Strands& more) {
    const auto first = static_cast<std::uint32_t>(strands.points.size());
    strands.points.insert(strands.points.end(), more.points.begin(), more.points.end());
    strands.radii.insert(strands.radii.end(), more.radii.begin(), more.radii.end());
    for (std::size_t i = 1; i < more.offsets.size(); ++i)
        strands.offsets.push_back(first + more.offsets[i]);
}

Strands strands_of(const std::vector<Aggregate>& aggregates) {
    Strands strands;
    strands.offsets.push_back(0);
    for (const Aggregate& aggregate : aggregates)
        for (const Prototype& prototype : aggregate.prototypes)
            if (const Strands* more = prototype.strands()) {
                if (strands.count() > 0 && more->kind != strands.kind)
                    throw Error("it has linear strands and bsplines; a curve is of one kind");
                strands.kind = more->kind;
                append(strands, *more);
            }
    if (strands.count() == 0)
        throw Error("it has no strands");
    return strands;
}

Strands read(const Params& params) {
    const std::string& path = params.text("path");
    const std::string ending = extension(path);
    const std::string bytes = read_file(path);
    try {
        if (ending == "json")
            return strands_of(read_bake_json(bytes, path));
        if (ending == "obj")
            return strands_of(parse_obj(bytes), static_cast<float>(params.number("radius")),
                              params.text("curve") == "linear" ? CurveKind::linear
                                                               : CurveKind::bspline);
    } catch (const Error& problem) {
        const Diagnostic& what = problem.diagnostics().front();
        throw Error(
            fmt::format("{}: {}{}{}", path, what.path, what.path.empty() ? "" : " ", what.message));
    }
    throw Error(path + ": is not a file of curves; expected .obj or .json");
}

Strands make(const Params& params) {
    Strands strands = located(params, "path", [&] { return read(params); });
    strands.name = file_name(params.text("path"));
    for (std::size_t i = 0; i < strands.count(); ++i) {
        const Vec3* points = &strands.points[strands.offsets[i]];
        const Vec3 side = points[1] - points[0];
        strands.normals.push_back(Frame(side.length() > 0 ? side.normalized() : Vec3(0, 1, 0)).x);
        strands.randoms.push_back(Random(0, Purpose::mesh_shape, i).uniform_float());
    }
    return strands;
}

} // namespace

Registry<Strands(const Params& params)> curve_file_table() {
    Registry<Strands(const Params& params)> table("curve");
    table.add({
        "file",
        "Strands read from the lines of an OBJ file, or from a scene baked to JSON.",
        {{.name = "path", .type = ParamType::path, .doc = "The file: .obj or .json."},
         {.name = "radius",
          .type = ParamType::number,
          .doc = "Of all strands of an OBJ file, which has none.",
          .unit = "m",
          .fallback = 0.001,
          .min = 0.0,
          .max = 1e6,
          .above_min = true},
         {.name = "curve",
          .type = ParamType::choice,
          .doc = "Whether the points of an OBJ file are joined by straight lines or by splines.",
          .fallback = std::string("linear"),
          .choices = {"linear", "bspline"}}},
        make,
    });
    return table;
}

} // namespace scree
