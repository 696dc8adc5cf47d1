// SPDX-License-Identifier: GPL-3.0-or-later
// curve.file: strands from a baked file or the lines of an OBJ file.
#include "core/file.h"
#include "core/frame.h"
#include "core/located.h"
#include "core/random.h"
#include "formats/file_placement.h"
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

/// Puts the file's name, and the place in it, before what `work` throws.
template <class Work>
auto named(const std::string& path, const Work& work) {
    try {
        return work();
    } catch (const Error& problem) {
        const Diagnostic& what = problem.diagnostics().front();
        const std::string line =
            what.where.line > 0 ? fmt::format("line {}: ", what.where.line) : "";
        throw Error(fmt::format("{}: {}{}{}{}", path, line, what.path, what.path.empty() ? "" : " ",
                                what.message));
    }
}

Strands read_baked(const Params& params, const std::string& path, const std::string& bytes) {
    Strands strands = named(path, [&] { return strands_of(read_bake_json(bytes, path)); });
    Imath::Box3d box;
    for (const Vec3& p : strands.points)
        box.extendBy(Imath::V3d(p));
    const FilePlacement placement(params, box, "a baked scene is in metres");
    for (Vec3& p : strands.points)
        p = Vec3(placement(Imath::V3d(p)));
    for (float& radius : strands.radii)
        radius = static_cast<float>(radius * placement.scale());
    return strands;
}

Strands read_lines(const Params& params, const std::string& path, const std::string& bytes) {
    Obj obj = named(path, [&] { return parse_obj(bytes); });
    bool unit_unknown = false;
    Imath::Box3d box; // of what the lines use
    for (const Obj::Face& line : obj.lines)
        for (const ObjCorner& corner : obj.corners_of(line))
            box.extendBy(obj.positions[std::size_t(corner[0])]);
    if (!box.isEmpty()) {
        const FilePlacement placement(params, box, "");
        unit_unknown = placement.unit_unknown();
        for (Imath::V3d& p : obj.positions)
            p = placement(p);
    }
    const bool linear = params.text("curve") == "linear";
    Strands strands = named(path, [&] {
        return strands_of(obj, static_cast<float>(params.number("radius")),
                          linear ? CurveKind::linear : CurveKind::bspline);
    });
    strands.unit_unknown = unit_unknown;
    return strands;
}

Strands read(const Params& params) {
    const std::string& path = params.text("path");
    const std::string ending = extension(path);
    const std::string bytes = read_file(path);
    if (ending == "json")
        return read_baked(params, path, bytes);
    if (ending == "obj")
        return read_lines(params, path, bytes);
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
    std::vector<ParamSpec> specs{
        {.name = "path", .type = ParamType::path, .doc = "The file: .obj or .json."}};
    for (ParamSpec& spec : placement_specs("A baked scene is always in metres."))
        specs.push_back(std::move(spec));
    specs.push_back({.name = "radius",
                     .type = ParamType::number,
                     .doc = "Of all strands of an OBJ file, which has none; in metres, whatever "
                            "`unit` and `size` are.",
                     .unit = "m",
                     .fallback = 0.001,
                     .min = 0.0,
                     .max = 1e6,
                     .above_min = true});
    specs.push_back(
        {.name = "curve",
         .type = ParamType::choice,
         .doc = "Whether the points of an OBJ file are joined by straight lines or by splines.",
         .fallback = std::string("linear"),
         .choices = {"linear", "bspline"}});
    Registry<Strands(const Params& params)> table("curve");
    table.add({"file", "Strands read from the lines of an OBJ file, or from a scene baked to JSON.",
               std::move(specs), make});
    return table;
}

} // namespace scree
