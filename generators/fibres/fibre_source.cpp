// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/fibre_source.h"

#include "core/parallel.h"

namespace scree::fibres {

namespace {

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
    Random random = stream(Purpose::fibre_shape, fibre);
    draw_segment_length(shape, random);
    const float length = segment_length(fibre);
    const Rotation turn = random_rotation(random);
    if (roots_ != nullptr) {
        const Root& root = roots_->all[fibre];
        const Rotation frame = unit(from_to(axis_y(turn), root.normal) * turn);
        fibres::grow(shape, flow, {root.position, frame}, length, random, points, frames);
        return;
    }
    Random places = stream(Purpose::fibre_place, fibre);
    const Vec3 centre = interior_->draw(places);
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

Random FibreSource::stream(Purpose purpose, std::size_t fibre) const {
    return {settings_->seed, purpose, fibre + (std::uint64_t(draws_[fibre]) << 32)};
}

float FibreSource::segment_length(std::size_t fibre) const {
    Random first(settings_->seed, Purpose::fibre_shape, fibre);
    return draw_segment_length(settings_->shape, first);
}

FibreSource::Placed FibreSource::place_all() const {
    const std::uint32_t vertices = settings_->shape.vertices();
    Placed placed;
    placed.rigid.vertices = vertices;
    placed.rigid.local.resize(settings_->count * vertices);
    placed.rigid.poses.resize(settings_->count);
    placed.normals.resize(settings_->count);
    parallel_for(settings_->count, 64, [&](std::size_t i) { place(i, placed); });
    return placed;
}

void FibreSource::place(std::size_t fibre, Placed& placed) const {
    std::vector<Rotation> frames(settings_->shape.segments);
    const std::uint32_t vertices = placed.rigid.vertices;
    const std::span<Vec3> points(&placed.rigid.local[fibre * vertices], vertices);
    grow(fibre, points, frames);
    placed.normals[fibre] = rotated(frames.front(), Vec3(1, 0, 0));
    const Vec3 centre = mean(points);
    placed.rigid.poses[fibre] = {.centre = centre};
    for (Vec3& p : points)
        p -= centre;
}

void FibreSource::draw_again(std::size_t fibre, Placed& placed) {
    ++draws_[fibre];
    place(fibre, placed);
}

} // namespace scree::fibres
