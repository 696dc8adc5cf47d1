// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/paper.h"

#include "core/parallel.h"
#include "core/random.h"
#include "generators/rocks/cell_rocks.h"
#include "generators/rocks/paper_cells.h"
#include "model/stage_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace scree::rocks {

namespace {

constexpr double sliver = 1e-4; // of a cell's size

/// A rock, and what is wrong with it.
struct PaperRock {
    Mesh mesh;
    bool folds = false; // a part of its upper side is turned over
};

/// The ring without corners that are no more than rounding: next to another one, or in line with
/// their neighbours.
Ring without_slivers(const Ring& ring) {
    const double size = std::sqrt(signed_area(ring));
    Ring out;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& before = out.empty() ? ring.back() : out.back();
        const Vec2& after = ring[(i + 1) % ring.size()];
        if ((ring[i] - before).length() > sliver * size &&
            segment_distance(ring[i], before, after) > sliver * size)
            out.push_back(ring[i]);
    }
    return out;
}

/// A point in the convex ring, uniformly.
Vec2 random_point(const Ring& ring, Random& random) {
    double at = random.uniform() * signed_area(ring);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const Vec2 a = ring[i] - ring[0];
        const Vec2 b = ring[i + 1] - ring[0];
        at -= cross(a, b) / 2;
        if (at > 0 && i + 2 < ring.size())
            continue;
        double u = random.uniform();
        double v = random.uniform();
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        return ring[0] + a * u + b * v;
    }
    return ring[0];
}

/// Section 3.3: as many inner points as the cell has corners, their Delaunay triangulation, and
/// their displacements (eqs. 2 and 3) with j in [0, 1].
PaperRock rock_on(const ChosenCell& cell, const RocksSettings& settings, std::size_t number) {
    Random random(settings.seed, Purpose::rock_shape, number);
    const Ring ring = without_slivers(cell.ring);
    const std::size_t corners = ring.size();
    std::vector<Vec2> points = ring;
    Vec2 middle(0.0, 0.0);
    for (std::size_t i = 0; i < corners; ++i) {
        points.push_back(random_point(ring, random));
        middle += points.back() / double(corners);
    }
    const std::vector<std::array<std::uint32_t, 3>> triangles = delaunay(points);

    const Swelling& swelling = settings.swellings[cell.size_class];
    const double of_rock = random.uniform();
    std::vector<Vec3> top;
    for (std::size_t i = 0; i < points.size(); ++i) {
        WideVec3 p(points[i].x, 0, points[i].y);
        if (i >= corners) {
            const WideVec3 share(1, of_rock, random.uniform());
            const Vec2 outwards = (points[i] - middle).normalized() * (swelling.widening ^ share);
            p += WideVec3(outwards.x, swelling.height ^ share, outwards.y);
        }
        top.emplace_back(p);
    }
    PaperRock rock;
    rock.mesh.name = fmt::format("rock_{}", number + 1);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto first = static_cast<std::uint32_t>(rock.mesh.positions.size());
        for (const std::uint32_t i : {a, b, c}) { // flat faces, as in the paper
            rock.mesh.positions.push_back(top[i]);
            rock.mesh.uvs.emplace_back(points[i]);
        }
        rock.mesh.triangles.push_back({first, first + 1, first + 2});
    };
    for (const auto& [a, b, c] : triangles) { // counter-clockwise in (x, z): from below
        add(a, c, b);
        rock.folds = rock.folds || (top[c] - top[a]).cross(top[b] - top[a]).y < 0;
    }
    // The base, about a corner of its own: a diagonal could also be an edge of the upper side.
    const auto base = static_cast<std::uint32_t>(points.size());
    points.push_back(std::accumulate(ring.begin(), ring.end(), Vec2(0.0)) / double(corners));
    top.emplace_back(WideVec3(points.back().x, 0, points.back().y));
    for (std::uint32_t i = 0; i < corners; ++i)
        add(base, i, static_cast<std::uint32_t>((i + 1) % corners));
    compute_normals(rock.mesh, 0);
    return rock;
}

} // namespace

Aggregate bake_paper(const RocksSettings& settings, const Context& context) {
    StageTimes stages;
    const Ring domain = convex_outline(settings);
    const PaperCells chosen = paper_cells(domain, settings, context);
    stages.end("cells");

    std::vector<PaperRock> rocks(chosen.cells.size());
    parallel_for(rocks.size(), 16,
                 [&](std::size_t i) { rocks[i] = rock_on(chosen.cells[i], settings, i); });
    stages.end("shaping");

    std::vector<Mesh> meshes;
    std::vector<double> counts(settings.classes.size(), 0.0);
    double folded = 0;
    for (std::size_t i = 0; i < rocks.size(); ++i) {
        meshes.push_back(std::move(rocks[i].mesh));
        folded += rocks[i].folds ? 1 : 0;
        ++counts[chosen.cells[i].size_class];
    }
    std::vector<std::size_t> kinds(meshes.size());
    std::iota(kinds.begin(), kinds.end(), std::size_t{0});
    Aggregate aggregate = aggregate_of(std::move(meshes), kinds, settings);
    aggregate.facts = {{"count", double(kinds.size())}};
    double covered = 0;
    for (std::size_t c = 0; c < counts.size(); ++c) {
        aggregate.facts.insert(aggregate.facts.end(),
                               {{fmt::format("sites_{}", c + 1), chosen.sites[c]},
                                {fmt::format("count_{}", c + 1), counts[c]},
                                {fmt::format("share_{}", c + 1), chosen.shares[c]}});
        covered += chosen.shares[c];
    }
    aggregate.facts.insert(aggregate.facts.end(), {{"gap", 1 - covered}, {"folded", folded}});
    stages.add_to(aggregate.facts);
    return aggregate;
}

} // namespace scree::rocks
