// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/mosaic.h"

#include "core/parallel.h"
#include "core/random.h"
#include "generators/rocks/cell_rocks.h"
#include "generators/rocks/mosaic_sites.h"
#include "generators/rocks/rock_kinds.h"
#include "geometry/rock/rock.h"
#include "model/stage_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace scree::rocks {

namespace {

constexpr double area_variation = 0.3; // of the cells of a class
constexpr int lloyd_steps = 5;
constexpr double lloyd_share = 0.7;  // of the way to the centroid
constexpr double rough_areas = 0.05; // relative error before a Lloyd step
constexpr double exact_areas = 5e-5; // and in the end
constexpr double cut_tilt = 0.28;    // of a cell's planes, standard deviation of the slope
constexpr double least_inset = 0.1;  // what a joint leaves of a cell, in its radius
constexpr int bare = -1;             // the class of cells without a rock

/// What a cell is for.
struct CellPlan {
    double area = 0; // [m^2]
    int size_class = bare;
};

/// Cells of all classes, and of bare ground where shares leave some; largest first.
std::vector<CellPlan> plan_cells(const RocksSettings& settings, double ground) {
    std::vector<CellPlan> plans;
    const auto add = [&](int size_class, double share, double usual) {
        const auto count =
            std::max<std::size_t>(1, std::size_t(std::lround(share * ground / usual)));
        Random random(settings.seed, Purpose::rock_size, std::uint64_t(size_class + 1));
        std::vector<double> weights;
        weights.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
            weights.push_back(1 + random.uniform(-area_variation, area_variation));
        const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
        for (const double weight : weights)
            plans.push_back({share * ground * weight / sum, size_class});
    };
    double shares = 0;
    for (std::size_t c = 0; c < settings.classes.size(); ++c) {
        add(static_cast<int>(c), settings.classes[c].share, cell_area(settings.classes[c]));
        shares += settings.classes[c].share;
    }
    if (shares < 1 - 1e-9) // as wide as the smallest rocks
        add(bare, 1 - shares,
            cell_area(*std::min_element(
                settings.classes.begin(), settings.classes.end(),
                [](const SizeClass& a, const SizeClass& b) { return a.radius < b.radius; })));
    std::stable_sort(plans.begin(), plans.end(),
                     [](const CellPlan& a, const CellPlan& b) { return a.area > b.area; });
    return plans;
}

PrescribedAreas fitted_cells(const RocksSettings& settings, const std::vector<CellPlan>& plans,
                             const Context& context) {
    const Ring domain = convex_outline(settings);
    std::vector<double> areas;
    areas.reserve(plans.size());
    for (const CellPlan& plan : plans)
        areas.push_back(plan.area);
    std::vector<Vec2> sites = spread_sites(*settings.domain, areas, settings.seed);
    PrescribedAreas fit;
    for (int step = 0; step <= lloyd_steps; ++step) {
        context.check_cancel();
        context.report("fitting cells", double(step) / (lloyd_steps + 1));
        fit = cells_of_areas(sites, areas, domain, step < lloyd_steps ? rough_areas : exact_areas,
                             std::move(fit.weights));
        if (step < lloyd_steps)
            for (std::size_t i = 0; i < sites.size(); ++i)
                sites[i] += lloyd_share * (fit.cells[i].centroid - sites[i]);
    }
    return fit;
}

/// The edges of a cell about its middle, moved inwards by half a joint.
struct Edge {
    Vec2 normal;   // outwards, of length 1
    double height; // of the edge above the middle, in the cell's radius
};

std::vector<Edge> edges_of(const PowerCell& cell, double radius, double joint) {
    std::vector<Edge> edges;
    for (std::size_t k = 0; k < cell.ring.size(); ++k) {
        const Vec2 along = cell.ring[(k + 1) % cell.ring.size()] - cell.ring[k];
        if (!(along.length() > 1e-9 * radius))
            continue;
        const Vec2 normal = Vec2(along.y, -along.x).normalized();
        const double away = (normal ^ (cell.ring[k] - cell.centroid)) - joint / 2;
        edges.push_back({normal, std::max(away / radius, least_inset)});
    }
    return edges;
}

Mesh rock_in_cell(const RocksSettings& settings, const PowerCell& cell, std::size_t number,
                  double largest) {
    const double radius = std::sqrt(cell.area / pi);
    const RockSettings rock = settings_of_kind(settings, number);
    const std::vector<Edge> edges = edges_of(cell, radius, settings.joint);
    // In the body's frame, z is up and the plan's z is -y; the height is scaled by c / a.
    Random random(settings.seed, Purpose::rock_cell, ~std::uint64_t{0} - number);
    std::vector<RockPlane> planes;
    for (const Edge& edge : edges) {
        const double tilt = cut_tilt * normal_vector(random).x; // wide at the top or at the foot
        planes.push_back({WideVec3(edge.normal.x, -edge.normal.y, tilt * rock.c_over_a),
                          edge.height + 0.5 * std::abs(tilt) * rock.c_over_a});
    }
    const auto limit = [&](const WideVec3& direction) {
        double nearest = 1e-9;
        for (const Edge& edge : edges)
            nearest = std::max(
                nearest, (edge.normal.x * direction.x + edge.normal.y * direction.z) / edge.height);
        return 1 / nearest;
    };
    const int level = level_of(settings, number, radius / largest);
    std::vector<WideVec3> vertices =
        Rock(rock, std::move(planes), WideVec3(1, 1, rock.c_over_a)).vertices(level, limit);
    double low = 0;
    double high = 0;
    for (const WideVec3& v : vertices) {
        low = std::min(low, v.y);
        high = std::max(high, v.y);
    }
    const double sunk = low + settings.burial * (high - low);
    for (WideVec3& v : vertices)
        v = WideVec3(cell.centroid.x, 0, cell.centroid.y) + (v - WideVec3(0, sunk, 0)) * radius;
    Mesh mesh = rock_mesh(vertices, level);
    mesh.name = fmt::format("rock_{}", number + 1);
    return mesh;
}

} // namespace

Aggregate bake_mosaic(const RocksSettings& settings, const Context& context) {
    StageTimes stages;
    const double ground = area(*settings.domain);
    const std::vector<CellPlan> plans = plan_cells(settings, ground);
    const PrescribedAreas fit = fitted_cells(settings, plans, context);
    stages.end("cells");

    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < plans.size(); ++i)
        if (plans[i].size_class != bare)
            shown.push_back(i);
    const double largest = std::sqrt(plans.front().area / pi);
    std::vector<Mesh> meshes(shown.size());
    parallel_for(shown.size(), 4, [&](std::size_t k) {
        context.check_cancel();
        meshes[k] = rock_in_cell(settings, fit.cells[shown[k]], shown[k], largest);
    });
    stages.end("shaping");

    Aggregate aggregate = aggregate_of(std::move(meshes), shown, settings);
    double covered = 0;
    std::vector<double> shares(settings.classes.size(), 0.0);
    std::vector<double> counts(settings.classes.size(), 0.0);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        covered += fit.cells[i].area;
        if (plans[i].size_class == bare)
            continue;
        shares[std::size_t(plans[i].size_class)] += fit.cells[i].area / ground;
        ++counts[std::size_t(plans[i].size_class)];
    }
    aggregate.facts = {{"count", double(shown.size())}};
    for (std::size_t c = 0; c < shares.size(); ++c) {
        aggregate.facts.emplace_back(fmt::format("count_{}", c + 1), counts[c]);
        aggregate.facts.emplace_back(fmt::format("share_{}", c + 1), shares[c]);
    }
    aggregate.facts.insert(aggregate.facts.end(), {{"gap", 1 - covered / ground},
                                                   {"cell_error", fit.error},
                                                   {"newton_steps", double(fit.steps)}});
    stages.add_to(aggregate.facts);
    return aggregate;
}

} // namespace scree::rocks
