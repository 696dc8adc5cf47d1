// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/target_contact.h"

#include "core/parallel.h"

#include <algorithm>
#include <atomic>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

constexpr double least_piece = 0.02; // radius of a piece, in radii of a body

/// A triangle of the target or a part of one.
struct Piece {
    std::array<Vec3d, 3> corners;

    Vec3d middle() const { return (corners[0] + corners[1] + corners[2]) / 3; }
    double radius() const {
        const Vec3d m = middle();
        double r2 = 0;
        for (const Vec3d& c : corners)
            r2 = std::max(r2, (c - m).length2());
        return std::sqrt(r2);
    }
    /// Split in the middle of its longest side.
    std::array<Piece, 2> halves() const {
        std::size_t longest = 0;
        const auto side2 = [&](std::size_t k) {
            return (corners[(k + 1) % 3] - corners[k]).length2();
        };
        for (std::size_t k = 1; k < 3; ++k)
            if (side2(k) > side2(longest))
                longest = k;
        const Vec3d& a = corners[longest];
        const Vec3d& b = corners[(longest + 1) % 3];
        const Vec3d& c = corners[(longest + 2) % 3];
        const Vec3d m = (a + b) * 0.5;
        return {Piece{{a, m, c}}, Piece{{m, b, c}}};
    }
};

// Halves the piece until the distance at its middle decides: it changes no faster than the point
// moves.
bool touches(const Piece& piece, const Body& body, const Pose& pose, double tolerance) {
    const Vec3d middle = piece.middle();
    const Vec3 local = Vec3(middle - pose.centre) * pose.world_from_body.transposed();
    const double gap = double(body.distance.at(local)) - tolerance * body.radius;
    const double radius = piece.radius();
    if (gap <= 0)
        return true;
    if (gap > radius || radius < least_piece * body.radius)
        return false;
    const std::array<Piece, 2> halves = piece.halves();
    return touches(halves[0], body, pose, tolerance) || touches(halves[1], body, pose, tolerance);
}

class TargetContact {
  public:
    TargetContact(const PlacedBodies& bodies, double tolerance)
        : bodies_(bodies), tolerance_(tolerance), reach_(largest_reach(bodies.shapes)),
          touching_(bodies.all.size()) {
        for (const PlacedBody& placed : bodies.all) {
            box_.extendBy(placed.pose.centre - Vec3d(2 * reach_));
            box_.extendBy(placed.pose.centre + Vec3d(2 * reach_));
        }
    }

    void look(const Piece& piece) {
        const Vec3d middle = piece.middle();
        const double radius = piece.radius();
        Imath::Box3d near = box_;
        near.min -= Vec3d(radius);
        near.max += Vec3d(radius);
        if (box_.isEmpty() || !near.intersects(middle))
            return;
        if (radius > 2 * reach_) {
            for (const Piece& half : piece.halves())
                look(half);
            return;
        }
        bodies_.hash.near(middle, radius + tolerance_ * reach_, [&](std::uint32_t i) {
            const PlacedBody& placed = bodies_.all[i];
            if (!touching_[i].load(std::memory_order_relaxed) &&
                touches(piece, bodies_.body(placed), placed.pose, tolerance_))
                touching_[i].store(true, std::memory_order_relaxed);
        });
    }

    std::vector<char> result() const { return {touching_.begin(), touching_.end()}; }

  private:
    const PlacedBodies& bodies_;
    double tolerance_;
    double reach_; // of the largest body [m]
    Imath::Box3d box_;
    std::vector<std::atomic<bool>> touching_;
};

} // namespace

std::vector<char> touching_target(const PlacedBodies& bodies, const Mesh& target,
                                  double tolerance) {
    TargetContact contact(bodies, tolerance);
    parallel_for(target.triangles.size(), 256, [&](std::size_t t) {
        Piece piece;
        for (std::size_t k = 0; k < 3; ++k)
            piece.corners[k] = Vec3d(target.positions[target.triangles[t][k]]);
        contact.look(piece);
    });
    return contact.result();
}

} // namespace scree
