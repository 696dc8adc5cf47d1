// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/paint.h"

#include "core/frame.h"
#include "render/world/instance_record.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace scree {

namespace {

// At a grazing angle the projected filter grows without bound. Below this cosine (an angle of one
// degree) a row of pixels shows so much of the surface that only its mean can be seen.
constexpr float least_cosine = 1.0F / 64;

// Turns two vectors in their plane until they are perpendicular and keeps the sum of v v^T, the
// filter's second moments; the shorter one first.
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

ShadingPoint shading_point(const Hit& hit, const Vec3& direction, float footprint,
                           TextureUnit unit) {
    assert(hit.record != nullptr);
    const InstanceRecord& record = *hit.record;
    const Vec3 stretch = unit == TextureUnit::world ? record.stretch() : Vec3(1.0F);
    ShadingPoint point;
    point.position = hit.object_position * stretch;
    point.random = hit.random;
    point.level = hit.level;
    point.up = hit.shading_normal.y;

    const Vec3 level = hit.normal.cross(direction); // its length is the sine of the slant
    const float square = level.dot(level);
    // Seen straight from above all directions are equal, and the cross product has no digits.
    const Vec3 across = square > 1e-10F ? level * (1 / std::sqrt(square)) : Frame(hit.normal).x;
    const float cosine = std::max(least_cosine, std::abs(hit.normal.dot(direction)));
    point.across = record.inverse_direction(across * footprint) * stretch;
    point.along =
        record.inverse_direction(across.cross(hit.normal) * (footprint / cosine)) * stretch;
    point.footprint = unit == TextureUnit::world ? footprint : footprint / record.scale;
    if (!record.similar) {
        straighten(point.across, point.along);
        point.footprint = std::sqrt(point.across.dot(point.across));
    }
    return point;
}

Vec3 bent_normal(const Hit& hit, const Vec3& slope, TextureUnit unit_of_slope) {
    assert(hit.record != nullptr);
    if (unit_of_slope == TextureUnit::world && !hit.record->similar) {
        // Gradients transform by the inverse transpose: the cofactors over the determinant.
        const float volume = hit.record->scale * hit.record->scale * hit.record->scale;
        const Vec3 gradient = hit.record->normal(slope * hit.record->stretch()) / volume;
        const Vec3& n = hit.shading_normal;
        return unit(n - gradient + n * n.dot(gradient));
    }
    const std::array<Vec3, 4>& rows = hit.record->rows;
    const Vec3& n = hit.shading_normal;
    const Vec3 normal = unit(Vec3(rows[0].dot(n), rows[1].dot(n), rows[2].dot(n)));
    return unit(hit.record->normal(normal - slope + normal * normal.dot(slope)));
}

namespace {

/// Whether it needed no procedural.
bool paint_plainly(const PaintQuery& query, Painted& painted) {
    painted = {};
    const std::optional<Color> color = query.paint->one_color(query.hit->random);
    if (color)
        painted.color = *color;
    return color.has_value();
}

Painted painted_as(const ShadingSample& sample, const Hit& hit, TextureUnit unit) {
    Painted painted;
    painted.color = {reflectance(sample.color.x), reflectance(sample.color.y),
                     reflectance(sample.color.z)};
    painted.roughness = sample.roughness;
    if (sample.slope != Vec3(0.0F, 0.0F, 0.0F)) {
        painted.bent = true;
        painted.normal = bent_normal(hit, sample.slope, unit);
    }
    return painted;
}

/// The hits of one procedural.
class Batch {
  public:
    explicit Batch(const Procedural& procedural)
        : procedural_(procedural), solid_(procedural.solid()),
          unit_(procedural.scales_with_object() ? TextureUnit::object : TextureUnit::world) {}

    void add(const PaintQuery& query, Painted& painted) {
        ShadingPoint& point = points_[count_];
        point = shading_point(*query.hit, query.direction, query.footprint, unit_);
        if (!solid_) {
            point.uv = query.hit->uv;
            const float metres = unit_ == TextureUnit::world
                                     ? point.footprint / query.hit->record->scale
                                     : point.footprint;
            point.uv_footprint = metres * query.hit->uv_per_metre;
        }
        hits_[count_] = query.hit;
        painted_[count_++] = &painted;
    }

    void answer() {
        procedural_.evaluate({points_.data(), count_}, {samples_.data(), count_});
        for (std::size_t i = 0; i < count_; ++i)
            *painted_[i] = painted_as(samples_[i], *hits_[i], unit_);
    }

  private:
    const Procedural& procedural_;
    bool solid_;
    TextureUnit unit_;
    std::size_t count_ = 0;
    std::array<const Hit*, most_painted> hits_;
    std::array<Painted*, most_painted> painted_;
    std::array<ShadingPoint, most_painted> points_;
    std::array<ShadingSample, most_painted> samples_;
};

} // namespace

void paint(std::span<const PaintQuery> queries, std::span<Painted> painted) {
    assert(queries.size() == painted.size() && queries.size() <= most_painted);
    std::array<std::size_t, most_painted> waiting;
    std::size_t count = 0;
    for (std::size_t i = 0; i < queries.size(); ++i)
        if (!paint_plainly(queries[i], painted[i]))
            waiting[count++] = i;
    const auto procedural_of = [&](std::size_t i) {
        return queries[i].paint->texture.procedural.get();
    };
    while (count > 0) {
        const Procedural* procedural = procedural_of(waiting[0]);
        Batch batch(*procedural);
        std::size_t others = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = waiting[k];
            if (procedural_of(i) == procedural)
                batch.add(queries[i], painted[i]);
            else
                waiting[others++] = i;
        }
        batch.answer();
        count = others;
    }
}

} // namespace scree
