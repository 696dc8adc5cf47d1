// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/fibre_source.h"

#include "core/parallel.h"

namespace scree::fibres {

namespace {

Random shape_stream(const FibresSettings& settings, std::size_t fibre) {
    return {settings.seed, Purpose::fibre_shape, fibre};
}

Vec3 mean(std::span<const Vec3> points) {
    WideVec3 sum(0.0);
    for (const Vec3& p : points)
        sum += WideVec3(p);
    return Vec3(sum / double(points.size()));
}

} // namespace

void FibreSource::grow(std::size_t fibre, std::span<Vec3> points,
                       std::span<Rotation> frames) const {
    const FibreShape& shape = settings_->shape;
    const std::optional<FibreFlow>& flow = settings_->flow;
    Random random = shape_stream(*settings_, fibre);
    const float length = draw_segment_length(shape, random);
    const Rotation turn = random_rotation(random);
    if (roots_ != nullptr) {
        const Root& root = roots_->all[fibre];
        const Rotation frame = unit(from_to(axis_y(turn), root.normal) * turn);
        fibres::grow(shape, flow, {root.position, frame}, length, random, points, frames);
        return;
    }
    Random place(settings_->seed, Purpose::fibre_place, fibre);
    const Vec3 centre = interior_->draw(place);
    FibreStart start{centre, turn};
    if (flow) { // grown about where it will be
        const Vec3 along = flow->at(centre);
        start.frame = turned_towards(turn, along, flow->strength);
        start.position -= along * (length * static_cast<float>(shape.segments) / 2);
    }
    fibres::grow(shape, flow, start, length, random, points, frames);
    const Vec3 shift = centre - mean(points);
    for (Vec3& p : points)
        p += shift;
}

float FibreSource::segment_length(std::size_t fibre) const {
    Random random = shape_stream(*settings_, fibre);
    return draw_segment_length(settings_->shape, random);
}

FibreSource::Placed FibreSource::place_all() const {
    const std::uint32_t vertices = settings_->shape.vertices();
    Placed placed;
    placed.rigid.vertices = vertices;
    placed.rigid.local.resize(settings_->count * vertices);
    placed.rigid.poses.resize(settings_->count);
    placed.normals.resize(settings_->count);
    parallel_for(settings_->count, 64, [&](std::size_t i) {
        std::vector<Rotation> frames(settings_->shape.segments);
        const std::span<Vec3> points(&placed.rigid.local[i * vertices], vertices);
        grow(i, points, frames);
        placed.normals[i] = rotated(frames.front(), Vec3(1, 0, 0));
        const Vec3 centre = mean(points);
        placed.rigid.poses[i].centre = centre;
        for (Vec3& p : points)
            p -= centre;
    });
    return placed;
}

} // namespace scree::fibres
