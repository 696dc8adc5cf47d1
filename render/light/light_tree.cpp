// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/light/light_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace scree {

namespace {

// Weighed one by one: few lights are chosen by what each of them gives.
constexpr std::size_t cut_size = 8;
constexpr std::size_t bins = 12;

float unit_dot(const Vec3& a, const Vec3& b) { return std::clamp(a.dot(b), -1.0F, 1.0F); }

// The weighted mean of a node's light at its centre cannot be told from that at the rim by less.
constexpr float nearest = 0.5F; // of the ball's radius

} // namespace

// The smallest cone about both, as Conty Estevez & Kulla 2018, algorithm 1.
void LightTree::Bounds::extend(const Bounds& other) {
    power += other.power;
    if (other.angle < 0)
        return;
    if (angle < 0) {
        box = other.box;
        axis = other.axis;
        angle = other.angle;
        return;
    }
    box.extendBy(other.box);
    const bool wider = angle >= other.angle;
    const Vec3 wide = wider ? axis : other.axis;
    const Vec3 thin = wider ? other.axis : axis;
    const float wide_angle = std::max(angle, other.angle);
    const float thin_angle = std::min(angle, other.angle);
    const float between = std::acos(unit_dot(wide, thin));
    axis = wide;
    angle = wide_angle;
    if (std::min(between + thin_angle, pi_f) <= wide_angle)
        return;
    angle = (wide_angle + between + thin_angle) / 2;
    const Vec3 side = thin - wide * unit_dot(wide, thin);
    if (angle >= pi_f || side.length() < 1e-6F) {
        angle = pi_f;
        return;
    }
    const float turn = angle - wide_angle;
    axis = (wide * std::cos(turn) + side.normalized() * std::sin(turn)).normalized();
}

// The surface area orientation heuristic: power, area and solid angle of the emission.
double LightTree::Bounds::cost() const {
    if (angle < 0)
        return 0;
    const Vec3 size = box.size();
    const double area = 2.0 * (double(size.x) * double(size.y) + double(size.y) * double(size.z) +
                               double(size.z) * double(size.x));
    const double cone = double(angle);
    const double emitting = std::min(cone + pi / 2, pi);
    const double measure = 2 * pi * (1 - std::cos(cone)) +
                           pi / 2 *
                               (2 * emitting * std::sin(cone) - std::cos(cone - 2 * emitting) -
                                2 * cone * std::sin(cone) + std::cos(cone));
    return double(power) * std::max(area, 1e-12) * measure;
}

LightTree::Bounds LightTree::bounds_of(const AreaSampler& light) {
    Bounds bounds;
    for (const Vec3& corner : light.corners())
        bounds.box.extendBy(corner);
    bounds.axis = light.normal();
    bounds.angle = 0;
    bounds.power = light.power();
    return bounds;
}

LightTree::LightTree(std::span<const AreaSampler> lights)
    : lights_(lights.begin(), lights.end()), leaf_of_(lights.size()) {
    if (lights.empty())
        return;
    std::vector<Bounds> bounds;
    for (const AreaSampler& light : lights)
        bounds.push_back(bounds_of(light));
    std::vector<std::uint32_t> order(lights.size());
    std::iota(order.begin(), order.end(), 0U);
    nodes_.reserve(2 * lights.size());
    nodes_.emplace_back();
    build(0, order, bounds);
    find_cut();
}

void LightTree::build(std::uint32_t index, std::span<std::uint32_t> lights,
                      std::span<const Bounds> bounds) {
    Bounds all;
    for (const std::uint32_t light : lights)
        all.extend(bounds[light]);
    Node& node = nodes_[index];
    node.centre = all.box.center();
    node.radius = all.box.size().length() / 2;
    node.axis = all.axis;
    node.cosine = std::cos(all.angle);
    node.sine = std::sin(all.angle);
    node.power = all.power;
    if (lights.size() == 1) {
        node.leaf = true;
        node.first = lights[0];
        leaf_of_[lights[0]] = index;
        return;
    }
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    node.first = first;
    nodes_.resize(nodes_.size() + 2);
    nodes_[first].parent = nodes_[first + 1].parent = index;
    const std::size_t left = split(lights, bounds);
    build(first, lights.first(left), bounds);
    build(first + 1, lights.subspan(left), bounds);
}

// Sorts the lights so that the first ones, whose number is returned, make one child, by the
// cheapest of the planes between bins along each axis.
std::size_t LightTree::split(std::span<std::uint32_t> lights, std::span<const Bounds> bounds) {
    Box3 centres;
    for (const std::uint32_t light : lights)
        centres.extendBy(bounds[light].box.center());
    const Vec3 size = centres.size();
    const float longest = std::max({size.x, size.y, size.z});
    double best = std::numeric_limits<double>::infinity();
    int best_axis = 0;
    std::size_t best_bin = 0;
    const auto bin_of = [&](std::uint32_t light, int axis) {
        const float part = (bounds[light].box.center()[axis] - centres.min[axis]) / size[axis];
        return std::min(bins - 1, static_cast<std::size_t>(part * float(bins)));
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (!(size[axis] > 0))
            continue;
        std::array<Bounds, bins> each;
        for (const std::uint32_t light : lights)
            each[bin_of(light, axis)].extend(bounds[light]);
        std::array<double, bins> above{}; // cost of all bins from this one
        Bounds sum;
        for (std::size_t i = bins; i-- > 1;) {
            sum.extend(each[i]);
            above[i] = sum.cost();
        }
        Bounds below;
        for (std::size_t i = 1; i < bins; ++i) {
            below.extend(each[i - 1]);
            const double thin = double(longest) / double(size[axis]); // avoids thin boxes
            const double cost = thin * (below.cost() + above[i]);
            if (below.angle >= 0 && above[i] > 0 && cost < best) {
                best = cost;
                best_axis = axis;
                best_bin = i;
            }
        }
    }
    if (best_bin == 0) // all at one place
        return lights.size() / 2;
    const auto middle =
        std::stable_partition(lights.begin(), lights.end(), [&](std::uint32_t light) {
            return bin_of(light, best_axis) < best_bin;
        });
    return static_cast<std::size_t>(middle - lights.begin());
}

void LightTree::find_cut() {
    cut_ = {0};
    for (std::size_t i = 0; cut_.size() < cut_size && i < cut_.size();) {
        const Node& node = nodes_[cut_[i]];
        if (node.leaf) {
            ++i;
            continue;
        }
        cut_.erase(cut_.begin() + static_cast<std::ptrdiff_t>(i));
        cut_.push_back(node.first);
        cut_.push_back(node.first + 1);
    }
}

// The irradiance of one light; of several, as if all were as well turned and placed as their
// bounds allow: 0 only if that of each is.
float LightTree::weight(const Node& node, const Vec3& point) const {
    if (node.leaf)
        return lights_[node.first].irradiance(point);
    const Vec3 way = point - node.centre;
    const float square = way.dot(way);
    const float radius2 = node.radius * node.radius;
    const float away = std::max(square, nearest * nearest * radius2);
    if (square <= radius2)
        return node.power / away;
    // The angle between the axis and the way to the point, less those of the cone and of the ball.
    const float distance = std::sqrt(square);
    const float cos_way = std::clamp(node.axis.dot(way) / distance, -1.0F, 1.0F);
    const float sin_way = std::sqrt(1 - cos_way * cos_way);
    const float sin_ball = node.radius / distance;
    const float cos_ball = std::sqrt(1 - sin_ball * sin_ball);
    // Each difference of angles is not below 0.
    float cosine = 1;
    float sine = 0;
    if (cos_way < node.cosine) {
        cosine = cos_way * node.cosine + sin_way * node.sine;
        sine = sin_way * node.cosine - cos_way * node.sine;
    }
    if (cosine < cos_ball)
        cosine = cosine * cos_ball + sine * sin_ball;
    else
        cosine = 1;
    return cosine > 0 ? node.power * cosine / away : 0;
}

float LightTree::irradiance(const Vec3& point) const {
    float sum = 0;
    for (const std::uint32_t node : cut_)
        sum += weight(nodes_[node], point);
    return sum;
}

LightTree::Choice LightTree::choose(const Vec3& point, float u) const {
    std::array<float, cut_size> weights{};
    float total = 0;
    for (std::size_t i = 0; i < cut_.size(); ++i)
        total += weights[i] = weight(nodes_[cut_[i]], point);
    if (!(total > 0))
        return {};
    float left = u * total;
    std::size_t chosen = 0;
    float remaining = 0; // of `left` within the chosen weight
    for (std::size_t i = 0; i < cut_.size(); ++i)
        if (weights[i] > 0) { // by rounding, `left` may exceed the last one's weight
            chosen = i;
            remaining = left;
            if (left < weights[i])
                break;
            left -= weights[i];
        }
    Choice choice;
    choice.probability = weights[chosen] / total;
    float v = std::min(remaining / weights[chosen], 1 - 0x1p-24F);
    const Node* node = &nodes_[cut_[chosen]];
    while (!node->leaf) {
        const float a = weight(nodes_[node->first], point);
        const float b = weight(nodes_[node->first + 1], point);
        if (!(a + b > 0))
            return {};
        const float p = a / (a + b);
        const bool first = v < p;
        v = std::min(first ? v / p : (v - p) / (1 - p), 1 - 0x1p-24F);
        choice.probability *= first ? p : 1 - p;
        node = &nodes_[node->first + (first ? 0 : 1)];
    }
    choice.light = node->first;
    return choice;
}

float LightTree::probability(std::uint32_t light, const Vec3& point) const {
    std::uint32_t index = leaf_of_[light];
    float probability = 1;
    while (std::ranges::find(cut_, index) == cut_.end()) {
        const std::uint32_t first = nodes_[nodes_[index].parent].first;
        const float a = weight(nodes_[first], point);
        const float b = weight(nodes_[first + 1], point);
        if (!(a + b > 0))
            return 0;
        const float p = a / (a + b);
        probability *= index == first ? p : 1 - p;
        index = nodes_[index].parent;
    }
    const float total = irradiance(point);
    return total > 0 ? probability * weight(nodes_[index], point) / total : 0;
}

} // namespace scree
