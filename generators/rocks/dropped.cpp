// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/dropped.h"

#include "core/random.h"
#include "generators/rocks/drop.h"
#include "generators/rocks/rock_kinds.h"
#include "generators/rocks/rock_measure.h"
#include "model/stage_times.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree::rocks {

namespace {

constexpr double most_rocks = 5e6;
constexpr double most_triangles = 2e8;
constexpr double most_map_cells = 4e8;
constexpr double ground_beyond = 20; // of a shown plane, in sizes of the domain

/// Plan area of a rock as a share of the square of its longest axis.
double plan_fill(const RocksSettings& settings) { return pi / 4 * settings.rock.b_over_a; }

double expected_count(const RocksSettings& settings) {
    const double ground = area(*settings.domain);
    const double fill = plan_fill(settings);
    switch (settings.distribution) {
    case Distribution::power:
        return settings.cover * ground /
               (fill * power_mean_square(settings.smallest, settings.largest, settings.exponent));
    case Distribution::area:
        return area_count(settings.cover, settings.smallest, settings.largest, ground, fill);
    case Distribution::classes:
        break;
    }
    double count = 0;
    for (const SizeClass& size : settings.classes)
        count += size.share * settings.cover * ground / (fill * 4 / pi * cell_area(size));
    return count;
}

std::vector<double> sizes_of(const RocksSettings& settings) {
    const double ground = area(*settings.domain);
    const double fill = plan_fill(settings);
    switch (settings.distribution) {
    case Distribution::power:
        return power_sizes(settings.smallest, settings.largest, settings.exponent,
                           static_cast<std::size_t>(std::lround(expected_count(settings))),
                           settings.seed);
    case Distribution::area:
        return area_sizes(settings.cover, settings.smallest, settings.largest, ground, fill,
                          settings.seed);
    case Distribution::classes:
        break;
    }
    return class_sizes(settings.classes, settings.cover, ground, fill, settings.seed);
}

/// How likely a place is: by the density, and by what draws large rocks there and small ones away.
class Likelihood {
  public:
    Likelihood(const RocksSettings& settings, const Ground& ground, std::span<const double> sizes)
        : settings_(settings), ground_(ground) {
        const Box2 box = bounds(*settings.domain);
        if (settings.density)
            most_dense_ = settings.density->over(box).high;
        if ((settings.sorting == 0 && !settings.size) || sizes.empty())
            return;
        std::vector<double> pulls;
        Random random(settings.seed, Purpose::rock_place, ~std::uint64_t{0});
        for (int i = 0; i < 4096; ++i) {
            const Vec2 place(random.uniform(box.min.x, box.max.x),
                             random.uniform(box.min.y, box.max.y));
            if (contains(*settings.domain, place))
                pulls.push_back(pull(place));
        }
        pull_spread_ = mean_and_spread(pulls).second;
        least_pull_ = *std::min_element(pulls.begin(), pulls.end());
        greatest_pull_ = *std::max_element(pulls.begin(), pulls.end());
        std::vector<double> logs(sizes.begin(), sizes.end());
        for (double& size : logs)
            size = std::log(size);
        std::tie(log_size_, log_spread_) = mean_and_spread(logs);
    }

    bool is_even() const { return !settings_.density && !(pull_spread_ * log_spread_ > 0); }

    double operator()(const Vec2& place, double size) const {
        double likely = settings_.density ? settings_.density->at(place) / most_dense_ : 1;
        if (pull_spread_ * log_spread_ > 0) {
            // With the weight exp(t p), t small, the mean pull rises by t times its variance: so
            // that ln D rises by as much as the pull does, t is this.
            const double t = (std::log(size) - log_size_) / (log_spread_ * log_spread_);
            const double best = t > 0 ? greatest_pull_ : least_pull_;
            likely *= std::exp(t * (pull(place) - best));
        }
        return likely;
    }

  private:
    /// By how much ln D is to be greater at a place than elsewhere.
    double pull(const Vec2& place) const {
        return (settings_.size ? settings_.size->at(place) : 0) -
               settings_.sorting * ground_.height(place);
    }

    static std::pair<double, double> mean_and_spread(std::span<const double> values) {
        double sum = 0;
        double squares = 0;
        for (const double v : values) {
            sum += v;
            squares += v * v;
        }
        const double mean = sum / double(values.size());
        return {mean, std::sqrt(std::max(0.0, squares / double(values.size()) - mean * mean))};
    }

    const RocksSettings& settings_;
    const Ground& ground_;
    double most_dense_ = 1;
    double pull_spread_ = 0;
    double least_pull_ = 0;
    double greatest_pull_ = 0;
    double log_size_ = 0;
    double log_spread_ = 0;
};

Mesh shown_plane(const RocksSettings& settings) {
    const Box2 box = bounds(*settings.domain);
    const Vec2 beyond = box.size() * ground_beyond;
    const double rise = std::tan(settings.slope);
    Mesh mesh;
    mesh.name = "ground";
    const Vec2 low = box.min - beyond;
    const Vec2 high = box.max + beyond;
    for (const Vec2& p : {low, Vec2(low.x, high.y), high, Vec2(high.x, low.y)})
        mesh.positions.emplace_back(float(p.x), float(-rise * p.y), float(p.y));
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

void add_ground(const RocksSettings& settings, Aggregate& aggregate) {
    if (!settings.ground_material)
        return;
    const auto mesh =
        settings.ground ? settings.ground : std::make_shared<const Mesh>(shown_plane(settings));
    aggregate.instances.push_back(
        {.prototype = static_cast<std::uint32_t>(aggregate.prototypes.size()),
         .world_from_object = {}});
    aggregate.prototypes.push_back(
        {.name = "ground", .shape = mesh, .materials = {settings.ground_material}});
}

/// Prototypes of the surfaces that are used, and the instances.
void add_rocks(const RocksSettings& settings, const RockKinds& kinds,
               std::span<const PlacedRock> rocks, Aggregate& aggregate) {
    std::vector<std::uint32_t> prototype_of(kinds.surfaces().size(), ~0U);
    for (std::size_t i = 0; i < rocks.size(); ++i) {
        const PlacedRock& rock = rocks[i];
        if (!rock.placed)
            continue;
        std::uint32_t& prototype = prototype_of[rock.surface];
        const RockSurface& surface = kinds.surfaces()[rock.surface];
        if (prototype == ~0U) {
            prototype = static_cast<std::uint32_t>(aggregate.prototypes.size());
            Materials materials;
            if (!settings.materials.empty())
                materials = {
                    settings.materials[kinds.kind_of(rock.surface) % settings.materials.size()]};
            aggregate.prototypes.push_back(
                {.name = surface.mesh->name, .shape = surface.mesh, .materials = materials});
        }
        aggregate.instances.push_back(
            {.prototype = prototype,
             .world_from_object = world_from_mesh(rock, surface),
             .random = Random(settings.seed, Purpose::instance_attribute, i).uniform_float(),
             .scale = rock.scale});
    }
}

/// Throws Error, located, where the ground does not reach under all of the domain.
void check_ground(const RocksSettings& settings) {
    if (!settings.ground)
        return;
    constexpr int samples = 100; // along each side
    const Ground ground(*settings.ground);
    const Box2 box = bounds(*settings.domain);
    for (int j = 0; j <= samples; ++j)
        for (int i = 0; i <= samples; ++i) {
            const Vec2 at = box.min + box.size() * (Vec2(i, j) / double(samples));
            if (contains(*settings.domain, at) && !ground.is_under(at))
                throw settings.ground_place.error(
                    fmt::format("is not under all of the domain: not at x = {:.4g}, z = {:.4g}",
                                at.x, at.y),
                    "expected a larger ground, or a smaller domain");
        }
}

} // namespace

void check_dropped(const RocksSettings& settings) {
    check_ground(settings);
    const double count = expected_count(settings);
    double smallest = settings.smallest;
    double largest = settings.largest;
    if (settings.distribution == Distribution::classes) {
        const auto by_radius = [](const SizeClass& a, const SizeClass& b) {
            return a.radius < b.radius;
        };
        const auto [low, high] =
            std::minmax_element(settings.classes.begin(), settings.classes.end(), by_radius);
        smallest = low->radius;
        largest = 2 * high->radius;
    }
    if (const double cells = map_cells(*settings.domain, smallest, largest); cells > most_map_cells)
        throw settings.domain_place.error(
            fmt::format("is too large for its smallest rocks: a map of their tops has {:.2g} cells",
                        cells),
            fmt::format("expected at most {:.2g}: larger rocks or a smaller domain",
                        most_map_cells));
    if (count > most_rocks)
        throw settings.domain_place.error(
            fmt::format("holds about {:.2g} rocks of these sizes", count),
            fmt::format("expected at most {:.2g}: larger rocks, less cover or a smaller domain",
                        most_rocks));
    if (settings.unique) {
        const int level = settings.level > 0 ? settings.level : 4;
        const double triangles = count * 20 * level * level;
        if (triangles > most_triangles)
            throw settings.domain_place.error(
                fmt::format("holds about {:.2g} rocks, which with a shape of their own have {:.2g} "
                            "triangles",
                            count, triangles),
                fmt::format("expected at most {:.2g}: unique = false shares shapes",
                            most_triangles));
    }
}

Aggregate bake_dropped(const RocksSettings& settings, const Context& context) {
    StageTimes stages;
    const Ground ground = settings.ground ? Ground(*settings.ground) : Ground(settings.slope);
    const std::vector<double> sizes =
        settings.density && settings.density->over(bounds(*settings.domain)).high <= 0
            ? std::vector<double>{}
            : sizes_of(settings);
    const RockKinds kinds(settings, sizes);
    stages.end("shaping");

    const Likelihood likelihood(settings, ground, sizes);
    DropProblem problem{
        .ground = ground,
        .domain = *settings.domain,
        .surfaces = kinds.surfaces(),
        .sizes = sizes,
        .surface_of = [&](std::size_t i, std::uint32_t kind) { return kinds.surface_of(i, kind); },
        .likely = {},
        .rest = {.burial = settings.burial, .keep_turn = settings.dip > 0},
        .dip = settings.dip,
        .flow = settings.flow,
        .seed = settings.seed};
    if (!likelihood.is_even())
        problem.likely = [&](const Vec2& place, double size) { return likelihood(place, size); };
    const std::vector<PlacedRock> rocks = drop_rocks(problem, context);
    stages.end("dropping");

    Aggregate aggregate;
    aggregate.generator = "rocks";
    aggregate.seed = settings.seed;
    add_ground(settings, aggregate);
    add_rocks(settings, kinds, rocks, aggregate);
    const auto count = double(std::count_if(rocks.begin(), rocks.end(),
                                            [](const PlacedRock& rock) { return rock.placed; }));
    aggregate.facts = {{"count", count}, {"left_out", double(rocks.size()) - count}};
    if (settings.measure > 0) {
        add_measures(rocks, kinds.surfaces(), ground, settings.measure, aggregate.facts);
        stages.end("measuring");
    }
    stages.add_to(aggregate.facts);
    return aggregate;
}

} // namespace scree::rocks
