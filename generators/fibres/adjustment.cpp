// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/adjustment.h"

#include "core/device.h"
#include "generators/fibres/adjust_as_cpp.h"
#include "generators/fibres/adjust_source.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace scree::fibres {

namespace {

static_assert(sizeof(Pose) == 8 * sizeof(float) && sizeof(Vec3) == 3 * sizeof(float));

constexpr int most_nearest = 35;
constexpr int most_thesis = 1000;
constexpr double steady = 0.005;
const float thesis_half_angle = static_cast<float>(radians(1));

float* numbers(std::vector<Pose>& poses) { return &poses.front().centre.x; }
const float* numbers(const std::vector<Vec3>& points) { return &points.front().x; }

// Kernels keep arrays of a fibre on the stack, so that groups are of one.
void run(Device& device, const char* kernel, std::size_t count,
         std::span<const Device::Argument> arguments) {
    const std::size_t one = 1;
    device.run(adjust_source, kernel, {&count, 1}, arguments, {&one, 1});
}

/// Calls an iteration of the thesis's method, which leaves the numbers of vertices outside before
/// it in `outside`, until they are steady. Returns the number of iterations that moved fibres.
int until_steady(std::vector<std::int32_t>& outside, const Context& context,
                 const std::function<void()>& iterate) {
    double before = 0;
    for (int done = 0; done < most_thesis; ++done) {
        context.check_cancel();
        iterate();
        const double now = std::accumulate(outside.begin(), outside.end(), 0.0);
        if (now == 0)
            return done;
        if (done > 0 && before - now < steady * before)
            return done + 1;
        before = now;
    }
    return most_thesis;
}

} // namespace

int adjust_nearest(RigidFibres& fibres, const SignedDistanceGrid& target, double radius,
                   const Context& context) {
    if (fibres.poses.empty())
        return 0;
    const auto vertices = static_cast<std::int32_t>(fibres.vertices);
    const VoxelGrid& grid = target.grid();
    const Vec3 first = Vec3(grid.centre(0, 0, 0));
    const auto inverse_step = static_cast<float>(1 / grid.side);
    const auto keep = static_cast<float>(1.05 * radius);
    const auto still = static_cast<float>(0.05 * radius);
    const std::size_t count = fibres.poses.size();
    std::vector<std::int32_t> iterations(count);
    if (context.device == nullptr) {
        kernel_as_cpp::for_each_work_item(count, [&] {
            adjust_kernels::scree_adjust_nearest(
                numbers(fibres.local), vertices, numbers(fibres.poses), target.samples().data(),
                grid.count[0], grid.count[1], grid.count[2], first.x, first.y, first.z,
                inverse_step, keep, still, most_nearest, iterations.data());
        });
    } else {
        Device& device = *context.device;
        const auto poses = device.upload(fibres.poses);
        const auto done = device.upload(iterations);
        const Device::Argument arguments[] = {device.upload(fibres.local),
                                              vertices,
                                              poses,
                                              device.upload(target.samples()),
                                              grid.count[0],
                                              grid.count[1],
                                              grid.count[2],
                                              first.x,
                                              first.y,
                                              first.z,
                                              inverse_step,
                                              keep,
                                              still,
                                              most_nearest,
                                              done};
        run(device, "scree_adjust_nearest", count, arguments);
        device.read(poses, fibres.poses.data(), count * sizeof(Pose));
        device.read(done, iterations.data(), count * sizeof(std::int32_t));
    }
    return *std::ranges::max_element(iterations);
}

int adjust_thesis(RigidFibres& fibres, const NearestVertices& target,
                  std::span<const float> lengths, const Context& context) {
    if (fibres.poses.empty())
        return 0;
    const auto vertices = static_cast<std::int32_t>(fibres.vertices);
    const std::size_t count = fibres.poses.size();
    std::vector<float> shift(count);
    std::ranges::transform(lengths, shift.begin(), [](float length) { return 0.02F * length; });
    const float inverse_cell = 1 / target.cell;
    const float cosine = std::cos(thesis_half_angle);
    const float sine = std::sin(thesis_half_angle);
    const Vec3& corner = target.corner;
    std::vector<std::int32_t> outside(count);
    if (context.device == nullptr)
        return until_steady(outside, context, [&] {
            kernel_as_cpp::for_each_work_item(count, [&] {
                adjust_kernels::scree_adjust_thesis(
                    numbers(fibres.local), vertices, numbers(fibres.poses), target.surface.data(),
                    target.first.data(), target.nearest.data(), NearestVertices::side, corner.x,
                    corner.y, corner.z, inverse_cell, shift.data(), cosine, sine, outside.data());
            });
        });
    Device& device = *context.device;
    const auto poses = device.upload(fibres.poses);
    const auto counts = device.upload(outside);
    const Device::Argument arguments[] = {device.upload(fibres.local),
                                          vertices,
                                          poses,
                                          device.upload(target.surface),
                                          device.upload(target.first),
                                          device.upload(target.nearest),
                                          NearestVertices::side,
                                          corner.x,
                                          corner.y,
                                          corner.z,
                                          inverse_cell,
                                          device.upload(shift),
                                          cosine,
                                          sine,
                                          counts};
    const int iterations = until_steady(outside, context, [&] {
        run(device, "scree_adjust_thesis", count, arguments);
        device.read(counts, outside.data(), count * sizeof(std::int32_t));
    });
    device.read(poses, fibres.poses.data(), count * sizeof(Pose));
    return iterations;
}

} // namespace scree::fibres
