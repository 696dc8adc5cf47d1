// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/overlap.h"

namespace scree {

namespace {

using Float4 = EdgeChunk::Float4;
using Mask4 = std::int32_t __attribute__((vector_size(16)));

bool any(const Mask4& mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

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

Motion motion(const Pose& a, const Pose& b, const Vec2& a_from_b) {
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
    for (const Disk& disk : a.disks()) {
        const auto px = static_cast<float>(disk.centre.x);
        const auto py = static_cast<float>(disk.centre.y);
        const float x = b_from_a.apply_x(px, py);
        const float y = b_from_a.apply_y(px, py);
        const float radius = b_from_a.scale * static_cast<float>(disk.radius);
        for (const CollisionShape::DiskChunk& chunk : b.disk_chunks()) {
            const Float4 dx = chunk.x - x;
            const Float4 dy = chunk.y - y;
            const Float4 sum = chunk.radius + radius;
            if (any(dx * dx + dy * dy < sum * sum))
                return true;
        }
    }
    return false;
}

/// A chunk of a's edges in b's frame.
EdgeChunk moved(const EdgeChunk& chunk, const Motion& b_from_a) {
    EdgeChunk result;
    result.from_x = b_from_a.apply_x(chunk.from_x, chunk.from_y);
    result.from_y = b_from_a.apply_y(chunk.from_x, chunk.from_y);
    result.to_x = b_from_a.apply_x(chunk.to_x, chunk.to_y);
    result.to_y = b_from_a.apply_y(chunk.to_x, chunk.to_y);
    result.normal_x = b_from_a.unit_cosine * chunk.normal_x - b_from_a.unit_sine * chunk.normal_y;
    result.normal_y = b_from_a.unit_sine * chunk.normal_x + b_from_a.unit_cosine * chunk.normal_y;
    result.offset = result.normal_x * result.from_x + result.normal_y * result.from_y;
    result.middle = (-result.normal_y * (result.from_x + result.to_x) +
                     result.normal_x * (result.from_y + result.to_y)) *
                    0.5F;
    result.half = chunk.half * b_from_a.scale;
    result.centre_x = b_from_a.apply_x(chunk.centre_x, chunk.centre_y);
    result.centre_y = b_from_a.apply_y(chunk.centre_x, chunk.centre_y);
    result.radius = chunk.radius * b_from_a.scale;
    result.count = chunk.count;
    return result;
}

Float4 lower(const Float4& a, const Float4& b) { return a < b ? a : b; }
Float4 upper(const Float4& a, const Float4& b) { return a > b ? a : b; }

/// Whether some edge of `a` comes within `tolerance` of some edge of `b`: two segments are apart
/// when they are so along one of four axes, each segment's direction and normal.
bool edges_meet(const EdgeChunk& a, const EdgeChunk& b, float tolerance) {
    const Float4 b_reach = b.half + tolerance;
    for (int i = 0; i < a.count; ++i) {
        const float px = a.from_x[i], py = a.from_y[i], qx = a.to_x[i], qy = a.to_y[i];
        const Float4 d0 = b.normal_x * px + b.normal_y * py - b.offset;
        const Float4 d1 = b.normal_x * qx + b.normal_y * qy - b.offset;
        Mask4 apart = (lower(d0, d1) > tolerance) | (upper(d0, d1) < -tolerance);

        const Float4 u0 = b.normal_x * py - b.normal_y * px - b.middle;
        const Float4 u1 = b.normal_x * qy - b.normal_y * qx - b.middle;
        apart |= (lower(u0, u1) > b_reach) | (upper(u0, u1) < -b_reach);

        const float nx = a.normal_x[i], ny = a.normal_y[i];
        const Float4 e0 = nx * b.from_x + ny * b.from_y - a.offset[i];
        const Float4 e1 = nx * b.to_x + ny * b.to_y - a.offset[i];
        apart |= (lower(e0, e1) > tolerance) | (upper(e0, e1) < -tolerance);

        const float a_reach = a.half[i] + tolerance;
        const Float4 v0 = nx * b.from_y - ny * b.from_x - a.middle[i];
        const Float4 v1 = nx * b.to_y - ny * b.to_x - a.middle[i];
        apart |= (lower(v0, v1) > a_reach) | (upper(v0, v1) < -a_reach);
        if (any(~apart))
            return true;
    }
    return false;
}

bool outlines_meet(const CollisionShape& a, const CollisionShape& b, const Motion& b_from_a,
                   float tolerance) {
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
            if (edges_meet(moved_chunk, other, tolerance))
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
    const auto x = static_cast<float>(point.x), y = static_cast<float>(point.y);
    Mask4 inside{};
    for (const EdgeChunk& edges : shape.chunks()) {
        const Mask4 straddles = (edges.from_y > y) ^ (edges.to_y > y);
        const Mask4 upwards = edges.to_y > edges.from_y;
        const Mask4 left = edges.normal_x * x + edges.normal_y * y < edges.offset;
        inside ^= straddles & ~(upwards ^ left);
    }
    return ((inside[0] ^ inside[1] ^ inside[2] ^ inside[3]) & 1) != 0;
}

} // namespace

bool overlap(const CollisionShape& a, const Pose& pose_a, const CollisionShape& b,
             const Pose& pose_b, const Vec2& a_from_b, double clearance) {
    const double reach = a.radius() * pose_a.scale + b.radius() * pose_b.scale + clearance;
    if (a_from_b.length2() > reach * reach * (1 + 1e-9))
        return false;
    const Motion b_from_a = motion(pose_a, pose_b, a_from_b);
    if (disks_overlap(a, b, b_from_a))
        return true;
    // Rounding: no coordinate in b's frame exceeds twice the reach; a moved point has an error of
    // at most 5 units in the last place of that, and its distance to a line 6 more. 2^-24 * 2 * 11
    // is 1.3e-6; twice that holds for both outlines and leaves room for the double arithmetic.
    const auto tolerance = static_cast<float>((4e-6 * reach + clearance) / pose_b.scale);
    if (outlines_meet(a, b, b_from_a, tolerance))
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
