// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/region/svg_regions.h"

#include "core/located.h"
#include "geometry/plane/region_tools.h"
#include "geometry/plane/svg/svg_document.h"
#include "geometry/plane/svg/svg_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

// A layout of a region with more points would take minutes; usual drawings have hundreds.
constexpr std::size_t max_svg_points = 200'000;

double longest_side(const Box2& box) {
    if (box.isEmpty())
        return 0;
    return std::max(box.size().x, box.size().y);
}

/// Flattens shapes within `tolerance`; counts their points.
std::vector<FilledRings> flattened(const std::vector<SvgShape>& shapes, double tolerance,
                                   std::size_t& points) {
    std::vector<FilledRings> out;
    out.reserve(shapes.size());
    for (const SvgShape& shape : shapes)
        out.push_back(
            {shape.path.flatten(tolerance, points, max_svg_points), shape.rule, shape.within});
    if (points > max_svg_points)
        throw Error(
            fmt::format("has more than {} points; give a larger tolerance", max_svg_points));
    return out;
}

Region filled(const SvgDrawing& drawing, double tolerance) {
    std::size_t points = 0;
    std::vector<FilledRings> shapes = flattened(drawing.shapes, tolerance, points);
    Clips clips;
    clips.reserve(drawing.clips.size());
    for (const std::vector<SvgShape>& clip : drawing.clips)
        clips.push_back(flattened(clip, tolerance, points));
    return fill(std::move(shapes), clips);
}

/// The union of the shapes in the drawing's units. Curves are flattened with an error of at most
/// `tolerance` times the longest side.
Region drawn(const SvgDrawing& drawing, double tolerance) {
    Box2 control;
    for (const SvgShape& shape : drawing.shapes)
        control.extendBy(shape.path.control_box());
    const double longest = longest_side(control);
    if (!(longest > 0))
        throw Error("draws nothing that is filled");
    Region region = filled(drawing, tolerance * longest);
    // The bounds of the control points may be much larger than those of what is seen.
    const double drawn_longest = longest_side(bounds(region));
    if (drawn_longest > 0.999 * longest)
        return region;
    return filled(drawing, tolerance * drawn_longest);
}

/// The region in metres, placed according to the parameters size, scale and centred.
Region placed(const Params& params, const Region& region, double usual_size) {
    if (params.has("size") && params.has("scale"))
        throw params.error("scale", "stands beside size, which also says how large it is",
                           "leave one of them out");
    const Box2 box = bounds(region);
    const double longest = longest_side(box);
    double scale = usual_size > 0 ? usual_size / longest : 1;
    if (params.has("size"))
        scale = params.number("size") / longest;
    if (params.has("scale"))
        scale = params.number("scale");
    if (!(scale * longest < 1e7))
        throw params.error("scale",
                           fmt::format("makes the region {:.6g} m large", scale * longest));
    const Vec2 origin = params.flag("centred") ? box.center() : Vec2(0.0);
    std::vector<Ring> rings = region.rings;
    for (Ring& ring : rings)
        for (Vec2& v : ring)
            v = (v - origin) * scale;
    return fill({{std::move(rings), FillRule::nonzero}}); // rounding may make edges touch
}

std::vector<ParamSpec> with_size(std::vector<ParamSpec> params, std::string scale_doc) {
    params.push_back({.name = "size",
                      .type = ParamType::number,
                      .doc = "Longest side of the filled area.",
                      .unit = "m",
                      .optional = true,
                      .min = 1e-6,
                      .max = 1e6});
    params.push_back({.name = "scale",
                      .type = ParamType::number,
                      .doc = std::move(scale_doc),
                      .unit = "m",
                      .optional = true,
                      .min = 1e-9,
                      .max = 1e6});
    params.push_back({.name = "centred",
                      .type = ParamType::boolean,
                      .doc = "Moves the middle of the bounding box to the origin.",
                      .fallback = true});
    params.push_back({.name = "tolerance",
                      .type = ParamType::number,
                      .doc =
                          "Maximum distance of an edge from its curve, as a share of the longest "
                          "side.",
                      .fallback = 0.001,
                      .min = 1e-5,
                      .max = 0.1});
    return params;
}

Region svg(const Params& params) {
    const std::string element = params.has("element") ? params.text("element") : std::string();
    const Warn warn = [&](const std::string& message) { params.warn("path", message); };
    const SvgDrawing drawing =
        located(params, "path", [&] { return read_svg(params.text("path"), element, warn); });
    const Region region = located(params, "path", [&] {
        try {
            return drawn(drawing, params.number("tolerance"));
        } catch (const Error& error) {
            throw Error(params.text("path") + ": " + error.diagnostics().front().message);
        }
    });
    return placed(params, region, 1.0);
}

Region path(const Params& params) {
    const FillRule rule =
        params.text("fill_rule") == "evenodd" ? FillRule::evenodd : FillRule::nonzero;
    const Region region = located(params, "d", [&] {
        return drawn({{{parse_path_data(params.text("d")), rule, {}}}, {}},
                     params.number("tolerance"));
    });
    return placed(params, region, 0);
}

} // namespace

Plugin<MakeRegion> svg_region_plugin() {
    return {"svg",
            "What an SVG drawing fills and shows: its paths and basic shapes; its y, which points "
            "down, "
            "becomes z.",
            with_size({{.name = "path", .type = ParamType::path, .doc = "An SVG file."},
                       {.name = "element",
                        .type = ParamType::text,
                        .doc = "The id of the only element to take, with its children.",
                        .optional = true}},
                      "Metres per pixel (1/96 inch) of the drawing; without it and size, the "
                      "longest side is 1 m."),
            svg};
}

Plugin<MakeRegion> path_region_plugin() {
    return {
        "path", "What a path in the language of SVG's d attribute fills.",
        with_size({{.name = "d", .type = ParamType::text, .doc = "The path: \"M0 0 L1 0 L1 1 Z\"."},
                   {.name = "fill_rule",
                    .type = ParamType::choice,
                    .doc = "Which parts of a path that crosses itself are inside.",
                    .fallback = std::string("nonzero"),
                    .choices = {"nonzero", "evenodd"}}},
                  "Metres per unit of the path; 1 when neither it nor size is given."),
        path};
}

} // namespace scree
