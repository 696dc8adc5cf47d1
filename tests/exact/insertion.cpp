// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/exact/insertion.h"

#include "tests/exact/climb.h"

#include <map>

namespace scree::tests {

namespace {

/// A new sample before the fields have given it an angle and a scale.
struct Dart {
    Vec2 position;
    std::uint32_t disk_class = 0;
    double turn = 0; // share of the class's range
    double margin = 0;
};

/// Uniform points of a region, by its triangles.
class RegionPoints {
  public:
    explicit RegionPoints(const Region& region) : region_(region) {
        for (const auto& t : region.triangles) {
            const Vec2& a = region.vertices[t[0]];
            area_ += cross(region.vertices[t[1]] - a, region.vertices[t[2]] - a) / 2;
            up_to_.push_back(area_);
        }
    }

    Vec2 draw(Random& random) const {
        const auto found = std::ranges::upper_bound(up_to_, random.uniform() * area_);
        const auto& t =
            region_
                .triangles[std::size_t(std::min(found, std::prev(up_to_.end())) - up_to_.begin())];
        double u = random.uniform();
        double v = random.uniform();
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        const Vec2& a = region_.vertices[t[0]];
        return a + (region_.vertices[t[1]] - a) * u + (region_.vertices[t[2]] - a) * v;
    }

  private:
    const Region& region_;
    std::vector<double> up_to_; // summed areas
    double area_ = 0;
};

class Search {
  public:
    Search(const DiskSet& set, const std::optional<Box2>& window) : set_(set), window_(window) {
        for (const DiskClass& c : set.problem().classes)
            steepest_ = std::max({steepest_, set.reach() / c.length, set.reach() / c.width});
    }

    double margin(const Dart& dart) const {
        return set_.margin(set_.sample(dart.position, dart.disk_class, dart.turn));
    }

    /// The largest margin at places of the domain that a climb from the dart visits.
    double climb(const Dart& start, Random& random) const {
        double best = start.margin;
        const auto value = [&](const Place& step) {
            const Dart dart{place(start.position + Vec2(step[0], step[1]) * set_.reach()),
                            start.disk_class, std::clamp(start.turn + step[2], 0.0, 1.0)};
            const double found = margin(dart);
            const double out = outside(dart.position) / set_.reach();
            if (out <= 0)
                best = std::max(best, found);
            // A penalty outside the domain, steeper than any margin can rise there.
            return found - 2 * steepest_ * std::max(0.0, out);
        };
        constexpr double beyond_doubt = 1.001;
        tests::climb(value, {}, beyond_doubt, random);
        return best;
    }

  private:
    Vec2 place(Vec2 point) const {
        if (set_.problem().torus) {
            const Box2 box = bounds(*set_.problem().domain);
            for (unsigned axis = 0; axis < 2; ++axis)
                point[axis] -= set_.period()[axis] *
                               std::floor((point[axis] - box.min[axis]) / set_.period()[axis]);
        }
        return point;
    }

    /// Distance of a point from the area to be filled [m]; 0 or less inside.
    double outside(const Vec2& point) const {
        double out = 0;
        if (window_)
            out = std::max({window_->min.x - point.x, point.x - window_->max.x,
                            window_->min.y - point.y, point.y - window_->max.y});
        if (!set_.problem().torus && !contains(*set_.problem().domain, point))
            out = std::max(out, signed_distance(*set_.problem().domain, point));
        return out;
    }

    const DiskSet& set_;
    const std::optional<Box2>& window_;
    double steepest_ = 1; // maximum change of the margin per reach
};

} // namespace

Insertion try_to_insert(const DiskSet& set, std::size_t darts, std::uint64_t seed,
                        const std::optional<Box2>& window) {
    // With tens of darts per square, the best dart near a place with room has a larger margin.
    constexpr double worth_a_climb = 0.9;
    const Search search(set, window);
    const RegionPoints points(*set.problem().domain);
    const auto classes = static_cast<std::uint32_t>(set.problem().classes.size());
    Random random(seed, Purpose::test);
    Insertion found;
    std::map<std::array<std::int64_t, 3>, Dart> best; // dart of each square and class
    for (std::size_t i = 0; i < darts; ++i) {
        Dart dart{points.draw(random), static_cast<std::uint32_t>(i % classes), random.uniform()};
        if (window && !window->intersects(dart.position))
            continue;
        dart.margin = search.margin(dart);
        found.fitted += dart.margin >= 1 ? 1 : 0;
        found.highest = std::max(found.highest, dart.margin);
        if (dart.margin < worth_a_climb)
            continue;
        const DiskClass& axes = set.problem().classes[dart.disk_class];
        const double square = std::min(axes.length, axes.width) / 1.5;
        Dart& there = best[{std::int64_t(std::floor(dart.position.x / square)),
                            std::int64_t(std::floor(dart.position.y / square)), dart.disk_class}];
        if (dart.margin > there.margin)
            there = dart;
    }
    for (const auto& [square_and_class, dart] : best) {
        const double height = search.climb(dart, random);
        ++found.climbs;
        found.reached += height >= 1 + 1e-9 ? 1 : 0;
        found.highest = std::max(found.highest, height);
    }
    return found;
}

} // namespace scree::tests
