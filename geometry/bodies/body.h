// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/ball_tree.h"
#include "geometry/mesh/mesh.h"

#include <functional>
#include <memory>

namespace scree {

/// A rigid body made of a closed mesh or of a sheet of some thickness, with what contacts are found
/// by. All but the mesh is in the body's own frame: that of the mesh, moved so that its origin is
/// the centre of the largest inner ball; of a sheet that of the bounding box.
struct Body {
    std::shared_ptr<const Mesh> mesh;
    Vec3 origin;       // of the own frame, in the mesh's [m]
    double radius = 0; // of the largest inner ball [m]; of a sheet half its thickness
    double reach = 0;  // from the origin to the farthest point of the surface [m]
    double skin = 0;   // from the mesh to the surface: half the thickness of a sheet, or 0 [m]
    SignedDistanceGrid distance;
    std::vector<Ball> balls; // at most 30 that fill the inside except near corners
    BallTree probe; // balls that fill the inside to 1% of the radius; where they cannot, as at
                    // sharp edges, points of the surface, as balls of radius 0
    bool probe_fills = true; // the probe has no such points
    BallTree samples; // to measure with: dense points of the mesh and the balls' centres, radius 0
};

/// Bodies of several shapes; placed bodies name theirs by its number here.
using Bodies = std::vector<std::shared_ptr<const Body>>;

/// A body of which origin, radius, reach and skin are known, which is enough to look for sites.
/// `complete()` makes the rest; it throws no user's error and is to be called once.
struct BodyDraft {
    std::shared_ptr<Body> body;
    std::function<void()> complete;
};

/// Throws Error for a mesh without area or with numbers that are not finite and, unless it is a
/// sheet with a thickness [m], for one that is not closed (with the counts of bad edges).
void check_body(const Mesh& mesh, double thickness = 0);

/// Begins a body from a closed mesh, or, with `thickness` > 0 [m], from any mesh as a sheet. Throws
/// Error as `check_body`, and for a closed mesh that encloses nothing.
BodyDraft draft_body(std::shared_ptr<const Mesh> mesh, double thickness = 0);

/// The whole body at once. Throws as `draft_body`.
std::shared_ptr<const Body> make_body(std::shared_ptr<const Mesh> mesh, double thickness = 0);

} // namespace scree
