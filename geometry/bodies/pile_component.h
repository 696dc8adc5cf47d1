// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/ball_tree.h"
#include "model/aggregate.h"

#include <functional>

namespace scree {

/// A component made ready to be piled. Its own frame, in which all but the prototype is, is that
/// of the mesh with the centre of its largest inner ball for origin.
struct PileComponent {
    Prototype prototype;
    Vec3 origin;                    // in the mesh's frame [m]
    double radius = 0;              // of the largest inner ball [m]; of a sheet half its thickness
    double distribution_radius = 0; // half of that; of a sheet a quarter of its round equal's
    double reach = 0;               // of the farthest vertex from the origin [m]
    double skin = 0;                // from the mesh to the solid's surface: of a sheet [m]
    SignedDistanceGrid distance;
    std::vector<Ball> balls; // some 30 at most that fill the inside but for its corners
    BallTree probe;          // fills the inside to 1% of the radius; radius 0: on the surface
    bool probe_fills = true; // without such points: whatever reaches in meets a ball
    BallTree samples; // to measure with: dense on the mesh and at the balls' centres, radius 0
};

/// A component whose size is known, which is enough to find sites for it. `complete()`, which
/// throws no user's error, makes the rest: its distance, balls, probe and samples.
struct ComponentDraft {
    PileComponent component;
    std::function<void(PileComponent&)> complete;
};

/// Begins with a closed mesh, or, with `thickness` [m] > 0, with one as a sheet. Throws Error for a
/// mesh without area or with numbers that are not finite, and for one to be closed that has edges
/// without or with too many neighbours, with their counts, or no inside.
ComponentDraft draft_component(Prototype prototype, double thickness = 0);

/// The whole component at once. Throws as `draft_component`.
PileComponent prepare_component(Prototype prototype, double thickness = 0);

} // namespace scree
