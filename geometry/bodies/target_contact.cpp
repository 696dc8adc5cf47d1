// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/target_contact.h"

#include "core/parallel.h"

#include <algorithm>
#include <atomic>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

constexpr double least_piece = 0.02; // of a triangle, in radii of a component

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

// A signed distance is 1-Lipschitz.
bool touches(const Piece& piece, const PileComponent& component, const Pose& pose,
             double tolerance) {
    const Vec3d middle = piece.middle();
    const Vec3 local = Vec3(middle - pose.centre) * pose.world_from_component.transposed();
    const double gap = double(component.distance.at(local)) - tolerance * component.radius;
    const double radius = piece.radius();
    if (gap <= 0)
        return true;
    if (gap > radius || radius < least_piece * component.radius)
        return false;
    const std::array<Piece, 2> halves = piece.halves();
    return touches(halves[0], component, pose, tolerance) ||
           touches(halves[1], component, pose, tolerance);
}

class TargetContact {
  public:
    TargetContact(const Pile& pile, double tolerance)
        : pile_(pile), tolerance_(tolerance), touching_(pile.all.size()) {
        for (const PileKind& kind : pile.kinds)
            reach_ = std::max(reach_, kind.component.reach);
        for (const Placed& placed : pile.all) {
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
        pile_.hash.near(middle, radius + tolerance_ * reach_, [&](std::uint32_t i) {
            const Placed& placed = pile_.all[i];
            if (!touching_[i].load(std::memory_order_relaxed) &&
                touches(piece, pile_.component(placed), placed.pose, tolerance_))
                touching_[i].store(true, std::memory_order_relaxed);
        });
    }

    std::vector<char> result() const { return {touching_.begin(), touching_.end()}; }

  private:
    const Pile& pile_;
    double tolerance_;
    double reach_ = 0;
    Imath::Box3d box_;
    std::vector<std::atomic<bool>> touching_;
};

} // namespace

std::vector<char> touching_target(const Pile& pile, const Mesh& target, double tolerance) {
    TargetContact contact(pile, tolerance);
    parallel_for(target.triangles.size(), 256, [&](std::size_t t) {
        Piece piece;
        for (std::size_t k = 0; k < 3; ++k)
            piece.corners[k] = Vec3d(target.positions[target.triangles[t][k]]);
        contact.look(piece);
    });
    return contact.result();
}

} // namespace scree
