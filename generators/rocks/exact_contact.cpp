// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/exact_contact.h"

#include <algorithm>
#include <limits>

namespace scree::rocks {

namespace {

/// Normals that are nearer to level than this are taken as level: such triangles are seen as lines
/// from above.
constexpr double steepest = 1e4;

bool is_upright(const WideVec3& normal) {
    return std::abs(normal.y) * steepest <= std::max(std::abs(normal.x), std::abs(normal.z));
}

/// Whether a place is in a triangle, seen from above.
bool is_in(const Plan& plan, double x, double z) {
    for (std::size_t i = 0; i < 3; ++i) {
        const WideVec3& p = plan.corners[i];
        const WideVec3& q = plan.corners[i < 2 ? i + 1 : 0];
        if ((q.x - p.x) * (z - p.z) - (q.z - p.z) * (x - p.x) < 0)
            return false;
    }
    return true;
}

} // namespace

const std::vector<Gap>& ExactContact::gaps(const HeldRock& rock, const Surroundings& tops,
                                           const Ground& ground, double more) {
    gaps_.clear();
    offset_ = rock.centre - tops.origin();
    least_ = std::numeric_limits<double>::max();
    more_ = more;
    points_.resize(rock.vertices.size());
    std::transform(rock.vertices.begin(), rock.vertices.end(), points_.begin(),
                   [&](const Vec3& v) { return WideVec3(v) + offset_; });
    lower_bound_by_vertices(rock, tops, ground);
    if (ground.mesh() == nullptr)
        add_ground(rock, ground);
    for (const Mesh::Triangle& t : rock.triangles) {
        const Vec3& a = rock.vertices[t[0]];
        const Vec3& b = rock.vertices[t[1]];
        const Vec3& c = rock.vertices[t[2]];
        if ((b - a).cross(c - a).y < 0)
            add_triangle(Plan(points_[t[0]], points_[t[1]], points_[t[2]]), tops);
    }
    return gaps_;
}

void ExactContact::lower_bound_by_vertices(const HeldRock& rock, const Surroundings& tops,
                                           const Ground& ground) {
    // The gaps below vertices are some of all: with them known, few triangles are near enough.
    for (const WideVec3& p : points_) {
        if (ground.mesh() == nullptr) {
            const WideVec3 at = p + tops.origin();
            least_ = std::min(least_, at.y - ground.height({at.x, at.z}) + rock.sink);
        }
        const Vec2f place(static_cast<float>(p.x), static_cast<float>(p.z));
        tops.each_in(
            {place, place}, [&](double highest) { return p.y - highest < least_; },
            [&](const Surroundings::Top& top) {
                const double gap = p.y - top.plan.height(p.x, p.z);
                if (gap < least_ && is_in(top.plan, p.x, p.z))
                    least_ = gap;
            });
    }
}

void ExactContact::add_ground(const HeldRock& rock, const Ground& ground) {
    const WideVec3 normal(0, 1, ground.rise());
    for (const Vec3& v : rock.vertices) {
        const WideVec3 under(v);
        const WideVec3 at = rock.centre + under;
        const double gap = at.y - ground.height({at.x, at.z}) + rock.sink;
        if (matters(gap))
            add_gap(under, gap, normal, HeightMap::no_rock);
    }
}

void ExactContact::add_triangle(const Plan& under, const Surroundings& tops) {
    tops.each_in(
        under.box, [&](double highest) { return matters(under.low - highest); },
        [&](const Surroundings::Top& top) {
            if (matters(least_between(under, top.plan)))
                add_pair(under, top);
        });
}

void ExactContact::add_pair(const Plan& under, const Surroundings::Top& top) {
    const auto side = [](const Plan& plan, int i) {
        return plan.corners[std::size_t((i + 1) % 3)] - plan.corners[std::size_t(i)];
    };
    const CommonArea common(under, top.plan);
    for (std::size_t i = 0; i < common.count; ++i) {
        const CommonArea::Corner& corner = common.corners[i];
        const WideVec3 at(corner.place.x, under.height(corner.place.x, corner.place.y),
                          corner.place.y);
        const double gap = at.y - top.plan.height(at.x, at.z);
        least_ = std::min(least_, gap);
        if (!matters(gap))
            continue;
        // A corner of the underside touches a face, a face a corner of the top, or two edges.
        const bool of_under = corner.side < 3 && corner.other < 3;
        const bool of_top = corner.side >= 3 && corner.other >= 3;
        const WideVec3 normal =
            of_under ? WideVec3(-top.plan.slope_x, 1, -top.plan.slope_z)
            : of_top ? WideVec3(-under.slope_x, 1, -under.slope_z)
                     : side(under, std::min(corner.side, corner.other))
                           .cross(side(top.plan, std::max(corner.side, corner.other) - 3));
        add_gap(at - offset_, gap, normal, top.rock);
    }
}

void ExactContact::add_gap(const WideVec3& under, double height, const WideVec3& normal,
                           std::uint32_t below) {
    const WideVec3 up = normal.y < 0 ? -normal : normal;
    const double steep = is_upright(up) ? 0 : under.y / up.y;
    gaps_.push_back({.x = under.x - steep * up.x,
                     .z = under.z - steep * up.z,
                     .height = height,
                     .arm = under,
                     .normal = up.normalized(),
                     .below = below});
}

} // namespace scree::rocks
