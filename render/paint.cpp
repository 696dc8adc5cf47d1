// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/paint.h"

#include "render/frame.h"
#include "render/instance_record.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

// A surface seen along itself draws the filter out without end. Beyond this factor (an angle of
// one degree) a row of pixels shows so much of the surface that its mean is all that is left.
constexpr float least_cosine = 1.0F / 64;

// Turns two vectors in their plane so that they stand at right angles, with the same
// sum of v v^T, the filter's second moments; the shorter one first.
void straighten(Vec3& across, Vec3& along) {
    const float product = across.dot(along);
    const float difference = along.dot(along) - across.dot(across);
    // Jacobi's rotation (Golub & Van Loan 2013, section 8.5.2), which turns by 45 degrees at most.
    if (product != 0) {
        const float ratio = difference / (2 * product);
        const float tangent =
            std::copysign(1.0F, ratio) / (std::abs(ratio) + std::sqrt(1 + ratio * ratio));
        const float cosine = 1 / std::sqrt(1 + tangent * tangent);
        const Vec3 turned = (across - along * tangent) * cosine;
        along = (along + across * tangent) * cosine;
        across = turned;
    }
    if (across.dot(across) > along.dot(along))
        std::swap(across, along);
}

float reflectance(float value) { return std::clamp(value, 0.0F, 1.0F); }

} // namespace

ShadingPoint shading_point(const Hit& hit, const Vec3& direction, float footprint) {
    assert(hit.record != nullptr);
    const InstanceRecord& record = *hit.record;
    ShadingPoint point;
    point.position = hit.object_position;
    point.random = hit.random;

    const Vec3 level = hit.normal.cross(direction); // as long as the sine of the slant
    const float square = level.dot(level);
    // Straight from above all directions are alike, and the cross product has no digits.
    const Vec3 across = square > 1e-10F ? level / std::sqrt(square) : Frame(hit.normal).x;
    const float cosine = std::max(least_cosine, std::abs(hit.normal.dot(direction)));
    point.across = record.inverse_direction(across * footprint);
    point.along = record.inverse_direction(across.cross(hit.normal) * (footprint / cosine));
    point.footprint = footprint / record.scale;
    if (!record.similar) {
        straighten(point.across, point.along);
        point.footprint = std::sqrt(point.across.dot(point.across));
    }
    return point;
}

Vec3 bent_normal(const Hit& hit, const Vec3& slope) {
    assert(hit.record != nullptr);
    const Vec3* rows = hit.record->rows;
    const Vec3& n = hit.shading_normal;
    const Vec3 normal = unit(Vec3(rows[0].dot(n), rows[1].dot(n), rows[2].dot(n)));
    return unit(hit.record->normal(normal - slope + normal * normal.dot(slope)));
}

Painted paint_at(const Paint& paint, const Hit& hit, const Vec3& direction, float footprint) {
    Painted painted;
    if (!paint.palette.empty()) {
        const auto count = paint.palette.size();
        const auto index = static_cast<std::size_t>(hit.random * static_cast<float>(count));
        painted.color = paint.palette[std::min(index, count - 1)];
        return painted;
    }
    if (paint.texture.procedural == nullptr) {
        painted.color = paint.texture.constant;
        return painted;
    }
    ShadingPoint point = shading_point(hit, direction, footprint);
    if (!paint.texture.procedural->solid()) {
        point.uv = hit.uv();
        point.uv_footprint = point.footprint * hit.uv_scale();
    }
    ShadingSample sample;
    paint.texture.procedural->evaluate({&point, 1}, {&sample, 1});
    painted.color = {reflectance(sample.color.x), reflectance(sample.color.y),
                     reflectance(sample.color.z)};
    painted.roughness = sample.roughness;
    if (sample.slope != Vec3(0.0F, 0.0F, 0.0F)) {
        painted.bent = true;
        painted.normal = bent_normal(hit, sample.slope);
    }
    return painted;
}

} // namespace scree
