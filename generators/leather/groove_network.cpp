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

/// A cell's outline as floats in its own frame.
struct Outline {
    std::vector<Vec2f> points;
};

/// Signed distance to a polygon, negative inside, by edges and crossings.
float signed_distance(const Outline& outline, const Vec2f& p) {
    float squared = std::numeric_limits<float>::max();
    bool inside = false;
    const std::size_t n = outline.points.size();
    for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
        const Vec2f& a = outline.points[i];
        const Vec2f& b = outline.points[j];
        const Vec2f edge = b - a, to = p - a;
        const float t = std::clamp(to.dot(edge) / edge.dot(edge), 0.0F, 1.0F);
        const Vec2f rest = to - edge * t;
        squared = std::min(squared, rest.dot(rest));
        if ((a.y > p.y) != (b.y > p.y) && (edge.x * to.y < edge.y * to.x) == (edge.y > 0))
            inside = !inside;
    }
    return inside ? -std::sqrt(squared) : std::sqrt(squared);
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
            // No cell beyond the ring has its region nearer than this.
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
    /// No farther than this is the third nearest region, whose box centre may lie outside it.
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
    for (const CollisionShape& shape : layout.shapes) {
        Outline outline;
        for (const Vec2& p : shape.outline().rings.front())
            outline.points.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
        outlines.push_back(std::move(outline));
    }
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
