// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/resting_rock.h"

#include "generators/rocks/friction_hold.h"

#include <algorithm>

namespace scree::rocks {

namespace {

// Lengths are in halves of the longest axis.
constexpr double steepest_turn = 0.3; // of one step, as a slope
constexpr double least_turn = 2e-3;
constexpr int most_steps = 10;
constexpr double least_drop = 3e-4;   // of a step that is worth taking
constexpr double at_rest_drop = 0.05; // of the next step, when a rock is as good as at rest
constexpr double held_within = 0.006; // contacts that hold are as near as this: 0.003 D
constexpr double wide_gap = 0.12;     // gaps so much wider than the least hardly matter
constexpr double map_slide = 0.5;     // the longest step by the map
constexpr double least_map_drop = 0.02;
constexpr int most_map_slides = 16;
constexpr double longest_slide = 0.15; // of one step
constexpr int most_slides = 2;

/// The rotation by which the rock follows a plane down.
Rotation following(const LoweringPlane& plane) {
    return Rotation(WideVec3(std::atan(plane.slope_z), 0, -std::atan(plane.slope_x)));
}

} // namespace

void RestingRock::pose(const Imath::M33d& turn, int column, int row, const Vec2& offset,
                       Pose& out) const {
    const double cell = around_.map.cell();
    const auto columns = static_cast<int>(std::lround(offset.x / cell));
    const auto rows = static_cast<int>(std::lround(offset.y / cell));
    out.turn = turn;
    out.column = column + columns;
    out.row = row + rows;
    out.offset = offset - Vec2(columns, rows) * cell;
    pose_vertices(*surface_, turn, scale_, out.vertices);
    const Vec3 shift(static_cast<float>(out.offset.x), 0, static_cast<float>(out.offset.y));
    for (Vec3& v : out.vertices)
        v += shift;
    rasterise(out.vertices, surface_->triangles, cell, Side::under, out.under);
}

void RestingRock::take(const RockSurface& surface, double scale, const Imath::M33d& turn) {
    surface_ = &surface;
    scale_ = scale;
    pose(turn, 0, 0, Vec2(0.0), pose_);
    const auto [low, high] =
        std::minmax_element(pose_.vertices.begin(), pose_.vertices.end(),
                            [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
    sink_ = settings_.burial * double(high->y - low->y);
}

double RestingRock::rest(int column, int row, double enough) const {
    return around_.map.rest(pose_.under, column, row, sink_, enough);
}

WideVec3 RestingRock::centre() const {
    const Vec2 place = around_.map.place(pose_.column, pose_.row) + pose_.offset;
    return {place.x, pose_.height, place.y};
}

std::vector<Vec3> RestingRock::vertices() const {
    std::vector<Vec3> vertices = pose_.vertices;
    for (Vec3& v : vertices)
        v -= Vec3(static_cast<float>(pose_.offset.x), 0, static_cast<float>(pose_.offset.y));
    return vertices;
}

void RestingRock::add_to(HeightMap& map, std::uint32_t number) {
    rasterise(pose_.vertices, surface_->triangles, map.cell(), Side::top, top_);
    map.add(top_, pose_.column, pose_.row, pose_.height, number);
}

void RestingRock::lower(Pose& pose, std::vector<Gap>& gaps) {
    const double height = around_.map.rest(pose.under, pose.column, pose.row, sink_);
    double least = 0;
    // By the map no gap is less than 0; the exact ones are wider by about a cell and its slope, as
    // much as the last time or so.
    for (double margin = std::max(1.5 * last_least_, around_.map.cell());; margin *= 2) {
        const std::vector<Gap>& found = contact_.gaps({.vertices = pose.vertices,
                                                       .triangles = surface_->triangles,
                                                       .under = pose.under,
                                                       .column = pose.column,
                                                       .row = pose.row,
                                                       .offset = pose.offset,
                                                       .height = height,
                                                       .sink = sink_},
                                                      around_, margin, wide_gap * scale_);
        least = margin;
        for (const Gap& gap : found)
            least = std::min(least, gap.height);
        if (least < margin || margin > scale_) {
            gaps = found;
            break;
        }
    }
    last_least_ = least;
    pose.height = height - least;
    for (Gap& gap : gaps)
        gap.height -= least;
}

bool RestingRock::slide_by_map(const MayBe& may_be) {
    double best = rest(pose_.column, pose_.row) - least_map_drop * scale_;
    std::pair<int, int> step{0, 0};
    for (const double share : {map_slide, map_slide / 4}) {
        const int far = std::max(1, static_cast<int>(share * scale_ / around_.map.cell()));
        for (int z = -far; z <= far; z += far)
            for (int x = -far; x <= far; x += far) {
                const double height = rest(pose_.column + x, pose_.row + z, best);
                if (height < best && may_be(around_.map.place(pose_.column + x, pose_.row + z))) {
                    best = height;
                    step = {x, z};
                }
            }
    }
    pose_.column += step.first;
    pose_.row += step.second;
    return step != std::pair(0, 0);
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
        pose(pose_.turn, pose_.column, pose_.row, pose_.offset - Vec2(plane.slope_x, plane.slope_z),
             next_);
        if (!may_be(around_.map.place(next_.column, next_.row) + next_.offset))
            return false;
        lower(next_, next_gaps_);
        if (next_.height < pose_.height) {
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
    const Vec2 middle = around_.map.place(pose_.column, pose_.row);
    for (const Vec3& v : pose_.vertices) {
        const Vec2 at(double(v.x), double(v.z));
        if (pose_.height + double(v.y) > around_.ground.height(middle + at))
            continue;
        for (int i = 0; i < directions; ++i)
            farthest[std::size_t(i)] = std::max(
                farthest[std::size_t(i)], rotate(at - pose_.offset, 2 * pi * i / directions).x);
    }
    return std::all_of(farthest.begin(), farthest.end(),
                       [&](double far) { return far > 0.02 * scale_; });
}

bool RestingRock::is_held() {
    touching_.clear();
    for (const Gap& gap : gaps_)
        if (gap.height < held_within * scale_)
            touching_.push_back(gap);
    if (!can_rest(touching_, double(surface_->reach) * scale_) &&
        !(settings_.burial > 0 && stands_in_ground()))
        return false;
    held_by_.clear();
    const double cell = around_.map.cell();
    for (const Gap& gap : touching_) {
        const int x =
            pose_.column + static_cast<int>(std::lround((gap.arm.x + pose_.offset.x) / cell));
        const int z =
            pose_.row + static_cast<int>(std::lround((gap.arm.z + pose_.offset.y) / cell));
        const std::uint32_t other = around_.map.rock(x, z);
        if (other != HeightMap::no_rock && (held_by_.empty() || held_by_.back() != other))
            held_by_.push_back(other);
    }
    return true;
}

void RestingRock::hang_over(int column, int row) {
    pose_.column = column;
    pose_.row = row;
}

bool RestingRock::settle(const MayBe& may_be) {
    for (int i = 0; i < most_map_slides && slide_by_map(may_be);)
        ++i;
    last_least_ = 2 * around_.map.cell();
    lower(pose_, gaps_);
    const double reach = double(surface_->reach) * scale_;
    double slope = steepest_turn;
    int slides = 0;
    bool at_rest = settings_.keep_turn; // otherwise it turns until it hardly comes lower
    for (int step = 0; step < most_steps; ++step) {
        if (at_rest && is_held())
            return true;
        const LoweringPlane plane = lowering_plane(gaps_, reach, slope);
        at_rest = settings_.keep_turn || plane.height < at_rest_drop * scale_;
        if (plane.height < least_drop * scale_ || slope < least_turn) {
            if (is_held())
                return true;
            if (++slides > most_slides || !slide(may_be))
                return false;
            slope = steepest_turn;
            continue;
        }
        pose(turned(pose_.turn, following(plane)), pose_.column, pose_.row, pose_.offset, next_);
        lower(next_, next_gaps_);
        const double came = pose_.height - next_.height;
        if (came > 0)
            take_next();
        slope *= came > 0.5 * plane.height ? 1.5 : came > 0 ? 0.7 : 0.3;
        slope = std::min(slope, steepest_turn);
    }
    return is_held();
}

} // namespace scree::rocks
