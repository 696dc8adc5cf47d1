// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/rock_measure.h"

#include "core/parallel.h"
#include "geometry/mesh/nearest_surface.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace scree::rocks {

namespace {

/// Signed distances to a surface, in its own frame: negative inside.
class SurfaceDistance {
  public:
    explicit SurfaceDistance(const RockSurface& surface)
        : surface_(surface), mesh_{.name = {},
                                   .positions = surface.vertices,
                                   .normals = {},
                                   .uvs = {},
                                   .triangles = surface.triangles},
          nearest_(mesh_) {}

    /// At most `enough`, where that is not known to be more.
    double at(const WideVec3& p, double enough) const {
        if (p.length() - double(surface_.reach) > enough)
            return enough;
        const double distance = nearest_.nearest(p).distance;
        return std::min(enough, is_inside(p) ? -distance : distance);
    }

  private:
    // Seen from the origin of the mesh's frame, each direction meets one triangle.
    bool is_inside(const WideVec3& p) const {
        const WideVec3 origin(-surface_.centre);
        const WideVec3 d = p - origin;
        for (const Mesh::Triangle& t : mesh_.triangles) {
            const WideVec3 a = WideVec3(mesh_.positions[t[0]]) - origin;
            const WideVec3 b = WideVec3(mesh_.positions[t[1]]) - origin;
            const WideVec3 c = WideVec3(mesh_.positions[t[2]]) - origin;
            const double volume = a ^ b.cross(c);
            const double u = (d ^ b.cross(c)) / volume;
            const double v = (a ^ d.cross(c)) / volume;
            const double w = (a ^ b.cross(d)) / volume;
            if (u >= 0 && v >= 0 && w >= 0)
                return u + v + w < 1;
        }
        return false;
    }

    const RockSurface& surface_;
    Mesh mesh_;
    NearestSurface nearest_;
};

/// The distances of surfaces, made when they are first asked for.
class SurfaceDistances {
  public:
    explicit SurfaceDistances(std::span<const RockSurface> surfaces) : surfaces_(surfaces) {}

    const SurfaceDistance& of(std::uint32_t surface) {
        const std::scoped_lock lock(mutex_);
        std::unique_ptr<SurfaceDistance>& kept = made_[surface];
        if (!kept)
            kept = std::make_unique<SurfaceDistance>(surfaces_[surface]);
        return *kept;
    }

  private:
    std::span<const RockSurface> surfaces_;
    std::mutex mutex_;
    std::map<std::uint32_t, std::unique_ptr<SurfaceDistance>> made_;
};

struct Measured {
    double depth = 0; // of the deepest vertex in another rock
    double gap = std::numeric_limits<double>::max();
};

/// The least distance of a's vertices from b's surface [m]; negative: inside.
double least_distance(const PlacedRock& a, const RockSurface& surface, const PlacedRock& b,
                      const SurfaceDistance& distance, double enough) {
    std::vector<Vec3> vertices;
    pose_vertices(surface, a.world_from_rock, a.scale, vertices);
    const Imath::M33d to_b = b.world_from_rock.transposed();
    double least = enough;
    for (const Vec3& v : vertices) {
        const WideVec3 own = (WideVec3(v) + a.centre - b.centre) * to_b / b.scale;
        least = b.scale * distance.at(own, least / b.scale);
    }
    return least;
}

double percentile(std::vector<double> values, double share) {
    if (values.empty())
        return 0;
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Which rocks' bounding balls meet, by a sweep along x.
class Neighbours {
  public:
    Neighbours(std::span<const PlacedRock> rocks, std::span<const RockSurface> surfaces)
        : rocks_(rocks) {
        for (std::uint32_t i = 0; i < rocks.size(); ++i) {
            if (!rocks[i].placed)
                continue;
            reach_.emplace(i, double(surfaces[rocks[i].surface].reach) * rocks[i].scale);
            most_ = std::max(most_, reach_[i]);
            order_.push_back(i);
        }
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return rocks[a].centre.x < rocks[b].centre.x;
        });
    }

    const std::vector<std::uint32_t>& all() const { return order_; }

    template <class Found>
    void each(std::uint32_t i, const Found& found) const {
        const double reach = reach_.at(i);
        const WideVec3& centre = rocks_[i].centre;
        const auto first =
            std::lower_bound(order_.begin(), order_.end(), centre.x - reach - most_,
                             [&](std::uint32_t k, double x) { return rocks_[k].centre.x < x; });
        for (auto k = first; k != order_.end() && rocks_[*k].centre.x < centre.x + reach + most_;
             ++k) {
            const double touch = reach + reach_.at(*k);
            if (*k != i && (rocks_[*k].centre - centre).length2() < touch * touch)
                found(*k);
        }
    }

  private:
    std::span<const PlacedRock> rocks_;
    std::map<std::uint32_t, double> reach_;
    double most_ = 0;
    std::vector<std::uint32_t> order_;
};

/// The correlation of the logarithm of the size with the height of the centre.
double size_height_correlation(std::span<const PlacedRock> rocks) {
    double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (const PlacedRock& rock : rocks) {
        if (!rock.placed)
            continue;
        const double size = std::log(rock.scale);
        const double height = rock.centre.y;
        n += 1;
        x += size;
        y += height;
        xx += size * size;
        yy += height * height;
        xy += size * height;
    }
    const double spread = (n * xx - x * x) * (n * yy - y * y);
    return spread > 0 ? (n * xy - x * y) / std::sqrt(spread) : 0;
}

} // namespace

void add_measures(std::span<const PlacedRock> rocks, std::span<const RockSurface> surfaces,
                  const Ground& ground, std::size_t most, Facts& facts) {
    const Neighbours neighbours(rocks, surfaces);
    const std::vector<std::uint32_t>& all = neighbours.all();
    const std::size_t count = std::min(most, all.size());
    SurfaceDistances distances(surfaces);
    std::vector<Measured> measured(count);
    parallel_for(count, 1, [&](std::size_t k) {
        const std::uint32_t i = all[k * all.size() / count];
        const PlacedRock& rock = rocks[i];
        const RockSurface& surface = surfaces[rock.surface];
        Measured& found = measured[k];
        std::vector<Vec3> vertices;
        pose_vertices(surface, rock.world_from_rock, rock.scale, vertices);
        for (const Vec3& v : vertices) {
            const WideVec3 p = rock.centre + WideVec3(v);
            const double above = p.y - ground.height({p.x, p.z});
            found.gap = std::min(found.gap, std::max(0.0, above) / (2 * rock.scale));
        }
        neighbours.each(i, [&](std::uint32_t other) {
            const PlacedRock& near = rocks[other];
            const double apart = std::min(
                least_distance(rock, surface, near, distances.of(near.surface), rock.scale),
                least_distance(near, surfaces[near.surface], rock, distances.of(rock.surface),
                               rock.scale));
            const double size = 2 * std::min(rock.scale, near.scale);
            found.depth = std::max(found.depth, -apart / size);
            found.gap = std::min(found.gap, std::max(0.0, apart) / size);
        });
    });
    std::vector<double> depths;
    std::vector<double> gaps;
    for (const Measured& m : measured) {
        depths.push_back(m.depth);
        gaps.push_back(m.gap);
    }
    facts.emplace_back("measured", double(count));
    facts.emplace_back("depth_99", percentile(depths, 0.99));
    facts.emplace_back("depth_max", percentile(depths, 1));
    facts.emplace_back("gap_99", percentile(gaps, 0.99));
    facts.emplace_back("size_height_correlation", size_height_correlation(rocks));
}

} // namespace scree::rocks
