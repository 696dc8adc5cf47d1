// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/cell_layout.h"

#include "core/random.h"
#include "geometry/figures/placements.h"
#include "geometry/plane/region_tools.h"

#include <algorithm>

namespace scree {

namespace {

// Enough that no two neighbours look alike: each is also turned and scaled.
constexpr std::uint32_t outlines = 24;

// Steps of size per octave: a gap that is a little too small for one step is filled by the next.
constexpr double steps_per_octave = 4;

// Darts that must fail in a row before the next smaller size: the naive method's 10,000 would only
// add cells where the groove network closes the gap anyway.
constexpr std::uint64_t cancellations = 1500;

Ring cut_corners(const Ring& ring) {
    Ring cut;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& a = ring[i];
        const Vec2& b = ring[(i + 1) % ring.size()];
        cut.push_back(a * 0.75 + b * 0.25);
        cut.push_back(a * 0.25 + b * 0.75);
    }
    return cut;
}

} // namespace

double CellLayout::fill() const {
    double sum = 0;
    for (const Cell& cell : cells)
        sum += shapes[cell.shape].area() * cell.pose.scale * cell.pose.scale;
    return sum / (size * size);
}

Region cell_outline(double elongation, double irregularity, std::uint64_t seed,
                    std::uint64_t index) {
    Random random(seed, Purpose::leather_outline, index);
    const auto corners = 5 + random.below(4);
    const double phase = random.uniform();
    const double stretch = std::sqrt(elongation * (1 + 0.4 * irregularity * random.uniform(-1, 1)));
    Ring ring;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle =
            2 * pi * (i + phase + 0.38 * irregularity * random.uniform(-1, 1)) / corners;
        const double radius = 1 + 0.4 * irregularity * random.uniform(-1, 1);
        ring.emplace_back(radius * stretch * std::cos(angle), radius / stretch * std::sin(angle));
    }
    ring = cut_corners(cut_corners(ring));
    const double factor = std::sqrt(pi / 4 / std::abs(signed_area(ring)));
    for (Vec2& p : ring)
        p *= factor;
    return triangulate({ring});
}

CellLayout place_cells(double size, const std::vector<CellKind>& kinds, std::uint64_t seed,
                       std::uint64_t stream, const Context& context) {
    const auto torus = std::make_shared<Region>(
        triangulate({{{0.0, 0.0}, {size, 0.0}, {size, size}, {0.0, size}}}));
    LayoutProblem problem{
        .domain = DomainTest(torus, Inside::torus), .scale = kinds.front().scale, .seed = seed};
    for (const CellKind& kind : kinds) {
        problem.scale.low = std::min(problem.scale.low, kind.scale.low);
        problem.scale.high = std::max(problem.scale.high, kind.scale.high);
        for (std::uint32_t i = 0; i < outlines; ++i) {
            Region outline = cell_outline(kind.elongation, kind.irregularity, seed,
                                          (stream << 20) + problem.shapes.size());
            for (Ring& ring : outline.rings)
                for (Vec2& p : ring)
                    p *= kind.width;
            problem.shapes.emplace_back(outline);
        }
    }
    Placements placements(problem);
    std::uint64_t trial = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const CellKind& kind = kinds[k];
        const double octaves = std::log2(kind.scale.high / kind.scale.low);
        const int steps = std::max(1, static_cast<int>(std::ceil(octaves * steps_per_octave)));
        for (int step = 0; step < steps; ++step) {
            const double high = kind.scale.high * std::exp2(-octaves * step / steps);
            const double low = kind.scale.high * std::exp2(-octaves * (step + 1) / steps);
            for (std::uint64_t in_a_row = 0; in_a_row < cancellations; ++trial) {
                Random random(seed, Purpose::leather_cell, (stream << 40) | trial);
                Dart dart;
                dart.component = static_cast<std::uint32_t>(k * outlines) + random.below(outlines);
                const double angle = kind.direction + kind.direction_spread * random.uniform(-1, 1);
                const double scale = random.uniform(low, high);
                dart.pose =
                    FigurePose({random.uniform(0, size), random.uniform(0, size)}, angle, scale);
                in_a_row = placements.try_place(dart) ? 0 : in_a_row + 1;
                if (trial % 1024 == 0)
                    context.check_cancel();
            }
            context.report("placing cells", double(step + 1) / steps);
        }
    }
    CellLayout layout;
    layout.size = size;
    for (const Dart& dart : placements.darts())
        layout.cells.push_back({dart.component, dart.pose});
    layout.shapes = std::move(problem.shapes);
    return layout;
}

} // namespace scree
