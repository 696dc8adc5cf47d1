// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/groove_network.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

namespace scree {

namespace {

constexpr int block = 16; // pixels along the edge of those that share candidates

using Float4 = float __attribute__((vector_size(16)));
using Mask4 = std::int32_t __attribute__((vector_size(16)));

/// Four edges of a cell's outline in the outline's frame, from `a` to `b`; the last four are filled
/// up with edges of no length.
struct Edges {
    Float4 ax, ay, by;
    Float4 x, y;    // b - a
    Float4 inverse; // of the squared length
};
using Outline = std::vector<Edges>;

Outline outline_of(const Ring& ring) {
    Outline outline((ring.size() + 3) / 4);
    for (std::size_t i = 0; i < 4 * outline.size(); ++i) {
        Edges& edges = outline[i / 4];
        const std::size_t lane = i % 4;
        const Vec2f a(ring[std::min(i, ring.size() - 1)]);
        const Vec2f b(i < ring.size() ? ring[(i + 1) % ring.size()] : ring.back());
        const Vec2f edge = b - a;
        edges.ax[lane] = a.x;
        edges.ay[lane] = a.y;
        edges.by[lane] = b.y;
        edges.x[lane] = edge.x;
        edges.y[lane] = edge.y;
        edges.inverse[lane] = edge.length2() > 0 ? 1 / edge.length2() : 0.0F;
    }
    return outline;
}

/// Signed distance to a polygon, negative inside: to the nearest edge, and by the parity of the
/// edges to the right.
float signed_distance(const Outline& outline, const Vec2f& p) {
    const Float4 zero{}, one = zero + 1;
    Float4 squared = zero + std::numeric_limits<float>::max();
    Mask4 inside{};
    for (const Edges& e : outline) {
        const Float4 to_x = p.x - e.ax, to_y = p.y - e.ay;
        Float4 t = (to_x * e.x + to_y * e.y) * e.inverse;
        t = t < zero ? zero : t;
        t = t > one ? one : t;
        const Float4 rest_x = to_x - e.x * t, rest_y = to_y - e.y * t;
        const Float4 here = rest_x * rest_x + rest_y * rest_y;
        squared = here < squared ? here : squared;
        inside ^= ((e.ay > p.y) ^ (e.by > p.y)) & ~((e.x * to_y < e.y * to_x) ^ (e.y > zero));
    }
    const float nearest =
        std::min(std::min(squared[0], squared[1]), std::min(squared[2], squared[3]));
    const bool is_inside = ((inside[0] ^ inside[1] ^ inside[2] ^ inside[3]) & 1) != 0;
    return is_inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

struct Candidate {
    std::uint32_t cell = 0;
    Vec2 centre; // the image nearest to the block
    double radius = 0;
};

/// Finds the cells near a point of the torus.
class CellIndex {
  public:
    explicit CellIndex(const CellLayout& layout) : layout_(layout) {
        for (const Cell& cell : layout.cells)
            largest_ = std::max(largest_, radius(cell));
        count_ = std::clamp(static_cast<int>(layout.size / largest_), 1, 4096);
        bins_.resize(std::size_t(count_) * std::size_t(count_));
        for (std::uint32_t i = 0; i < layout.cells.size(); ++i) {
            const Vec2& p = layout.cells[i].pose.position;
            bins_[bin_of(p.y) * std::size_t(count_) + bin_of(p.x)].push_back(i);
        }
    }

    /// All cells that can be among the three nearest of any point within `reach` of `point`.
    std::vector<Candidate> candidates(const Vec2& point, double reach) const {
        std::vector<Candidate> found;
        double third = 0;
        for (int ring = 1;; ring = std::min(2 * ring, count_)) {
            gather(point, ring, found);
            third = third_nearest(point, found);
            // The regions of cells beyond the ring are farther than this.
            const double certain = ring * layout_.size / count_ - largest_;
            if (2 * ring + 1 >= count_ || certain > third + 2 * reach)
                break;
        }
        std::erase_if(found, [&](const Candidate& c) {
            return (c.centre - point).length() - c.radius > third + 2 * reach;
        });
        // The near ones first: they rule out the others by their circles.
        std::stable_sort(found.begin(), found.end(), [&](const Candidate& a, const Candidate& b) {
            return (a.centre - point).length() - a.radius < (b.centre - point).length() - b.radius;
        });
        return found;
    }

  private:
    double radius(const Cell& cell) const {
        return layout_.shapes[cell.shape].radius() * cell.pose.scale;
    }
    std::size_t bin_of(double at) const {
        return std::size_t(std::min(count_ - 1, static_cast<int>(at / layout_.size * count_)));
    }
    void gather(const Vec2& point, int ring, std::vector<Candidate>& found) const {
        found.clear();
        const auto wrap = [&](int i) { return std::size_t((i % count_ + count_) % count_); };
        const int width = std::min(2 * ring + 1, count_);
        const int x0 = static_cast<int>(std::floor(point.x / layout_.size * count_)) - width / 2;
        const int y0 = static_cast<int>(std::floor(point.y / layout_.size * count_)) - width / 2;
        for (int j = 0; j < width; ++j)
            for (int i = 0; i < width; ++i)
                for (const std::uint32_t c :
                     bins_[wrap(y0 + j) * std::size_t(count_) + wrap(x0 + i)]) {
                    const Cell& cell = layout_.cells[c];
                    Vec2 offset = cell.pose.position - point;
                    offset.x -= layout_.size * std::round(offset.x / layout_.size);
                    offset.y -= layout_.size * std::round(offset.y / layout_.size);
                    found.push_back({c, point + offset, radius(cell)});
                }
    }
    /// An upper bound of the distance to the third nearest region: no region lies outside its
    /// circle.
    static double third_nearest(const Vec2& point, const std::vector<Candidate>& found) {
        std::array<double, 3> best;
        best.fill(std::numeric_limits<double>::infinity());
        for (const Candidate& c : found) {
            const double farthest = (c.centre - point).length() + c.radius;
            if (farthest < best[2]) {
                best[2] = farthest;
                std::sort(best.begin(), best.end());
            }
        }
        return best[2];
    }

    const CellLayout& layout_;
    double largest_ = 0;
    int count_ = 1;
    std::vector<std::vector<std::uint32_t>> bins_;
};

/// The three nearest regions of a point.
struct Nearest {
    std::array<float, 3> distance;
    std::uint32_t cell = 0;
    float along = 0;
};

Nearest nearest(const CellLayout& layout, const std::vector<Outline>& outlines,
                const std::vector<Candidate>& candidates, const Vec2& point) {
    Nearest result;
    result.distance.fill(std::numeric_limits<float>::max());
    for (const Candidate& c : candidates) {
        const Vec2 offset = point - c.centre;
        const double bound = c.radius + double(result.distance[2]);
        if (offset.length2() > bound * bound)
            continue;
        const Cell& cell = layout.cells[c.cell];
        const Vec2 turned(cell.pose.cosine * offset.x + cell.pose.sine * offset.y,
                          cell.pose.cosine * offset.y - cell.pose.sine * offset.x);
        const auto scale = static_cast<float>(cell.pose.scale);
        const Vec2f local(static_cast<float>(turned.x) / scale,
                          static_cast<float>(turned.y) / scale);
        const float d = signed_distance(outlines[cell.shape], local) * scale;
        if (d < result.distance[0]) {
            result = {{d, result.distance[0], result.distance[1]},
                      c.cell,
                      static_cast<float>(turned.x / c.radius)};
        } else if (d < result.distance[1]) {
            result.distance[2] = result.distance[1];
            result.distance[1] = d;
        } else if (d < result.distance[2]) {
            result.distance[2] = d;
        }
    }
    return result;
}

} // namespace

GrooveNetwork groove_network(const CellLayout& layout, int resolution, const Warp& warp,
                             const Context& context) {
    assert(layout.cells.size() >= 3);
    GrooveNetwork network;
    network.resolution = resolution;
    network.pixel = layout.size / resolution;
    const std::size_t pixels = std::size_t(resolution) * std::size_t(resolution);
    network.owner.resize(pixels);
    network.distance.resize(pixels);
    network.junction.resize(pixels);
    network.along.resize(pixels);

    std::vector<Outline> outlines;
    for (const CollisionShape& shape : layout.shapes)
        outlines.push_back(outline_of(shape.outline().rings.front()));
    const CellIndex cells(layout);
    const int blocks = (resolution + block - 1) / block;
    parallel_for(std::size_t(blocks), 1, [&](std::size_t row) {
        if (context.cancel != nullptr && context.cancel->requested())
            return;
        std::array<Vec2, std::size_t{block} * block> points;
        for (int column = 0; column < blocks; ++column) {
            Box2 box;
            int count = 0;
            const int y1 = std::min(resolution, (int(row) + 1) * block);
            const int x1 = std::min(resolution, (column + 1) * block);
            for (int y = int(row) * block; y < y1; ++y)
                for (int x = column * block; x < x1; ++x) {
                    const Vec2 p = Vec2(x + 0.5, y + 0.5) * network.pixel;
                    points[std::size_t(count)] = warp ? warp(p) : p;
                    box.extendBy(points[std::size_t(count++)]);
                }
            const std::vector<Candidate> candidates =
                cells.candidates(box.center(), box.size().length() / 2);
            count = 0;
            for (int y = int(row) * block; y < y1; ++y)
                for (int x = column * block; x < x1; ++x) {
                    const Nearest n =
                        nearest(layout, outlines, candidates, points[std::size_t(count++)]);
                    const std::size_t i = network.index(x, y);
                    network.owner[i] = n.cell;
                    network.distance[i] = (n.distance[1] - n.distance[0]) / 2;
                    network.junction[i] = (n.distance[2] - n.distance[0]) / 2;
                    network.along[i] = n.along;
                }
        }
    });
    context.check_cancel();
    return network;
}

} // namespace scree
