// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/region_tools.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <tuple>

namespace scree {

namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

/// The rings as one pool of linked vertices, and a queue of steps, those that move an edge least
/// first. Step "cut" removes a vertex that turns right, or not at all; its two edges become one.
/// Step "meet" removes an edge between two vertices that turn left; its neighbours are prolonged
/// until they meet. Both only add area on the left.
class Simplifier {
  public:
    Simplifier(const std::vector<Ring>& rings, double tolerance) : tolerance_(tolerance) {
        for (const Ring& ring : rings) {
            const auto first = static_cast<std::uint32_t>(vertices_.size());
            const auto count = static_cast<std::uint32_t>(ring.size());
            for (std::uint32_t i = 0; i < count; ++i)
                vertices_.push_back({ring[i], first + (i + count - 1) % count,
                                     first + (i + 1) % count, 0.0, 0, true});
            starts_.push_back(first);
            sizes_.push_back(count);
            ring_of_.insert(ring_of_.end(), count, static_cast<std::uint32_t>(starts_.size() - 1));
        }
        for (std::uint32_t v = 0; v < vertices_.size(); ++v)
            consider(v);
    }

    void run() {
        while (!queue_.empty()) {
            const Step step = queue_.top();
            queue_.pop();
            const Vertex& v = vertices_[step.vertex];
            if (!v.alive || v.version != step.version || sizes_[ring_of_[step.vertex]] <= 3)
                continue;
            if (step.meet)
                meet(step.vertex);
            else
                cut(step.vertex);
        }
    }

    std::vector<Ring> rings() const {
        std::vector<Ring> result;
        for (std::uint32_t start : starts_) {
            while (!vertices_[start].alive)
                start = vertices_[start].next;
            Ring ring;
            for (std::uint32_t v = start; ring.empty() || v != start; v = vertices_[v].next)
                ring.push_back(vertices_[v].position);
            result.push_back(std::move(ring));
        }
        return result;
    }

  private:
    struct Vertex {
        Vec2 position;
        std::uint32_t previous;
        std::uint32_t next;
        double moved; // bound of how far the edge to `next` has moved from where it was [m]
        std::uint32_t version;
        bool alive;
    };
    struct Step {
        double moved;
        std::uint32_t vertex; // to cut, or first of the edge to remove
        std::uint32_t version;
        bool meet;
        // A min-heap with ties broken by index, so that equal input gives equal output.
        bool operator<(const Step& other) const {
            return std::tie(moved, vertex, meet) > std::tie(other.moved, other.vertex, other.meet);
        }
    };

    double turn(std::uint32_t v) const {
        const Vertex& b = vertices_[v];
        return cross(b.position - vertices_[b.previous].position,
                     vertices_[b.next].position - b.position);
    }

    /// Where the neighbours of the edge from v meet, when they do on its right.
    bool meeting_point(std::uint32_t v, Vec2& p) const {
        const Vertex& b = vertices_[v];
        const Vertex& c = vertices_[b.next];
        const Vec2 in = b.position - vertices_[b.previous].position;
        const Vec2 out = c.position - vertices_[c.next].position;
        const double denominator = cross(in, out);
        const Vec2 edge = c.position - b.position;
        const double s = cross(edge, out) / denominator;
        const double t = cross(edge, in) / denominator;
        p = b.position + in * s;
        return denominator != 0 && s > 0 && t > 0 && std::isfinite(p.x) && std::isfinite(p.y);
    }

    /// Queues the steps that are possible at v now.
    void consider(std::uint32_t v) {
        const Vertex& b = vertices_[v];
        const Vertex& a = vertices_[b.previous];
        const Vertex& c = vertices_[b.next];
        if (turn(v) <= 0) {
            const double moved =
                segment_distance(b.position, a.position, c.position) + std::max(a.moved, b.moved);
            if (moved <= tolerance_)
                queue_.push({moved, v, b.version, false});
        } else if (Vec2 p; turn(b.next) > 0 && meeting_point(v, p)) {
            const double moved = segment_distance(p, b.position, c.position) + b.moved;
            if (moved <= tolerance_)
                queue_.push({moved, v, b.version, true});
        }
    }

    /// Whether the closed triangle (a, b, c), turning left, is free of all vertices but `except`.
    bool is_free(const Vec2& a, const Vec2& b, const Vec2& c,
                 const std::array<std::uint32_t, 4>& except, bool edges_too) const {
        Box2 box(a);
        box.extendBy(b);
        box.extendBy(c);
        for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
            const Vertex& vertex = vertices_[v];
            if (!vertex.alive)
                continue;
            const Vec2& p = vertex.position;
            const Vec2& q = vertices_[vertex.next].position;
            if (std::max(p.x, q.x) < box.min.x || std::min(p.x, q.x) > box.max.x ||
                std::max(p.y, q.y) < box.min.y || std::min(p.y, q.y) > box.max.y)
                continue;
            const bool p_excepted = std::find(except.begin(), except.end(), v) != except.end();
            if (!p_excepted && cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 &&
                cross(a - c, p - c) >= 0)
                return false;
            const bool q_excepted =
                std::find(except.begin(), except.end(), vertex.next) != except.end();
            if (edges_too && !(p_excepted && q_excepted) && cuts(a, b, p, q))
                return false;
        }
        return true;
    }

    static bool cuts(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
        return cross(b - a, p - a) * cross(b - a, q - a) <= 0 &&
               cross(q - p, a - p) * cross(q - p, b - p) <= 0;
    }

    void cut(std::uint32_t v) {
        Vertex& b = vertices_[v];
        Vertex& a = vertices_[b.previous];
        Vertex& c = vertices_[b.next];
        if (turn(v) < 0 &&
            !is_free(a.position, c.position, b.position, {b.previous, v, b.next, nobody}, false))
            return;
        a.moved = segment_distance(b.position, a.position, c.position) + std::max(a.moved, b.moved);
        a.next = b.next;
        c.previous = b.previous;
        remove(v);
        touch(b.previous);
    }

    void meet(std::uint32_t v) {
        Vertex& b = vertices_[v];
        Vertex& a = vertices_[b.previous];
        Vertex& c = vertices_[b.next];
        Vec2 p;
        if (!meeting_point(v, p) ||
            !is_free(b.position, p, c.position, {b.previous, v, b.next, c.next}, true))
            return;
        const double moved = segment_distance(p, b.position, c.position) + b.moved;
        a.moved = std::max(a.moved, moved);
        c.moved = std::max(c.moved, moved);
        c.position = p;
        c.previous = b.previous;
        a.next = b.next;
        remove(v);
        touch(b.next);
    }

    void remove(std::uint32_t v) {
        vertices_[v].alive = false;
        --sizes_[ring_of_[v]];
    }

    /// Queues the steps around v anew after a change.
    void touch(std::uint32_t v) {
        v = vertices_[vertices_[v].previous].previous;
        for (int i = 0; i < 5; ++i, v = vertices_[v].next) {
            ++vertices_[v].version;
            consider(v);
        }
    }

    double tolerance_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> ring_of_;
    std::vector<std::uint32_t> starts_;
    std::vector<std::uint32_t> sizes_;
    std::priority_queue<Step> queue_;
};

} // namespace

void simplify_outward(std::vector<Ring>& rings, double tolerance) {
    Simplifier simplifier(rings, tolerance);
    simplifier.run();
    rings = simplifier.rings();
}

} // namespace scree
