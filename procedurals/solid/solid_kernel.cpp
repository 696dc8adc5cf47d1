// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/device.h"
#include "procedurals/solid/lattice/fluctuation_source.h"
#include "procedurals/solid/lattice/lattice_source.h"
#include "procedurals/solid/solid_procedural.h"
#include "procedurals/solid/solid_source.h"

#include <algorithm>
#include <string>

namespace scree {

namespace {

// Points per batch: some tens of megabytes on the device.
constexpr std::size_t batch = std::size_t(1) << 18;

// Work-group size. Small, since some textures have large private arrays, and CPU devices keep those
// of a group on one thread's stack.
constexpr std::size_t group = 64;

std::string program(const SolidKernel& kernel) {
    const std::string settings = kernel.settings_type;
    return std::string(lattice_source) + fluctuation_source + solid_source + kernel.source +
           "kernel void scree_bake(global const SolidPoint* points, global SolidSample* samples,\n"
           "    global const " +
           settings +
           "* settings, global const Lattice* lattice,\n"
           "    global const short* nodes16, global const float* nodes32, uint count) {\n"
           "    const size_t i = get_global_id(0);\n"
           "    if (i >= count)\n"
           "        return;\n"
           "    Field field;\n"
           "    field.lattice = lattice;\n"
           "    field.nodes16 = nodes16;\n"
           "    field.nodes32 = nodes32;\n"
           "    samples[i] = " +
           kernel.function + "(field, settings, points[i]);\n}\n";
}

} // namespace

void run_solid_kernel(Device& device, const SolidKernel& kernel,
                      std::span<const std::byte> settings, const FractalLattice& lattice,
                      std::span<const ShadingPoint> points, std::span<ShadingSample> samples) {
    const std::string source = program(kernel);
    const Device::BufferHandle settings_buffer = device.upload(settings);
    const Device::BufferHandle header = device.upload(std::span(&lattice.header(), 1));
    const Device::BufferHandle nodes16 = device.upload(lattice.nodes16());
    const Device::BufferHandle nodes32 = device.upload(lattice.nodes32());
    const std::size_t capacity = std::min(batch, points.size());
    const Device::BufferHandle in = device.allocate(capacity * sizeof(solid::SolidPoint));
    const Device::BufferHandle out = device.allocate(capacity * sizeof(solid::SolidSample));
    std::vector<solid::SolidPoint> sent(capacity);
    std::vector<solid::SolidSample> found(capacity);
    for (std::size_t first = 0; first < points.size(); first += batch) {
        const std::size_t count = std::min(batch, points.size() - first);
        std::transform(points.begin() + std::ptrdiff_t(first),
                       points.begin() + std::ptrdiff_t(first + count), sent.begin(), solid_point);
        device.write(in, sent.data(), count * sizeof(solid::SolidPoint));
        const std::size_t range = (count + group - 1) / group * group;
        const Device::Argument arguments[] = {
            in, out, settings_buffer, header, nodes16, nodes32, static_cast<std::uint32_t>(count)};
        device.run(source, "scree_bake", {&range, 1}, arguments, {&group, 1});
        device.read(out, found.data(), count * sizeof(solid::SolidSample));
        std::transform(found.begin(), found.begin() + std::ptrdiff_t(count),
                       samples.begin() + std::ptrdiff_t(first), shading_sample);
    }
}

} // namespace scree
