// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/segment_pairs.h"

#include "core/parallel.h"

#include <algorithm>
#include <atomic>

namespace scree::fibres {

namespace {

Vec3 middle_of(const Rods& rods, std::size_t segment) {
    const std::size_t v = segment + segment / rods.segments;
    return (rods.points[v] + rods.points[v + 1]) * 0.5F;
}

} // namespace

bool SegmentPairs::is_valid(const Rods& rods) const {
    if (searched_.size() != rods.points.size())
        return false;
    std::atomic<bool> valid = true;
    const float most = slack_ * slack_;
    constexpr std::size_t block = 8192;
    parallel_for((searched_.size() + block - 1) / block, 1, [&](std::size_t b) {
        const std::size_t end = std::min(searched_.size(), (b + 1) * block);
        for (std::size_t i = b * block; i < end; ++i)
            if ((rods.points[i] - searched_[i]).length2() > most) {
                valid = false;
                return;
            }
    });
    return valid;
}

void SegmentPairs::update(const Rods& rods) {
    if (is_valid(rods))
        return;
    ++searches_;
    searched_ = rods.points;
    const float radius = *std::ranges::max_element(rods.radii);
    thickest_ = 2 * radius * margin_ + 2 * slack_;
    reach_ = (*std::ranges::max_element(rods.lengths)) * 1.01F + thickest_;
    fill_grid(rods);
    pairs_.resize(rods.count());
    parallel_for(rods.count(), 16, [&](std::size_t fibre) {
        if (slips_.empty())
            return list_pairs(rods, fibre);
        const std::vector<Pair> before = pairs_[fibre];
        list_pairs(rods, fibre);
        carry_slips(fibre, before);
    });
}

void SegmentPairs::keep_slips() {
    slips_.resize(pairs_.size());
    for (std::size_t fibre = 0; fibre < pairs_.size(); ++fibre)
        slips_[fibre].resize(pairs_[fibre].size(), Vec3(0.0F));
}

void SegmentPairs::carry_slips(std::size_t fibre, std::span<const Pair> before) {
    const std::vector<Pair>& pairs = pairs_[fibre];
    std::vector<Vec3> slips(pairs.size(), Vec3(0.0F));
    const auto key = [](const Pair& pair) { return std::pair(pair.own, pair.other); };
    std::size_t old = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        while (old < before.size() && key(before[old]) < key(pairs[k]))
            ++old;
        if (old < before.size() && key(before[old]) == key(pairs[k]))
            slips[k] = slips_[fibre][old];
    }
    slips_[fibre] = std::move(slips);
}

void SegmentPairs::fill_grid(const Rods& rods) {
    const std::size_t segments = rods.count() * rods.segments;
    entries_.resize(segments);
    cell_of_.resize(segments);
    Box3 box;
    for (const Vec3& p : rods.points)
        box.extendBy(p);
    // Empty cells all around, so that every segment has 27; hardly more cells than segments.
    for (cell_ = reach_;; cell_ *= 1.2F) {
        double cells = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const float count = std::floor(box.size()[axis] / cell_) + 3;
            size_[std::size_t(axis)] = static_cast<std::uint32_t>(std::min(count, 1e6F));
            cells *= double(count);
        }
        if (cells < 4.0 * double(segments) + 1000)
            break;
    }
    corner_ = box.min - Vec3(cell_);
    parallel_for(segments, 4096, [&](std::size_t s) {
        const Vec3 at = (middle_of(rods, s) - corner_) / cell_;
        std::array<std::uint32_t, 3> c{};
        for (int axis = 0; axis < 3; ++axis)
            c[std::size_t(axis)] =
                std::clamp(static_cast<std::uint32_t>(at[axis]), 1U, size_[std::size_t(axis)] - 2);
        cell_of_[s] = (c[2] * size_[1] + c[1]) * size_[0] + c[0];
    });
    first_.assign(std::size_t(size_[0]) * size_[1] * size_[2] + 1, 0);
    for (const std::uint32_t cell : cell_of_)
        ++first_[cell + 1];
    for (std::size_t i = 1; i < first_.size(); ++i)
        first_[i] += first_[i - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t s = 0; s < segments; ++s)
        entries_[next[cell_of_[s]]++] = {middle_of(rods, s), static_cast<std::uint32_t>(s)};
}

void SegmentPairs::list_pairs(const Rods& rods, std::size_t fibre) {
    const std::uint32_t n = rods.segments;
    const float radius = *std::ranges::max_element(rods.radii);
    // Segments of one fibre less than this apart are not paired.
    const auto apart =
        std::max(2U, 1 + static_cast<std::uint32_t>(std::ceil(4 * radius / rods.lengths[fibre])));
    std::vector<Pair>& pairs = pairs_[fibre];
    pairs.clear();
    for (std::uint32_t i = 0; i < n; ++i) {
        const Vec3& p = rods.points[fibre * (n + 1) + i];
        const Vec3 d = rods.points[fibre * (n + 1) + i + 1] - p;
        const Vec3 middle = p + d * 0.5F;
        const std::size_t before = pairs.size();
        const std::uint32_t here = cell_of_[fibre * n + i];
        for (std::uint32_t row = 0; row < 9; ++row) { // of three cells along x
            const std::uint32_t cell =
                here + ((row / 3) * size_[1] + row % 3) * size_[0] - (size_[1] + 1) * size_[0];
            for (std::uint32_t e = first_[cell - 1]; e < first_[cell + 2]; ++e) {
                const Entry& entry = entries_[e];
                if ((entry.middle - middle).length2() > reach_ * reach_)
                    continue;
                const std::uint32_t g = entry.segment / n;
                const std::uint32_t j = entry.segment % n;
                if (g == fibre && (i < j ? j - i : i - j) < apart)
                    continue;
                const Vec3& q = rods.points[entry.segment + g];
                const ClosestPoints near =
                    closest_points(p, d, q, rods.points[entry.segment + g + 1] - q);
                if (near.between.length2() < thickest_ * thickest_)
                    pairs.push_back({i, entry.segment});
            }
        }
        std::sort(pairs.begin() + std::ptrdiff_t(before), pairs.end(),
                  [](const Pair& a, const Pair& b) { return a.other < b.other; });
    }
}

} // namespace scree::fibres
