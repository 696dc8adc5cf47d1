// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/mosaic_sites.h"

#include "core/random.h"

#include <algorithm>
#include <limits>

namespace scree::rocks {

namespace {

constexpr int candidates = 30;
constexpr double good_enough = 0.9; // distance to the nearest disk, in the disk's own radius

/// Disks in square buckets, to find the one whose border is nearest.
class Disks {
  public:
    Disks(const Box2& box, double side)
        : low_(box.min), side_(side), width_(1 + static_cast<int>(box.size().x / side)),
          depth_(1 + static_cast<int>(box.size().y / side)),
          buckets_(std::size_t(width_) * std::size_t(depth_)) {}

    void add(const Vec2& centre, double radius) {
        largest_ = std::max(largest_, radius);
        bucket(column(centre.x, low_.x, width_), column(centre.y, low_.y, depth_))
            .push_back({centre, radius});
    }

    /// The distance to the nearest disk's border, negative inside; at most `most`.
    double distance(const Vec2& p, double most) const {
        double nearest = most;
        const double reach = most + largest_;
        const int last_x = column(p.x + reach, low_.x, width_);
        const int last_z = column(p.y + reach, low_.y, depth_);
        for (int j = column(p.y - reach, low_.y, depth_); j <= last_z; ++j)
            for (int i = column(p.x - reach, low_.x, width_); i <= last_x; ++i)
                for (const Disk& disk : buckets_[index(i, j)])
                    nearest = std::min(nearest, (disk.centre - p).length() - disk.radius);
        return nearest;
    }

  private:
    struct Disk {
        Vec2 centre;
        double radius;
    };
    int column(double x, double low, int count) const {
        return std::clamp(static_cast<int>(std::floor((x - low) / side_)), 0, count - 1);
    }
    std::size_t index(int i, int j) const {
        return std::size_t(j) * std::size_t(width_) + std::size_t(i);
    }
    std::vector<Disk>& bucket(int i, int j) { return buckets_[index(i, j)]; }

    Vec2 low_;
    double side_;
    int width_;
    int depth_;
    double largest_ = 0;
    std::vector<std::vector<Disk>> buckets_;
};

} // namespace

std::vector<Vec2> spread_sites(const Region& domain, std::span<const double> areas,
                               std::uint64_t seed) {
    const Box2 box = bounds(domain);
    const Vec2 extent = box.size();
    Disks disks(box, 1.5 * std::sqrt(extent.x * extent.y / double(areas.size())));
    std::vector<Vec2> sites;
    sites.reserve(areas.size());
    for (std::size_t i = 0; i < areas.size(); ++i) {
        Random random(seed, Purpose::rock_cell, i);
        const double radius = std::sqrt(areas[i] / pi);
        double farthest = std::numeric_limits<double>::lowest();
        Vec2 best = box.center();
        for (int k = 0; k < candidates && farthest < good_enough * radius;) {
            const Vec2 p(random.uniform(box.min.x, box.max.x),
                         random.uniform(box.min.y, box.max.y));
            if (!contains(domain, p))
                continue;
            ++k;
            if (const double distance = disks.distance(p, radius); distance > farthest) {
                farthest = distance;
                best = p;
            }
        }
        sites.push_back(best);
        disks.add(best, radius);
    }
    return sites;
}

} // namespace scree::rocks
