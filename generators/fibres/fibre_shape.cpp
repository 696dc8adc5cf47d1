// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/fibre_shape.h"

namespace scree::fibres {

namespace {

float draw(const Range& range, Random& random) {
    return static_cast<float>(random.uniform(range.low, range.high));
}

} // namespace

float draw_segment_length(const FibreShape& shape, Random& random) {
    return draw(shape.length, random) / static_cast<float>(shape.segments);
}

void grow(const FibreShape& shape, const std::optional<FibreFlow>& flow, const FibreStart& start,
          float segment_length, Random& random, std::span<Vec3> points,
          std::span<Rotation> frames) {
    Rotation frame = start.frame;
    points[0] = start.position;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i] = frame;
        points[i + 1] = points[i] + axis_y(frame) * segment_length;
        const float theta = draw(shape.theta, random);
        const float phi = draw(shape.phi, random);
        frame = unit(frame * about_z(theta) * about_y(phi));
        if (flow)
            frame = turned_towards(frame, flow->at(points[i + 1]), flow->strength);
    }
}

} // namespace scree::fibres
