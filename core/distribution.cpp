// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace scree {

namespace {

constexpr float below_one = 0x1.fffffep-1F;

std::size_t cell_of(float x, std::size_t count) {
    return std::min(static_cast<std::size_t>(std::max(0.0F, x) * static_cast<float>(count)),
                    count - 1);
}

} // namespace

Distribution1D::Distribution1D(std::span<const float> weights)
    : cumulative_(weights.size() + 1, 0.0F), density_(weights.size(), 0.0F) {
    for (const float weight : weights)
        total_ += double(weight);
    if (!(total_ > 0))
        return;
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += double(weights[i]);
        cumulative_[i + 1] = static_cast<float>(sum / total_);
    }
    cumulative_.back() = 1;
    // Computed from the rounded sums, so that pdf and sample agree to the last bit.
    for (std::size_t i = 0; i < weights.size(); ++i)
        density_[i] = (cumulative_[i + 1] - cumulative_[i]) * static_cast<float>(weights.size());
    // guide_[i]: the first cell that u in [i / n, (i + 1) / n) can fall into.
    std::uint32_t cell = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const float u = static_cast<float>(i) / static_cast<float>(weights.size());
        while (cell + 1 < weights.size() && cumulative_[cell + 1] <= u)
            ++cell;
        guide_.push_back(cell);
    }
}

float Distribution1D::pdf(float x) const {
    return density_.empty() ? 0 : density_[cell_of(x, density_.size())];
}

float Distribution1D::sample(float u, float& pdf) const {
    assert(total_ > 0);
    std::size_t cell = guide_[cell_of(u, guide_.size())];
    while (cell > 0 && cumulative_[cell] > u) // cell_of rounds
        --cell;
    while (cell + 1 < density_.size() && cumulative_[cell + 1] <= u)
        ++cell;
    const float low = cumulative_[cell];
    const float width = cumulative_[cell + 1] - low;
    const float part = width > 0 ? std::min((u - low) / width, below_one) : 0;
    pdf = density_[cell];
    // Rounding must not move x into the next cell, where the density may be 0.
    float x = std::min((static_cast<float>(cell) + part) / static_cast<float>(density_.size()),
                       below_one);
    while (cell_of(x, density_.size()) > cell)
        x = std::nextafter(x, 0.0F);
    return x;
}

Distribution2D::Distribution2D(std::span<const float> weights, int width, int height) {
    assert(weights.size() == std::size_t(width) * std::size_t(height));
    std::vector<float> sums;
    for (int y = 0; y < height; ++y) {
        columns_.emplace_back(
            weights.subspan(std::size_t(y) * std::size_t(width), static_cast<std::size_t>(width)));
        sums.push_back(static_cast<float>(columns_.back().total()));
    }
    rows_ = Distribution1D(sums);
}

float Distribution2D::pdf(const Vec2f& p) const {
    if (columns_.empty())
        return 0;
    return rows_.pdf(p.y) * columns_[cell_of(p.y, columns_.size())].pdf(p.x);
}

Vec2f Distribution2D::sample(const Vec2f& u, float& pdf) const {
    float pdf_y = 0;
    const float y = rows_.sample(u.y, pdf_y);
    float pdf_x = 0;
    const float x = columns_[cell_of(y, columns_.size())].sample(u.x, pdf_x);
    pdf = pdf_x * pdf_y;
    return {x, y};
}

} // namespace scree
