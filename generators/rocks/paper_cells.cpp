// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/paper_cells.h"

#include "core/random.h"
#include "geometry/plane/power_diagram.h"

#include <algorithm>
#include <numeric>

namespace scree::rocks {

namespace {

// A disk set is taken to be full when so many darts in a row miss.
constexpr std::size_t most_misses = 100000;
constexpr double touching = 1e-9; // overlaps of this share of the cells' size are none

/// Numbers in square buckets over a box.
class Buckets {
  public:
    Buckets(const Box2& box, double side)
        : low_(box.min), side_(side), width_(1 + static_cast<int>(box.size().x / side)),
          depth_(1 + static_cast<int>(box.size().y / side)),
          members_(std::size_t(width_) * std::size_t(depth_)) {}

    void add(const Box2& box, std::size_t number) {
        each_bucket(box, [&](std::size_t b) { members_[b].push_back(number); });
    }

    template <class Found>
    bool any(const Box2& box, const Found& found) const {
        bool is = false;
        each_bucket(box, [&](std::size_t b) {
            is = is || std::any_of(members_[b].begin(), members_[b].end(), found);
        });
        return is;
    }

  private:
    template <class Visit>
    void each_bucket(const Box2& box, const Visit& visit) const {
        for (int j = column(box.min.y, low_.y, depth_); j <= column(box.max.y, low_.y, depth_); ++j)
            for (int i = column(box.min.x, low_.x, width_); i <= column(box.max.x, low_.x, width_);
                 ++i)
                visit(std::size_t(j) * std::size_t(width_) + std::size_t(i));
    }
    int column(double x, double low, int count) const {
        return std::clamp(static_cast<int>(std::floor((x - low) / side_)), 0, count - 1);
    }

    Vec2 low_;
    double side_;
    int width_;
    int depth_;
    std::vector<std::vector<std::size_t>> members_;
};

Box2 box_of(const Ring& ring) {
    Box2 box;
    for (const Vec2& p : ring)
        box.extendBy(p);
    return box;
}

std::vector<Vec2> throw_darts(const Region& domain, std::size_t wanted, double apart,
                              std::uint64_t seed, std::size_t size_class, const Context& context) {
    const Box2 box = bounds(domain);
    Buckets buckets(box, apart);
    Random random(seed, Purpose::rock_cell, size_class);
    std::vector<Vec2> sites;
    std::size_t misses = 0;
    while (sites.size() < wanted && misses < most_misses) {
        const Vec2 p(random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y));
        if (!contains(domain, p))
            continue;
        const bool hit = !buckets.any({p - Vec2(apart), p + Vec2(apart)}, [&](std::size_t i) {
            return (sites[i] - p).length2() < apart * apart;
        });
        misses = hit ? 0 : misses + 1;
        if (!hit)
            continue;
        buckets.add({p, p}, sites.size());
        sites.push_back(p);
        if (sites.size() % 1024 == 0)
            context.check_cancel();
    }
    return sites;
}

/// Whether an edge of `a` has all of `b` on its other side, but for a sliver.
bool separates(const Ring& a, const Ring& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec2 along = a[(i + 1) % a.size()] - a[i];
        const double sliver = touching * along.length2();
        if (std::all_of(b.begin(), b.end(),
                        [&](const Vec2& p) { return cross(along, p - a[i]) <= sliver; }))
            return true;
    }
    return false;
}

/// The classes by the mean area of their diagram's cells, largest first.
std::vector<std::size_t> by_size(const std::vector<std::vector<PowerCell>>& diagrams) {
    std::vector<std::size_t> order(diagrams.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return diagrams[a].size() < diagrams[b].size(); // they share one domain
    });
    return order;
}

} // namespace

PaperCells paper_cells(const Ring& domain, const RocksSettings& settings, const Context& context) {
    const double ground = std::abs(signed_area(domain));
    PaperCells out;
    std::vector<std::vector<PowerCell>> diagrams;
    double smallest = std::numeric_limits<double>::max();
    for (std::size_t c = 0; c < settings.classes.size(); ++c) {
        const double radius = settings.classes[c].radius;
        const auto wanted =
            static_cast<std::size_t>(std::lround(ground / cell_area(settings.classes[c])));
        const std::vector<Vec2> sites =
            throw_darts(*settings.domain, wanted, settings.half_exclusion ? radius / 2 : radius,
                        settings.seed, c, context);
        out.wanted.push_back(double(wanted));
        out.sites.push_back(double(sites.size()));
        diagrams.push_back(power_diagram(sites, {}, domain));
        smallest = std::min(smallest, radius);
    }
    out.shares.assign(settings.classes.size(), 0.0);
    Buckets buckets(bounds(*settings.domain), smallest);
    for (const std::size_t c : by_size(diagrams)) {
        std::vector<PowerCell>& cells = diagrams[c];
        Random random(settings.seed, Purpose::rock_cell, ~std::uint64_t{0} - c);
        for (std::size_t left = cells.size(); left > 0 && out.shares[c] < settings.classes[c].share;
             --left) {
            std::swap(cells[random.below(static_cast<std::uint32_t>(left))], cells[left - 1]);
            PowerCell& cell = cells[left - 1];
            const Box2 box = box_of(cell.ring);
            const bool overlaps = buckets.any(box, [&](std::size_t i) {
                return !separates(cell.ring, out.cells[i].ring) &&
                       !separates(out.cells[i].ring, cell.ring);
            });
            if (overlaps)
                continue;
            buckets.add(box, out.cells.size());
            out.shares[c] += cell.area / ground;
            out.cells.push_back({std::move(cell.ring), c});
        }
    }
    return out;
}

} // namespace scree::rocks
