// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/exact_contact.h"

#include <functional>

namespace scree::rocks {

/// How rocks come to rest.
struct RestSettings {
    double burial = 0.15;   // how much of its height a rock sinks into the ground
    bool keep_turn = false; // only turns as far as it must to be held, as where water has packed it
};

/// Whether a rock's centre may be over a place.
using MayBe = std::function<bool(const Vec2& place)>;

/// A rock on its way down: it is moved and turned, each step towards a lower centre of mass, until
/// it can rest where it is.
class RestingRock {
  public:
    RestingRock(const Neighbourhood& around, const RestSettings& settings)
        : around_(around), settings_(settings) {}

    /// Takes another rock, with its longest axis `2 * scale` [m] long.
    void take(const RockSurface& surface, double scale, const Imath::M33d& world_from_rock);

    /// Where its centre would rest over a cell of the map, by the map alone; no more than known to
    /// be above `enough` [m].
    double rest(int column, int row, double enough = std::numeric_limits<double>::max()) const;

    /// Where it begins to fall.
    void hang_over(int column, int row);

    /// Lets it slide to a lower place nearby, and turn, until it can rest. False if it cannot in
    /// the end.
    bool settle(const MayBe& may_be);

    const Imath::M33d& world_from_rock() const { return pose_.turn; }
    const WideVec3& centre() const { return pose_.centre; } // of mass [m]

    /// The rocks that hold it.
    const std::vector<std::uint32_t>& held_by() const { return held_by_; }

    /// Relative to the centre of mass [m].
    const std::vector<Vec3>& vertices() const { return pose_.vertices; }

  private:
    struct Pose {
        Imath::M33d turn;
        WideVec3 centre{0, 0, 0};   // [m]
        std::vector<Vec3> vertices; // relative to it [m]
    };

    void pose(const Imath::M33d& turn, const WideVec3& centre, Pose& out) const;
    void lower(Pose& pose, std::vector<Gap>& gaps);
    bool slide_by_map(const MayBe& may_be);
    Imath::M33d turn_by_map(double height);
    bool slide(const MayBe& may_be);
    bool stands_in_ground() const;
    bool is_held();
    void take_next();

    const Neighbourhood& around_;
    RestSettings settings_;
    const RockSurface* surface_ = nullptr;
    double scale_ = 1;
    double reach_ = 0; // from the centre of mass to the farthest vertex [m]
    double sink_ = 0;  // [m]
    Footprint under_;  // as it was taken
    int column_ = 0;   // of the map's cell that its centre is over before it settles
    int row_ = 0;
    Pose pose_;
    Pose next_;
    std::vector<Gap> gaps_;
    std::vector<Gap> next_gaps_;
    std::vector<Gap> touching_;
    std::vector<std::uint32_t> held_by_;
    Surroundings tops_;
    ExactContact contact_;
};

} // namespace scree::rocks
