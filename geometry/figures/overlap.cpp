// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/figures/overlap.h"

namespace scree {

namespace {

/// From a's frame to b's, in float.
struct Motion {
    float cosine, sine; // times the relative scale
    float x, y;
    float unit_cosine, unit_sine, scale;

    template <class T>
    T apply_x(T px, T py) const {
        return cosine * px - sine * py + x;
    }
    template <class T>
    T apply_y(T px, T py) const {
        return sine * px + cosine * py + y;
    }
};

Motion motion(const FigurePose& a, const FigurePose& b, const Vec2& a_from_b) {
    const double scale = a.scale / b.scale;
    const double cosine = a.cosine * b.cosine + a.sine * b.sine;
    const double sine = a.sine * b.cosine - a.cosine * b.sine;
    const Vec2 d = a_from_b / b.scale;
    return {static_cast<float>(cosine * scale),
            static_cast<float>(sine * scale),
            static_cast<float>(b.cosine * d.x + b.sine * d.y),
            static_cast<float>(b.cosine * d.y - b.sine * d.x),
            static_cast<float>(cosine),
            static_cast<float>(sine),
            static_cast<float>(scale)};
}

bool disks_overlap(const CollisionShape& a, const CollisionShape& b, const Motion& b_from_a) {
    for (const CollisionShape::DiskChunk& chunk : a.disk_chunks()) {
        const Float4 x = b_from_a.apply_x(chunk.x, chunk.y);
        const Float4 y = b_from_a.apply_y(chunk.x, chunk.y);
        const Float4 radius = chunk.radius * b_from_a.scale;
        Mask4 hit{};
        for (const CollisionShape::FloatDisk& disk : b.float_disks()) {
            const Float4 dx = x - disk.x, dy = y - disk.y, sum = radius + disk.radius;
            hit |= dx * dx + dy * dy < sum * sum;
        }
        if (any(hit))
            return true;
    }
    return false;
}

/// A chunk of a's edges in b's frame, as far as `edges_meet` needs it.
EdgeChunk moved(const EdgeChunk& chunk, const Motion& b_from_a) {
    EdgeChunk result;
    result.middle_x = b_from_a.apply_x(chunk.middle_x, chunk.middle_y);
    result.middle_y = b_from_a.apply_y(chunk.middle_x, chunk.middle_y);
    result.along_x = b_from_a.unit_cosine * chunk.along_x - b_from_a.unit_sine * chunk.along_y;
    result.along_y = b_from_a.unit_sine * chunk.along_x + b_from_a.unit_cosine * chunk.along_y;
    result.half = chunk.half * b_from_a.scale;
    result.count = chunk.count;
    return result;
}

Float4 clamped(const Float4& v, const Float4& limit) {
    const Float4 low = v < -limit ? -limit : v;
    return low > limit ? limit : low;
}

/// Squared distance of the point from the segments with these middles, directions and half lengths.
Float4 squared_distance(const Float4& x, const Float4& y, const Float4& along_x,
                        const Float4& along_y, const Float4& half) {
    const Float4 t = clamped(x * along_x + y * along_y, half);
    const Float4 dx = x - t * along_x, dy = y - t * along_y;
    return dx * dx + dy * dy;
}

/// Whether an end of edge i of `a` or of an edge of `b` is within `distance` of the other edge.
/// Segments that do not cross are nearest to each other at an end of one of them.
Mask4 ends_within(const EdgeChunk& a, int i, const EdgeChunk& b, float distance) {
    const Float4 x = a.middle_x[i] - b.middle_x, y = a.middle_y[i] - b.middle_y;
    const Float4 ax = Float4{} + a.along_x[i], ay = Float4{} + a.along_y[i];
    const Float4 half = Float4{} + a.half[i];
    const Float4 limit = Float4{} + distance * distance;
    Mask4 result{};
    for (const float side : {-1.0F, 1.0F}) {
        result |= squared_distance(x + side * half * ax, y + side * half * ay, b.along_x, b.along_y,
                                   b.half) <= limit;
        result |= squared_distance(side * b.half * b.along_x - x, side * b.half * b.along_y - y, ax,
                                   ay, half) <= limit;
    }
    return result;
}

/// Whether some edge of `a` comes within `tolerance` of some edge of `b`. Two segments are apart
/// when their projections onto one of four axes are: each segment's direction and its normal.
/// That sees corners at up to sqrt(2) times the tolerance; `exact` looks again, with a tolerance
/// that must then be much larger than rounding.
bool edges_meet(const EdgeChunk& a, const EdgeChunk& b, float tolerance, bool exact) {
    const Float4 b_reach = b.half + tolerance;
    Mask4 all_apart = ~Mask4{};
    for (int i = 0; i < a.count; ++i) {
        const float along_x = a.along_x[i], along_y = a.along_y[i], half = a.half[i];
        const float reach = half + tolerance;
        const Float4 x = a.middle_x[i] - b.middle_x, y = a.middle_y[i] - b.middle_y;
        const Float4 sine = absolute(along_x * b.along_y - along_y * b.along_x);
        const Float4 cosine = absolute(along_x * b.along_x + along_y * b.along_y);
        const Float4 off_b = absolute(x * b.along_y - y * b.along_x);
        const Float4 off_a = absolute(x * along_y - y * along_x);
        Mask4 apart = (off_b > half * sine + tolerance) |
                      (absolute(x * b.along_x + y * b.along_y) > half * cosine + b_reach) |
                      (off_a > b.half * sine + tolerance) |
                      (absolute(x * along_x + y * along_y) > b.half * cosine + reach);
        if (exact && any(~apart)) {
            // Lines that cross within both segments, or nearly so, count as met.
            const Mask4 cross = (off_b <= half * sine) & (off_a <= b.half * sine);
            apart |= ~cross & ~ends_within(a, i, b, tolerance);
        }
        all_apart &= apart;
    }
    return any(~all_apart);
}

bool outlines_meet(const CollisionShape& a, const CollisionShape& b, const Motion& b_from_a,
                   float tolerance, bool exact) {
    const float b_radius = static_cast<float>(b.radius()) + tolerance;
    for (const EdgeChunk& chunk : a.chunks()) {
        const float x = b_from_a.apply_x(chunk.centre_x, chunk.centre_y);
        const float y = b_from_a.apply_y(chunk.centre_x, chunk.centre_y);
        const float radius = chunk.radius * b_from_a.scale + tolerance;
        if (x * x + y * y > (radius + b_radius) * (radius + b_radius))
            continue;
        EdgeChunk moved_chunk;
        bool is_moved = false;
        for (const EdgeChunk& other : b.chunks()) {
            const float dx = x - other.centre_x, dy = y - other.centre_y;
            const float sum = radius + other.radius;
            if (dx * dx + dy * dy > sum * sum)
                continue;
            if (!is_moved) {
                moved_chunk = moved(chunk, b_from_a);
                is_moved = true;
            }
            if (edges_meet(moved_chunk, other, tolerance, exact))
                return true;
        }
    }
    return false;
}

/// Even-odd test for a point that is farther than the tolerance from all edges; an edge's side is
/// then certain even in float.
bool holds(const CollisionShape& shape, const Vec2& point) {
    if (point.length2() > shape.radius() * shape.radius())
        return false;
    const auto px = static_cast<float>(point.x), py = static_cast<float>(point.y);
    Mask4 inside{};
    for (const EdgeChunk& edges : shape.chunks()) {
        const Mask4 straddles = (edges.from_y > py) ^ (edges.to_y > py);
        const Mask4 upwards = edges.to_y > edges.from_y;
        const Mask4 left =
            edges.along_x * (py - edges.middle_y) > edges.along_y * (px - edges.middle_x);
        inside ^= straddles & ~(upwards ^ left);
    }
    return ((inside[0] ^ inside[1] ^ inside[2] ^ inside[3]) & 1) != 0;
}

} // namespace

bool overlap(const CollisionShape& a, const FigurePose& pose_a, const CollisionShape& b,
             const FigurePose& pose_b, const Vec2& a_from_b, double clearance) {
    const double reach = a.radius() * pose_a.scale + b.radius() * pose_b.scale + clearance;
    if (a_from_b.length2() > reach * reach * (1 + 1e-9))
        return false;
    const Motion b_from_a = motion(pose_a, pose_b, a_from_b);
    if (disks_overlap(a, b, b_from_a))
        return true;
    // Rounding: no coordinate in b's frame exceeds twice the reach, M. In units of 2^-24 M a moved
    // middle is off by at most 5, its difference to another by 1, a product with a unit vector by
    // 6, the half length times sine or cosine by 4: less than 20 in all, or 2.4e-6 of the reach.
    const auto tolerance = static_cast<float>((4e-6 * reach + clearance) / pose_b.scale);
    const bool exact = clearance > 1e-3 * reach; // a smaller excess at corners does not matter
    if (outlines_meet(a, b, b_from_a, tolerance, exact))
        return true;
    for (const Vec2& v : a.outer_vertices()) {
        const Vec2 turned(pose_a.cosine * v.x - pose_a.sine * v.y,
                          pose_a.sine * v.x + pose_a.cosine * v.y);
        const Vec2 d = (a_from_b + turned * pose_a.scale) / pose_b.scale;
        if (holds(b, {pose_b.cosine * d.x + pose_b.sine * d.y,
                      pose_b.cosine * d.y - pose_b.sine * d.x}))
            return true;
    }
    for (const Vec2& v : b.outer_vertices()) {
        const Vec2 turned(pose_b.cosine * v.x - pose_b.sine * v.y,
                          pose_b.sine * v.x + pose_b.cosine * v.y);
        const Vec2 d = (turned * pose_b.scale - a_from_b) / pose_a.scale;
        if (holds(a, {pose_a.cosine * d.x + pose_a.sine * d.y,
                      pose_a.cosine * d.y - pose_a.sine * d.x}))
            return true;
    }
    return false;
}

} // namespace scree
