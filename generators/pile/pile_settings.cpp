// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_settings.h"

#include "generators/pile/flow_settings.h"
#include "geometry/mesh/not_closed.h"

#include <fmt/format.h>

namespace scree {

namespace {

void check_closed_target(const Params& params, const char* for_what) {
    const MeshFacts facts = inspect(*params.object<Mesh>("target"));
    if (!facts.closed())
        throw params.error("target", not_closed(facts),
                           fmt::format("expected a closed mesh for {}", for_what));
}

// Hides about all that can be seen from outside.
constexpr double default_cover = 0.99;

double cover_of(const Params& params) {
    return params.has("cover") ? params.number("cover") : default_cover;
}

std::optional<SolidFill> solid_fill(const Params& params) {
    if (params.text("fill") != "solid") {
        if (params.has("shells"))
            throw params.error("shells", "is given, but only the surface is covered",
                               "expected fill = \"solid\" beside it");
        return {};
    }
    if (params.text("method") == "thesis")
        throw params.error("fill", "is \"solid\", but the thesis's method covers surfaces only",
                           "expected method = \"insertion\" or \"relax\" beside it");
    check_closed_target(params, "fill = \"solid\"");
    SolidFill fill{.cover = cover_of(params)};
    if (params.has("shells"))
        fill.shells = static_cast<std::size_t>(params.integer("shells"));
    return fill;
}

std::optional<RelaxSettings> relax_settings(const Params& params) {
    if (params.text("method") != "relax") {
        for (const char* name : {"iterations", "density"})
            if (params.has(name))
                throw params.error(name, "is a parameter of relaxation",
                                   "expected method = \"relax\" beside it");
        return {};
    }
    for (const char* name : {"removal", "shells"})
        if (params.has(name))
            throw params.error(name, "is no parameter of relaxation");
    if (params.number("sink") > 0)
        throw params.error("sink", "is no parameter of relaxation");
    check_closed_target(params, "method = \"relax\"");
    RelaxSettings settings{.solid = params.text("fill") == "solid",
                           .overlap = params.number("overlap")};
    if (params.has("iterations"))
        settings.iterations = static_cast<int>(params.integer("iterations"));
    if (params.has("density"))
        settings.density = params.number("density");
    return settings;
}

// Nothing: components stay where they came free.
std::optional<SettleSettings> settle_settings(const Params& params) {
    const auto steps = static_cast<int>(params.integer("settle"));
    if (steps == 0)
        return {};
    if (params.text("method") != "insertion" || params.text("fill") != "surface")
        throw params.error("settle", "is for what is inserted on a surface",
                           "expected method = \"insertion\" and fill = \"surface\" beside it");
    SettleSettings settings{
        .steps = steps, .sink = params.number("sink"), .overlap = params.number("overlap")};
    if (params.has("settle_turn"))
        settings.turn = params.number("settle_turn");
    else if (params.text("frame") != "surface")
        settings.turn = 0;
    return settings;
}

std::optional<OrientationFlow> flow_of(const Params& params) {
    const bool follows = params.text("frame") == "flow";
    if (follows && !params.has("flow"))
        throw params.error("frame", "is \"flow\", but there is none",
                           "expected flow = { ... } beside it");
    if (!follows && params.has("flow"))
        throw params.error("flow", "is given, but nothing follows it",
                           "expected frame = \"flow\" beside it");
    if (!follows)
        return {};
    return orientation_flow(params.record("flow"));
}

std::optional<CutPlane> cut_plane(const Params& params) {
    if (!params.has("cut"))
        return {};
    const Params& cut = params.record("cut");
    const CutPlane plane{.point = Imath::V3d(cut.vector3("point")),
                         .normal = Imath::V3d(cut.vector3("normal"))};
    if (!(plane.normal.length() > 0))
        throw cut.error("normal", "is no direction", "expected a vector that is not zero");
    return plane;
}

std::optional<ThesisSettings> thesis_settings(const Params& params) {
    if (params.text("method") != "thesis") {
        if (params.has("removal"))
            throw params.error("removal", "is a parameter of the thesis's method",
                               "expected method = \"thesis\" beside it");
        return {};
    }
    if (params.number("sink") > 0)
        throw params.error("sink", "is no parameter of the thesis's method");
    if (params.has("cover") && params.number("cover") > 0)
        throw params.error("cover", "is no parameter of the thesis's method",
                           "expected method = \"insertion\", which goes on where it still shows");
    ThesisSettings settings{.overlap = params.number("overlap"), .removal = {}};
    if (params.has("removal"))
        settings.removal = params.number("removal");
    return settings;
}

SupportSettings support_settings(const Params& params) {
    const std::string& check = params.text("support");
    SupportSettings settings{.check = check == "report"   ? SupportCheck::report
                                      : check == "remove" ? SupportCheck::remove
                                                          : SupportCheck::none,
                             .adhesive = params.flag("adhesive"),
                             .floor = {},
                             .contact = params.number("contact")};
    if (params.has("floor")) {
        settings.floor = params.number("floor");
        if (settings.check == SupportCheck::none)
            params.warn("floor", "keeps nothing above it: without support it is not looked at",
                        "support = \"remove\" takes away what nothing holds up");
    }
    return settings;
}

} // namespace

PileSettings pile_settings(const Params& params) {
    PileSettings settings;
    settings.target = params.object<Mesh>("target");
    settings.target_place = params.place("target");
    settings.position = params.point3("position");
    settings.turn = params.number("turn");
    settings.solid = solid_fill(params);
    settings.relaxation = relax_settings(params);
    settings.settling = settle_settings(params);
    settings.flow = flow_of(params);
    settings.cut = cut_plane(params);
    settings.thesis = thesis_settings(params);
    settings.insertion = {.overlap = params.number("overlap"), .sink = params.number("sink")};
    settings.components = component_settings(params);
    settings.frame = params.text("frame") == "global" ? PileFrame::global : PileFrame::surface;
    settings.cover = cover_of(params);
    if (params.has("cover"))
        settings.warn_of_cover = [params](std::string message) {
            params.warn("cover", std::move(message),
                        "components that are smaller or stand closer (spacing) hide more");
        };
    settings.support = support_settings(params);
    settings.measure = static_cast<std::size_t>(params.integer("measure"));
    settings.seed = static_cast<std::uint64_t>(params.integer("seed"));
    return settings;
}

} // namespace scree
