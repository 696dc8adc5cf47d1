// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/drop.h"

#include "core/parallel.h"
#include "core/random.h"
#include "generators/rocks/tiles.h"

#include <algorithm>

namespace scree::rocks {

namespace {

constexpr double cells_along = 10;   // of the map, along the longest axis of an octave's smallest
constexpr double repeats_within = 3; // the longest axis: where a twin would be seen
constexpr double twin_angle = 30;    // rocks of one kind are twins when turned by less [deg]
constexpr double spread = 1.5;       // of the places that are tried, in longest axes
constexpr double usual_tilt = 12;    // of a rock that begins to fall, standard deviation [deg]
constexpr double perching = 2.5;     // times its size: rocks on which none stays
constexpr int tries_in_tile = 100;   // to draw a place in it
constexpr int most_kinds_tried = 8;  // of which none may have a twin nearby
constexpr int most_tries = 2;        // to find a place in one tile
constexpr double tile_side = 6;      // in longest axes
constexpr double tile_margin = 1.5;  // by which rocks may leave their tile, likewise
constexpr std::size_t triangles_of_grid = 2000; // surfaces with more get a TopGrid
constexpr int rounds = 4;                       // in which the tiles of an octave take turns
constexpr int late_rounds = 3;                  // for rocks that found no place, in other tiles

Imath::M33d rows_of(const WideVec3& x, const WideVec3& y, const WideVec3& z) {
    return {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
}

double angle_between(const Imath::M33d& a, const Imath::M33d& b) {
    double trace = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            trace += a[i][k] * b[i][k];
    return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0));
}

/// Rocks whose sizes are within a factor of two.
struct Octave {
    std::size_t first = 0;
    std::size_t end = 0;
    double largest = 0;
    double cell = 0;
};

std::vector<Octave> octaves_of(const std::vector<double>& sizes) {
    std::vector<Octave> octaves;
    for (std::size_t i = 0; i < sizes.size();) {
        Octave octave{.first = i, .end = i, .largest = sizes[i]};
        while (octave.end < sizes.size() && sizes[octave.end] > octave.largest / 2)
            ++octave.end;
        octave.cell = sizes[octave.end - 1] / cells_along;
        i = octave.end;
        octaves.push_back(octave);
    }
    return octaves;
}

Box2 map_area(const Region& domain, double largest) {
    const Box2 area = bounds(domain);
    return {area.min - Vec2(largest), area.max + Vec2(largest)};
}

class Dropping {
  public:
    Dropping(const DropProblem& problem, const Context& context)
        : problem_(problem), context_(context), rocks_(problem.sizes.size()),
          tops_(problem.sizes.size()) {}

    std::vector<PlacedRock> run() {
        for (const Octave& octave : octaves_of(problem_.sizes))
            drop(octave);
        return std::move(rocks_);
    }

  private:
    void drop(const Octave& octave);
    void drop_round(std::span<const std::uint32_t> numbers, int round, HeightMap& map);
    void drop_in_tile(std::span<const std::uint32_t> numbers, std::size_t tile, int round,
                      HeightMap& map);
    bool try_to_drop(std::uint32_t i, std::size_t tile, Random& random, RestingRock& rock,
                     const HeightMap& map);
    bool hang_over_lowest(const Vec2& near, double size, const MayBe& may_be, Random& random,
                          const HeightMap& map, RestingRock& rock) const;
    std::optional<Vec2> random_place(std::size_t i, const Box2& box, int tries,
                                     Random& random) const;
    Imath::M33d first_turn(Random& random) const;
    bool is_near_twin(std::uint32_t surface, std::size_t tile, const Vec2& place, double size,
                      const Imath::M33d& turn) const;
    /// Whether a rock of this size does not stay on top of another.
    bool is_perch(std::uint32_t below, double size, double height) const;

    const DropProblem& problem_;
    const Context& context_;
    std::vector<PlacedRock> rocks_;
    std::vector<std::shared_ptr<const TopGrid>> tops_;
    std::vector<Tiles> tiles_; // of the octaves so far
    double tile_margin_ = 0;   // of the last ones [m]
};

void Dropping::drop(const Octave& octave) {
    HeightMap map(map_area(problem_.domain, problem_.sizes.front()), octave.cell, problem_.ground);
    map.add(std::span(rocks_).first(octave.first), problem_.surfaces);
    tiles_.emplace_back(bounds(problem_.domain), tile_side * octave.largest);
    tile_margin_ = tile_margin * octave.largest;
    const std::size_t count = octave.end - octave.first;
    std::vector<std::uint32_t> left; // no place was found for them so far
    for (int round = 0; round < rounds + late_rounds; ++round) {
        std::vector<std::uint32_t> numbers = std::move(left);
        left.clear();
        if (round < rounds)
            for (std::size_t i = count * std::size_t(round) / rounds;
                 i < count * std::size_t(round + 1) / rounds; ++i)
                numbers.push_back(static_cast<std::uint32_t>(octave.first + i));
        drop_round(numbers, round, map);
        std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(left),
                     [&](std::uint32_t i) { return !rocks_[i].placed; });
        context_.report("dropping rocks", double(numbers.empty() ? octave.end : numbers.back()) /
                                              double(rocks_.size()));
    }
}

void Dropping::drop_round(std::span<const std::uint32_t> numbers, int round, HeightMap& map) {
    const Tiles& tiles = tiles_.back();
    std::vector<std::vector<std::uint32_t>> waiting(tiles.count());
    for (const std::uint32_t i : numbers) {
        Random random(derived_seed(problem_.seed, Purpose::rock_tile, std::uint64_t(round)),
                      Purpose::rock_tile, i);
        if (const auto place = random_place(i, bounds(problem_.domain), 10000, random))
            waiting[tiles.at(*place)].push_back(i);
    }
    // Tiles of one colour are too far apart to see each other's rocks.
    for (int colour = 0; colour < Tiles::colours; ++colour) {
        const std::vector<std::uint32_t> together = tiles.of_colour(colour);
        parallel_for(together.size(), 1, [&](std::size_t k) {
            context_.check_cancel();
            drop_in_tile(waiting[together[k]], together[k], round, map);
        });
    }
}

std::optional<Vec2> Dropping::random_place(std::size_t i, const Box2& box, int tries,
                                           Random& random) const {
    for (int k = 0; k < tries; ++k) {
        const Vec2 place(random.uniform(box.min.x, box.max.x),
                         random.uniform(box.min.y, box.max.y));
        const double chance = random.uniform();
        if (contains(problem_.domain, place) &&
            (!problem_.likely || chance < problem_.likely(place, problem_.sizes[i])))
            return place;
    }
    return std::nullopt;
}

Imath::M33d Dropping::first_turn(Random& random) const {
    // Rows: the images of the rock's axes a, c (upright) and b.
    const double spin = problem_.dip > 0 ? problem_.flow + pi / 2 + random.uniform(-0.5, 0.5)
                                         : random.uniform(0, 2 * pi);
    const WideVec3 along(std::cos(spin), 0, std::sin(spin));
    const Imath::M33d level = rows_of(along, {0, 1, 0}, along.cross(WideVec3(0, 1, 0)));
    // Then leaning with the flow, or any way.
    const double lean_to = problem_.dip > 0 ? problem_.flow : random.uniform(0, 2 * pi);
    const double lean = problem_.dip > 0
                            ? problem_.dip * random.uniform(0.6, 1.4)
                            : radians(usual_tilt) * std::sqrt(-2 * std::log(1 - random.uniform()));
    const WideVec3 axis =
        WideVec3(0, 1, 0).cross(WideVec3(std::cos(lean_to), 0, std::sin(lean_to)));
    return turned(level, Rotation(axis * lean));
}

bool Dropping::is_near_twin(std::uint32_t surface, std::size_t tile, const Vec2& place, double size,
                            const Imath::M33d& turn) const {
    bool found = false;
    const auto look = [&](std::uint32_t other) {
        const PlacedRock& rock = rocks_[other];
        if (found || rock.surface != surface)
            return;
        const double within = repeats_within * std::max(size, 2 * rock.scale);
        const Vec2 at(rock.centre.x, rock.centre.z);
        found = (at - place).length2() < within * within &&
                angle_between(turn, rock.world_from_rock) < radians(twin_angle);
    };
    // Of this octave only the tiles next to the rock's own are not being filled meanwhile.
    for (const Tiles& tiles : tiles_)
        tiles.each_near(&tiles == &tiles_.back() ? tile : tiles.at(place), look);
    return found;
}

bool Dropping::is_perch(std::uint32_t below, double size, double height) const {
    return below != HeightMap::no_rock && 2 * rocks_[below].scale > perching * size &&
           height > rocks_[below].centre.y;
}

bool Dropping::hang_over_lowest(const Vec2& near, double size, const MayBe& may_be, Random& random,
                                const HeightMap& map, RestingRock& rock) const {
    double lowest = std::numeric_limits<double>::max();
    for (int k = 0; k < problem_.candidates; ++k) {
        const Vec2 place =
            near + Vec2(random.uniform(-1, 1), random.uniform(-1, 1)) * spread * size;
        if (!may_be(place))
            continue;
        const int column = map.column(place.x);
        const int row = map.row(place.y);
        const double ground = problem_.ground.height(place);
        const double above = rock.rest(column, row, lowest + ground) - ground;
        if (above < lowest) {
            lowest = above;
            rock.hang_over(column, row);
        }
    }
    return lowest < 1e30;
}

bool Dropping::try_to_drop(std::uint32_t i, std::size_t tile, Random& random, RestingRock& rock,
                           const HeightMap& map) {
    const double size = problem_.sizes[i];
    Box2 box = tiles_.back().box(tile);
    const std::optional<Vec2> near = random_place(i, box, tries_in_tile, random);
    if (!near)
        return false;
    const Imath::M33d turn = first_turn(random);
    std::uint32_t surface = 0;
    for (int tries = 0; tries < most_kinds_tried; ++tries) {
        surface = problem_.surface_of(i, random.bits());
        if (!is_near_twin(surface, tile, *near, size, turn))
            break;
    }
    rock.take(problem_.surfaces[surface], size / 2, turn);
    box.min -= Vec2(tile_margin_);
    box.max += Vec2(tile_margin_);
    const auto may_be = [&](const Vec2& place) {
        const int column = map.column(place.x);
        const int row = map.row(place.y);
        return box.intersects(place) && contains(problem_.domain, place) &&
               problem_.ground.is_under(place) &&
               !is_perch(map.rock(column, row), size, map.height(column, row));
    };
    if (!hang_over_lowest(*near, size, may_be, random, map, rock) || !rock.settle(may_be))
        return false;
    const WideVec3 centre = rock.centre();
    const bool perches =
        std::any_of(rock.held_by().begin(), rock.held_by().end(),
                    [&](std::uint32_t below) { return is_perch(below, size, centre.y); });
    if (perches || is_near_twin(surface, tile, {centre.x, centre.z}, size, rock.world_from_rock()))
        return false;
    rocks_[i] = {surface, size / 2, centre, rock.world_from_rock(), true};
    return true;
}

void Dropping::drop_in_tile(std::span<const std::uint32_t> numbers, std::size_t tile, int round,
                            HeightMap& map) {
    const Neighbourhood around{map, problem_.ground, problem_.surfaces, rocks_, tops_};
    RestingRock rock(around, problem_.rest);
    for (const std::uint32_t i : numbers) {
        Random random(derived_seed(problem_.seed, Purpose::rock_place, std::uint64_t(round)),
                      Purpose::rock_place, i);
        for (int tries = 0; tries < most_tries && !rocks_[i].placed; ++tries) {
            if (!try_to_drop(i, tile, random, rock, map))
                continue;
            tiles_.back().add(tile, i);
            const RockSurface& surface = problem_.surfaces[rocks_[i].surface];
            map.add(rocks_[i], surface, i);
            if (surface.triangles.size() > triangles_of_grid)
                tops_[i] = std::make_shared<const TopGrid>(rock.vertices(), surface.triangles);
        }
    }
}

} // namespace

double map_cells(const Region& domain, double smallest, double largest) {
    const Vec2 area = map_area(domain, largest).size();
    return area.x * area.y * std::pow(cells_along / smallest, 2);
}

std::vector<PlacedRock> drop_rocks(const DropProblem& problem, const Context& context) {
    return Dropping(problem, context).run();
}

} // namespace scree::rocks
