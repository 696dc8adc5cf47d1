// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/contact.h"

#include "core/parallel.h"

#include <algorithm>

namespace scree::fibres {

namespace {

constexpr float margin = 1.02F;         // of distances that are aimed at over those asked for
constexpr double slack = 0.75;          // [radii] of vertices between searches for pairs
constexpr float over_relaxation = 1.6F; // of the sum of moves over their weights
constexpr int stiff_iterations = 50;

/// The part of a slide along a surface that friction takes back, at most `most` [m] of it.
Vec3 taken_back(Vec3 slide, const Vec3& normal, float most) {
    slide -= normal * normal.dot(slide);
    const float length = slide.length();
    return length > most ? slide * (most / length) : slide;
}

/// Whether a chain comes nearer to a point beyond the end of its segment `i` [0, n) that `share` is
/// at; `away` leads from the point to that end. Contact is then the neighbouring segment's: that of
/// this end, which is inside the chain, would push along it.
bool is_nearer_beyond(const Vec3* chain, std::uint32_t i, std::uint32_t n, float share,
                      const Vec3& away) {
    if (share == 0 && i > 0)
        return away.dot(chain[i] - chain[i - 1]) > 0;
    return share == 1 && i + 1 < n && away.dot(chain[i + 2] - chain[i + 1]) < 0;
}

} // namespace

/// Sums of a fibre's moves, kept from fibre to fibre.
struct ContactSolver::Moves {
    std::vector<Vec3> sum;
    std::vector<float> weight;
};

ContactSolver::ContactSolver(Rods& rods, const Boundary& boundary, const ContactSettings& settings)
    : rods_(rods), boundary_(boundary), friction_(static_cast<float>(settings.friction)),
      pairs_(margin, slack * settings.radius), moved_(rods.points.size()), measures_(rods.count()),
      free_(rods.count(), 0), moves_(rods.count(), 1) {}

void ContactSolver::begin_step() {
    if (start_.empty()) {
        pairs_.update(rods_);
        pairs_.keep_slips();
        slid_.resize(rods_.count());
    } else {
        pairs_.slips().swap(slid_);
    }
    start_ = rods_.points;
}

bool ContactSolver::is_unmoved(std::size_t fibre) const {
    const std::span<const SegmentPairs::Pair> pairs = pairs_.of(fibre);
    return start_.empty() && free_[fibre] && !moves_[fibre] &&
           std::ranges::none_of(pairs, [&](const SegmentPairs::Pair& pair) {
               return moves_[pair.other / rods_.segments];
           });
}

void ContactSolver::gather(std::size_t fibre, Moves& moves, ContactMeasure& found) {
    const std::uint32_t n = rods_.segments;
    moves.sum.assign(n + 1, Vec3(0.0F));
    moves.weight.assign(n + 1, 0);
    const std::size_t first = fibre * (n + 1);
    const std::span<const SegmentPairs::Pair> pairs = pairs_.of(fibre);
    if (!start_.empty())
        slid_[fibre].assign(pairs.size(), Vec3(0.0F));
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const SegmentPairs::Pair& pair = pairs[k];
        const std::uint32_t i = pair.own;
        const std::uint32_t j = pair.other % n;
        const std::size_t other = pair.other + pair.other / n; // vertex
        const Vec3& p = rods_.points[first + i];
        const Vec3& q = rods_.points[other];
        const Vec3 d = rods_.points[first + i + 1] - p;
        const Vec3 e = rods_.points[other + 1] - q;
        const ClosestPoints near = closest_points(p, d, q, e);
        const float touching = rods_.radii[i] + near.s * (rods_.radii[i + 1] - rods_.radii[i]) +
                               rods_.radii[j] + near.t * (rods_.radii[j + 1] - rods_.radii[j]);
        const float aim = margin * touching;
        const float distance2 = near.between.length2();
        const float asked = only_overlaps_ ? touching : aim;
        if (distance2 >= asked * asked)
            continue;
        if (pair.other / n != fibre &&
            (is_nearer_beyond(&rods_.points[first], i, n, near.s, near.between) ||
             is_nearer_beyond(&rods_.points[other - j], j, n, near.t, -near.between)))
            continue;
        const float distance = std::sqrt(distance2);
        if (distance < touching) {
            found.deepest = std::max(found.deepest, touching - distance);
            ++found.overlaps;
        }
        Vec3 normal = near.between / distance;
        if (distance < 1e-4F * touching) { // axes that meet part at right angles to both
            const bool is_first = first + i < other;
            normal = d.cross(e).normalized() * (is_first ? 1.0F : -1.0F);
        }
        const std::array<float, 4> w{
            (1 - near.s) * rods_.mobility(i), near.s * rods_.mobility(i + 1),
            (1 - near.t) * rods_.mobility(j), near.t * rods_.mobility(j + 1)};
        const float norm = w[0] * w[0] + w[1] * w[1] + w[2] * w[2] + w[3] * w[3];
        if (norm == 0)
            continue;
        Vec3 move = normal * (aim - distance);
        if (!start_.empty()) {
            const auto slid = [&](std::size_t v) { return rods_.points[v] - start_[v]; };
            const Vec3 back = taken_back(pairs_.slips()[fibre][k] + slid(first + i) * (1 - near.s) +
                                             slid(first + i + 1) * near.s -
                                             slid(other) * (1 - near.t) - slid(other + 1) * near.t,
                                         normal, friction_ * (aim - distance));
            slid_[fibre][k] = back;
            move -= back;
        }
        move /= norm;
        moves.sum[i] += move * w[0];
        moves.sum[i + 1] += move * w[1];
        moves.weight[i] += w[0];
        moves.weight[i + 1] += w[1];
    }
}

ContactMeasure ContactSolver::measure() {
    pairs_.update(rods_);
    // With the speeds of steps, moves that overshoot would never come to rest.
    const float relaxation = start_.empty() ? over_relaxation : 1;
    const std::size_t n = rods_.vertices();
    constexpr std::size_t block = 16;
    const auto is_same = [&](std::size_t f) {
        return std::equal(&rods_.points[f * n], &rods_.points[f * n] + n, &moved_[f * n]);
    };
    parallel_for((rods_.count() + block - 1) / block, 1, [&](std::size_t b) {
        Moves moves;
        const std::size_t end = std::min(rods_.count(), (b + 1) * block);
        for (std::size_t f = b * block; f < end; ++f) {
            if (is_unmoved(f)) {
                std::copy_n(&rods_.points[f * n], n, &moved_[f * n]);
                continue;
            }
            measures_[f] = {};
            gather(f, moves, measures_[f]);
            for (std::uint32_t v = 0; v < n; ++v) {
                const Vec3 move = moves.sum[v] * (relaxation / std::max(1.0F, moves.weight[v]));
                moved_[f * n + v] = rods_.points[f * n + v] + move;
                if (rods_.mobility(v) > 0)
                    keep_to_bounds(f, v, measures_[f]);
            }
            free_[f] = is_same(f);
        }
    });
    ContactMeasure all;
    for (const ContactMeasure& one : measures_) {
        all.deepest = std::max(all.deepest, one.deepest);
        all.outside = std::max(all.outside, one.outside);
        all.overlaps += one.overlaps;
    }
    all.overlaps /= 2; // each is listed for both
    return all;
}

void ContactSolver::keep_to_bounds(std::size_t fibre, std::uint32_t v, ContactMeasure& found) {
    const std::size_t vertex = fibre * rods_.vertices() + v;
    const float keep = margin * rods_.radii[v];
    const float asked = keep - rods_.radii[v];
    const Vec3 now = rods_.points[vertex];
    Vec3& p = moved_[vertex];
    const auto measure = [&](const Excess& excess) {
        found.outside = std::max(found.outside, excess.distance - asked);
    };
    const bool stays = p == now;
    if (!stays)
        boundary_.each_excess(now, keep, measure);
    boundary_.each_excess(p, keep, [&](const Excess& excess) {
        if (stays)
            measure(excess);
        if (only_overlaps_ && excess.distance <= asked)
            return;
        p += excess.back;
        if (!start_.empty())
            p -= taken_back(p - start_[vertex], excess.outward, friction_ * excess.distance);
    });
}

void ContactSolver::apply(float stiffness) {
    only_overlaps_ = start_.empty() && stiffness == 0;
    constexpr std::size_t block = 16;
    parallel_for((rods_.count() + block - 1) / block, 1, [&](std::size_t b) {
        LengthWork work;
        const std::size_t end = std::min(rods_.count(), (b + 1) * block);
        for (std::size_t f = b * block; f < end; ++f) {
            moves_[f] = stiffness > 0 || !free_[f];
            if (!moves_[f])
                continue;
            const Rod rod = rod_of(rods_, f, moved_);
            follow_segments(rod);
            if (stiffness > 0)
                restore_shape(rod, stiffness);
            restore_lengths(rod, work);
        }
    });
    rods_.points.swap(moved_);
}

ContactResult resolve_contact(Rods& rods, const Boundary& boundary, const ContactSettings& settings,
                              const Context& context) {
    ContactSolver solver(rods, boundary, settings);
    const auto tolerance = static_cast<float>(settings.tolerance * settings.radius);
    ContactResult result;
    for (;; ++result.iterations) {
        context.check_cancel();
        result.measure = solver.measure();
        if (result.measure.within(tolerance) || result.iterations == settings.max_iterations)
            break;
        context.report("contact", double(result.iterations) / settings.max_iterations);
        const float share =
            std::max(0.0F, 1 - static_cast<float>(result.iterations) / stiff_iterations);
        solver.apply(static_cast<float>(settings.stiffness) * share);
    }
    result.searches = solver.searches();
    return result;
}

} // namespace scree::fibres
