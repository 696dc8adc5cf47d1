// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/image_outline.h"

#include <algorithm>
#include <cstdint>
#include <queue>
#include <tuple>

namespace scree {

namespace {

/// All vertices in square buckets.
class VertexGrid {
  public:
    VertexGrid(const std::vector<Vec2>& points, double bucket) : bucket_(bucket) {
        Box2 box;
        for (const Vec2& p : points)
            box.extendBy(p);
        origin_ = box.min;
        width_ = 1 + static_cast<std::size_t>((box.max.x - box.min.x) / bucket);
        const std::size_t height = 1 + static_cast<std::size_t>((box.max.y - box.min.y) / bucket);
        buckets_.resize(width_ * height);
        for (std::uint32_t v = 0; v < points.size(); ++v)
            at(points[v]).push_back(v);
    }

    void remove(std::uint32_t v, const Vec2& point) { std::erase(at(point), v); }

    /// Whether `test` holds for a vertex in the box.
    template <class Test>
    bool any(const Box2& box, const Test& test) const {
        for (std::size_t y = row(box.min.y); y <= row(box.max.y); ++y)
            for (std::size_t x = column(box.min.x); x <= column(box.max.x); ++x)
                for (const std::uint32_t v : buckets_[y * width_ + x])
                    if (test(v))
                        return true;
        return false;
    }

  private:
    std::size_t column(double x) const {
        return static_cast<std::size_t>((x - origin_.x) / bucket_);
    }
    std::size_t row(double y) const { return static_cast<std::size_t>((y - origin_.y) / bucket_); }
    std::vector<std::uint32_t>& at(const Vec2& p) {
        return buckets_[row(p.y) * width_ + column(p.x)];
    }

    double bucket_;
    Vec2 origin_;
    std::size_t width_ = 1;
    std::vector<std::vector<std::uint32_t>> buckets_;
};

class Simplifier {
  public:
    Simplifier(const std::vector<Ring>& rings, double tolerance, std::vector<Vec2> points)
        : tolerance_(tolerance), points_(std::move(points)), grid_(points_, 4 * bucket(rings)) {
        for (const Ring& ring : rings) {
            const auto first = static_cast<std::uint32_t>(links_.size());
            const auto count = static_cast<std::uint32_t>(ring.size());
            for (std::uint32_t i = 0; i < count; ++i)
                links_.push_back({first + (i + count - 1) % count, first + (i + 1) % count, 0,
                                  static_cast<std::uint32_t>(rings_.size()), true});
            rings_.push_back({first, count, count});
        }
        for (std::uint32_t v = 0; v < links_.size(); ++v)
            consider(v);
    }

    std::vector<Ring> run() {
        while (!queue_.empty()) {
            const auto [moved, v, version] = queue_.top();
            queue_.pop();
            const Link& link = links_[v];
            if (link.alive && link.version == version && rings_[link.ring].left > 3 && is_free(v))
                remove(v);
        }
        std::vector<Ring> out;
        for (const RingPart& ring : rings_) {
            out.emplace_back();
            for (std::uint32_t v = ring.first; v < ring.first + ring.count; ++v)
                if (links_[v].alive)
                    out.back().push_back(points_[v]);
        }
        return out;
    }

  private:
    struct Link {
        std::uint32_t previous;
        std::uint32_t next;
        std::uint32_t version;
        std::uint32_t ring;
        bool alive;
    };
    struct RingPart {
        std::uint32_t first;
        std::uint32_t count;
        std::uint32_t left;
    };
    // Ties are broken by index, so that equal input gives equal output.
    using Step = std::tuple<double, std::uint32_t, std::uint32_t>;

    /// The mean length of an edge.
    static double bucket(const std::vector<Ring>& rings) {
        double length = 0;
        std::size_t count = 0;
        for (const Ring& ring : rings)
            for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++, ++count)
                length += (ring[i] - ring[j]).length();
        return length > 0 ? length / double(count) : 1;
    }

    /// Queues the removal of v with the distance by which it would move any point.
    void consider(std::uint32_t v) {
        const Link& link = links_[v];
        const Vec2& a = points_[link.previous];
        const Vec2& b = points_[link.next];
        const RingPart& ring = rings_[link.ring];
        double moved = 0;
        std::uint32_t at = link.previous;
        do {
            at = at + 1 == ring.first + ring.count ? ring.first : at + 1;
            moved = std::max(moved, segment_distance(points_[at], a, b));
        } while (at != link.next && moved <= tolerance_);
        if (moved <= tolerance_)
            queue_.emplace(moved, v, link.version);
    }

    /// Whether no other vertex lies in or very near the triangle that is cut off with v: then the
    /// edge that replaces v neither crosses nor touches another.
    bool is_free(std::uint32_t v) const {
        const Link& link = links_[v];
        const std::uint32_t p = link.previous, n = link.next;
        Vec2 a = points_[p], b = points_[v], c = points_[n];
        if (cross(b - a, c - a) < 0)
            std::swap(a, b);
        Box2 box(a);
        box.extendBy(b);
        box.extendBy(c);
        const double margin = 1e-6 * tolerance_;
        const auto is_left = [&](const Vec2& from, const Vec2& to, const Vec2& q) {
            return cross(to - from, q - from) >= -margin * (to - from).length();
        };
        return !grid_.any(box, [&](std::uint32_t other) {
            const Vec2& q = points_[other];
            return other != p && other != v && other != n && is_left(a, b, q) && is_left(b, c, q) &&
                   is_left(c, a, q);
        });
    }

    void remove(std::uint32_t v) {
        Link& link = links_[v];
        link.alive = false;
        --rings_[link.ring].left;
        grid_.remove(v, points_[v]);
        links_[link.previous].next = link.next;
        links_[link.next].previous = link.previous;
        for (const std::uint32_t neighbour : {link.previous, link.next}) {
            ++links_[neighbour].version;
            consider(neighbour);
        }
    }

    double tolerance_;
    std::vector<Vec2> points_;
    VertexGrid grid_;
    std::vector<Link> links_;
    std::vector<RingPart> rings_;
    std::priority_queue<Step, std::vector<Step>, std::greater<>> queue_;
};

} // namespace

void simplify_within(std::vector<Ring>& rings, double tolerance) {
    if (!(tolerance > 0))
        return;
    std::vector<Vec2> points;
    for (const Ring& ring : rings)
        points.insert(points.end(), ring.begin(), ring.end());
    if (!points.empty())
        rings = Simplifier(rings, tolerance, std::move(points)).run();
}

} // namespace scree
