// SPDX-License-Identifier: GPL-3.0-or-later
// Aggregates for tests of fabrication.
#pragma once

#include "model/aggregate.h"
#include "shapes/table.h"
#include "tests/support/plugin_params.h"

namespace scree::tests {

inline Prototype component(const std::string& name, const std::map<std::string, Value>& values) {
    const auto table = component_table();
    Mesh mesh = make(table, name, values);
    return {name, std::make_shared<const Mesh>(std::move(mesh)), nullptr, {}};
}

inline Matrix placed(const Vec3& position, const Vec3& turn = Vec3(0.0F), float scale = 1) {
    Matrix matrix;
    matrix.translate(position);
    matrix.rotate(turn);
    matrix.scale(Vec3(scale));
    return matrix;
}

inline Instance instance(std::uint32_t prototype, const Matrix& matrix) {
    Instance out;
    out.prototype = prototype;
    out.world_from_object = WideMatrix(matrix);
    return out;
}

/// A ball with a radius of 10 mm that stands on the ground: its centre is (0, 10 mm, 0).
inline Prototype ball() {
    return component("sphere", {{"radius", 0.01}, {"segments", std::int64_t{96}}});
}

inline Aggregate aggregate_of(std::vector<Prototype> prototypes, std::vector<Instance> instances) {
    Aggregate out;
    out.generator = "pile";
    out.prototypes = std::move(prototypes);
    out.instances = std::move(instances);
    return out;
}

/// Six walls, 2 mm thick, around a closed room of 16 mm, with a ball in its middle that touches
/// none of them.
inline Aggregate closed_room() {
    const Prototype wall = component("box", {{"width", 0.02}, {"height", 0.002}, {"depth", 0.02}});
    const Prototype ball = component("sphere", {{"radius", 0.004}, {"segments", std::int64_t{48}}});
    std::vector<Instance> instances;
    const float turn = pi_f / 2;
    for (const float to : {0.0F, 0.018F}) {
        instances.push_back(instance(0, placed({0, to, 0})));
        instances.push_back(instance(0, placed({to - 0.008F, 0.01F, 0}, {0, 0, turn})));
        instances.push_back(instance(0, placed({0, 0.01F, to - 0.01F}, {turn, 0, 0})));
    }
    instances.push_back(instance(1, placed({0, 0.006F, 0})));
    return aggregate_of({wall, ball}, instances);
}

} // namespace scree::tests
