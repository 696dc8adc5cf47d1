// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/resting_rock.h"

#include "generators/rocks/friction_hold.h"

#include <algorithm>
#include <limits>

namespace scree::rocks {

namespace {

// Lengths are in halves of the longest axis.
constexpr double steepest_turn = 0.5; // of one step, as a slope
constexpr double least_turn = 2e-3;
constexpr int most_steps = 10;
constexpr double least_drop = 3e-4;      // of a step that is worth taking
constexpr double at_rest_drop = 0.05;    // of the next step, when a rock is as good as at rest
constexpr double held_within = 0.006;    // contacts that hold are as near as this: 0.003 D
constexpr double wide_gap = 0.08;        // gaps so much wider than the least hardly matter
constexpr double gathered_around = 0.35; // a rock's reach: its surroundings
constexpr double wide_map_gap = 0.3;
constexpr double map_slide = 0.5; // the longest step by the map
constexpr double least_map_drop = 0.02;
constexpr int most_map_slides = 16;
constexpr double longest_slide = 0.15; // of one step
constexpr int most_slides = 2;

/// The rotation by which the rock follows a plane down.
Rotation following(const LoweringPlane& plane) {
    return Rotation(WideVec3(std::atan(plane.slope_z), 0, -std::atan(plane.slope_x)));
}

} // namespace

void RestingRock::pose(const Imath::M33d& turn, const WideVec3& centre, Pose& out) const {
    out.turn = turn;
    out.centre = centre;
    pose_vertices(*surface_, turn, scale_, out.vertices);
}

void RestingRock::take(const RockSurface& surface, double scale, const Imath::M33d& turn) {
    surface_ = &surface;
    scale_ = scale;
    reach_ = double(surface.reach) * scale;
    pose(turn, {0, 0, 0}, pose_);
    rasterise(pose_.vertices, surface.triangles, around_.map.cell(), Side::under, under_);
    const auto [low, high] =
        std::minmax_element(pose_.vertices.begin(), pose_.vertices.end(),
                            [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
    sink_ = settings_.burial * double(high->y - low->y);
}

double RestingRock::rest(int column, int row, double enough) const {
    return around_.map.rest(under_, column, row, sink_, enough);
}

void RestingRock::lower(Pose& pose, std::vector<Gap>& gaps) {
    if (!tops_.covers({pose.centre.x, pose.centre.z}, reach_))
        tops_.gather(around_, pose.centre, reach_ + gathered_around * scale_, sink_);
    gaps = contact_.gaps({.vertices = pose.vertices,
                          .triangles = surface_->triangles,
                          .centre = pose.centre,
                          .sink = sink_},
                         tops_, around_.ground, wide_gap * scale_);
    double least = std::numeric_limits<double>::max();
    for (const Gap& gap : gaps)
        least = std::min(least, gap.height);
    pose.centre.y -= least;
    for (Gap& gap : gaps)
        gap.height -= least;
}

bool RestingRock::slide_by_map(const MayBe& may_be) {
    double best = rest(column_, row_) - least_map_drop * scale_;
    std::pair<int, int> step{0, 0};
    for (const double share : {map_slide, map_slide / 4}) {
        const int far = std::max(1, static_cast<int>(share * scale_ / around_.map.cell()));
        for (int z = -far; z <= far; z += far)
            for (int x = -far; x <= far; x += far) {
                const double height = rest(column_ + x, row_ + z, best);
                if (height < best && may_be(around_.map.place(column_ + x, row_ + z))) {
                    best = height;
                    step = {x, z};
                }
            }
    }
    column_ += step.first;
    row_ += step.second;
    return step != std::pair(0, 0);
}

Imath::M33d RestingRock::turn_by_map(double height) {
    gaps_.clear();
    const double cell = around_.map.cell();
    around_.map.each_under(under_, column_, row_, sink_, [&](std::size_t k, float below) {
        const double gap = height + double(under_.heights[k]) - double(below);
        const auto width = std::size_t(under_.width);
        if (gap < wide_map_gap * scale_)
            gaps_.push_back({.x = cell * (under_.first_x + int(k % width)),
                             .z = cell * (under_.first_z + int(k / width)),
                             .height = gap});
    });
    return turned(pose_.turn, following(lowering_plane(gaps_, reach_, steepest_turn)));
}

void RestingRock::take_next() {
    std::swap(pose_, next_);
    std::swap(gaps_, next_gaps_);
}

bool RestingRock::slide(const MayBe& may_be) {
    // A step to the side changes each gap by its slope: how far down it leads is the same problem
    // as that of turning, with slopes in the place of levers.
    std::vector<Gap> slopes = gaps_;
    for (Gap& gap : slopes) {
        const double up = std::max(gap.normal.y, 0.05);
        gap.x = gap.normal.x / up;
        gap.z = gap.normal.z / up;
    }
    for (const double share : {1.0, 1.0 / 3, 1.0 / 9}) {
        const LoweringPlane plane = lowering_plane(slopes, 1, share * longest_slide * scale_);
        if (plane.height < least_drop * scale_)
            return false;
        pose(pose_.turn, pose_.centre - WideVec3(plane.slope_x, 0, plane.slope_z), next_);
        if (!may_be({next_.centre.x, next_.centre.z}))
            return false;
        lower(next_, next_gaps_);
        if (next_.centre.y < pose_.centre.y) {
            take_next();
            return true;
        }
    }
    return false;
}

bool RestingRock::stands_in_ground() const {
    // The part of the underside that is in the ground must surround the centre of mass.
    constexpr int directions = 16;
    std::array<double, directions> farthest;
    farthest.fill(-1);
    const Vec2 middle(pose_.centre.x, pose_.centre.z);
    for (const Vec3& v : pose_.vertices) {
        const Vec2 at(double(v.x), double(v.z));
        if (pose_.centre.y + double(v.y) > around_.ground.height(middle + at))
            continue;
        for (int i = 0; i < directions; ++i)
            farthest[std::size_t(i)] =
                std::max(farthest[std::size_t(i)], rotate(at, 2 * pi * i / directions).x);
    }
    return std::all_of(farthest.begin(), farthest.end(),
                       [&](double far) { return far > 0.02 * scale_; });
}

bool RestingRock::is_held() {
    touching_.clear();
    for (const Gap& gap : gaps_)
        if (gap.height < held_within * scale_)
            touching_.push_back(gap);
    if (!can_rest(touching_, reach_) && !(settings_.burial > 0 && stands_in_ground()))
        return false;
    held_by_.clear();
    for (const Gap& gap : touching_)
        if (gap.below != HeightMap::no_rock && (held_by_.empty() || held_by_.back() != gap.below))
            held_by_.push_back(gap.below);
    return true;
}

void RestingRock::hang_over(int column, int row) {
    column_ = column;
    row_ = row;
}

bool RestingRock::settle(const MayBe& may_be) {
    for (int i = 0; i < most_map_slides && slide_by_map(may_be);)
        ++i;
    const Vec2 place = around_.map.place(column_, row_);
    const double height = rest(column_, row_);
    pose(settings_.keep_turn ? pose_.turn : turn_by_map(height), {place.x, height, place.y}, pose_);
    tops_.forget();
    lower(pose_, gaps_);
    double slope = steepest_turn;
    int slides = 0;
    bool at_rest = settings_.keep_turn; // otherwise it turns until it hardly comes lower
    for (int step = 0; step < most_steps; ++step) {
        if (at_rest && is_held())
            return true;
        const LoweringPlane plane = lowering_plane(gaps_, reach_, slope);
        at_rest = settings_.keep_turn || plane.height < at_rest_drop * scale_;
        if (plane.height < least_drop * scale_ || slope < least_turn) {
            if (is_held())
                return true;
            if (++slides > most_slides || !slide(may_be))
                return false;
            slope = steepest_turn;
            continue;
        }
        pose(turned(pose_.turn, following(plane)), pose_.centre, next_);
        lower(next_, next_gaps_);
        const double came = pose_.centre.y - next_.centre.y;
        if (came > 0)
            take_next();
        slope *= came > 0.5 * plane.height ? 1.5 : came > 0 ? 0.7 : 0.3;
        slope = std::min(slope, steepest_turn);
    }
    return is_held();
}

} // namespace scree::rocks
