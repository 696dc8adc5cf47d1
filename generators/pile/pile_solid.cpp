// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_solid.h"

#include <fmt/format.h>

namespace scree {

void check_closed_target(const Params& params, const char* for_what) {
    const MeshFacts facts = inspect(*params.object<Mesh>("target"));
    if (!facts.closed())
        throw params.error(
            "target",
            fmt::format("the mesh is not closed: {} boundary edges, {} edges where triangles do "
                        "not meet in twos or disagree on what is outside",
                        facts.boundary_edges, facts.non_manifold_edges),
            fmt::format("expected a closed mesh for {}", for_what));
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
    SolidFill fill{.cover = params.number("cover")};
    if (params.has("shells"))
        fill.shells = static_cast<std::size_t>(params.integer("shells"));
    return fill;
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

Pile cut_open(const Pile& pile, const CutPlane& plane) {
    Pile kept(pile.kinds);
    for (const Placed& placed : pile.all)
        if ((placed.pose.centre - plane.point).dot(plane.normal) <= 0)
            kept.add(placed);
    return kept;
}

} // namespace scree
