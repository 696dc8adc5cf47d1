// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/cells/cells_specs.h"

#include "core/random.h"
#include "procedurals/solid/cells/cells_source.h"
#include "procedurals/solid/cells/hewn_source.h"

#include <cmath>

namespace scree {

solid::Warp make_warp(const Params& params, double turbulence, unsigned use, double stretch) {
    return {placement(params, solid_frame(params), 200 + use, 1, stretch),
            as_float(turbulence * cell_length(params))};
}

solid::Cells make_cells(const Params& params, unsigned use, double width, double stretch,
                        double jitter) {
    const SolidFrame frame = solid_frame(params);
    Random random(static_cast<std::uint64_t>(params.integer("seed")), Purpose::solid_cell, use);
    solid::Cells cells{};
    cells.key = random.bits();
    cells.jitter = as_float(jitter);
    // The grid of isotropic cells is rotated randomly, so that it is not aligned with an object's
    // faces.
    const double turn = random.uniform(0, 2 * pi), tilt = stretch == 1 ? 0.7 : 0;
    const auto along = [](const Vec3& a, double x, const Vec3& b, double y) {
        return a * static_cast<float>(x) + b * static_cast<float>(y);
    };
    const Vec3 right = along(frame.right, std::cos(turn), frame.up, std::sin(turn));
    const Vec3 up = frame.axis.cross(right);
    const Vec3 axis = along(frame.axis, std::cos(tilt), right, std::sin(tilt));
    const Vec3 side = axis.cross(up) * -1.0F;
    const double lengths[3] = {width, width, width * stretch};
    const Vec3 rows[3] = {side, up, axis};
    for (int i = 0; i < 3; ++i) {
        const Vec3 row = rows[i] / as_float(lengths[i]);
        cells.rows[i] = as_triple(row);
        const double offset = random.uniform() - double(row.dot(frame.origin));
        (i == 0 ? cells.offset.x : i == 1 ? cells.offset.y : cells.offset.z) = as_float(offset);
        (i == 0   ? cells.squares.x
         : i == 1 ? cells.squares.y
                  : cells.squares.z) = as_float(1 / (lengths[i] * lengths[i]));
    }
    return cells;
}

solid::Hewn make_hewn(const Params& params, double height, double size, double stretch) {
    const double scale = size / params.number("size");
    return {placement(params, solid_frame(params), stretch == 1 ? 300 : 0, scale, stretch),
            as_float(height)};
}

ParamSpec turbulence_spec(std::string doc) {
    return preset_number("turbulence", std::move(doc) + ", in 64ths of `size`.", "", 0, 1000);
}

std::string cells_program(const std::vector<const char*>& texts) {
    std::string program = std::string(cells_source) + hewn_source;
    for (const char* text : texts)
        program += text;
    return program;
}

} // namespace scree
