// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/uv_gutter.h"

#include "core/parallel.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

constexpr std::int32_t nowhere = -1;

std::int64_t around(std::int64_t distance, std::int64_t size) {
    distance = std::abs(distance);
    return std::min(distance, size - distance);
}

int wrapped(int i, int size) { return i < 0 ? i + size : i >= size ? i - size : i; }

/// For one column: the nearest covered row of every row.
void nearest_rows(int x, int width, int height, const std::vector<bool>& covered,
                  std::vector<std::int32_t>& nearest) {
    const auto at = [&](int y) { return std::size_t(y) * std::size_t(width) + std::size_t(x); };
    const auto offer = [&](int y, std::int32_t row) {
        std::int32_t& best = nearest[at(y)];
        if (row != nowhere &&
            (best == nowhere || around(y - row, height) < around(y - best, height)))
            best = row;
    };
    // Two passes in each direction: the second one knows what lies across the border.
    std::int32_t last = nowhere;
    for (int i = 0; i < 2 * height; ++i) {
        const int y = i % height;
        last = covered[at(y)] ? y : last;
        offer(y, last);
    }
    last = nowhere;
    for (int i = 2 * height - 1; i >= 0; --i) {
        const int y = i % height;
        last = covered[at(y)] ? y : last;
        offer(y, last);
    }
}

/// One row: where the parabolas (x - column)^2 + (rows away)^2 are lowest.
class Envelope {
  public:
    void add(std::int64_t column, std::int64_t height2) {
        while (!parts_.empty()) {
            const Part& top = parts_.back();
            const double meet =
                double(column * column + height2 - top.column * top.column - top.height2) /
                double(2 * (column - top.column));
            if (meet > top.from) {
                parts_.push_back({column, height2, meet});
                return;
            }
            parts_.pop_back();
        }
        parts_.push_back({column, height2, -1e300});
    }

    /// Calls visit(x, column) for x in [0, width).
    template <class Visit>
    void visit(int width, const Visit& visit) const {
        std::size_t part = 0;
        for (int x = 0; x < width; ++x) {
            while (part + 1 < parts_.size() && parts_[part + 1].from < x)
                ++part;
            visit(x, static_cast<int>(parts_[part].column));
        }
    }

  private:
    struct Part {
        std::int64_t column;
        std::int64_t height2;
        double from; // lowest from here on
    };
    std::vector<Part> parts_;
};

} // namespace

std::vector<std::uint32_t> nearest_covered(int width, int height,
                                           const std::vector<bool>& covered) {
    const auto w = std::size_t(width), h = std::size_t(height);
    assert(covered.size() == w * h);
    std::vector<std::int32_t> rows(w * h, nowhere);
    parallel_for(w, 16, [&](std::size_t x) { nearest_rows(int(x), width, height, covered, rows); });
    std::vector<std::uint32_t> out(w * h);
    parallel_for(h, 16, [&](std::size_t y) {
        Envelope envelope;
        for (int column = -(width / 2); column < width + (width + 1) / 2; ++column) {
            const std::int32_t row = rows[y * w + std::size_t(wrapped(column, width))];
            if (row == nowhere)
                continue;
            const std::int64_t away = around(std::int64_t(y) - row, height);
            envelope.add(column, away * away);
        }
        envelope.visit(width, [&](int x, int column) {
            const int source = wrapped(column, width);
            const std::int32_t row = rows[y * w + std::size_t(source)];
            out[y * w + std::size_t(x)] =
                static_cast<std::uint32_t>(std::size_t(row) * w + std::size_t(source));
        });
    });
    return out;
}

void fill_gutter(Image& image, const std::vector<bool>& covered) {
    if (std::find(covered.begin(), covered.end(), false) == covered.end())
        return;
    const std::vector<std::uint32_t> nearest = nearest_covered(image.width, image.height, covered);
    const std::size_t channels = image.channels.size();
    parallel_for(nearest.size(), 4096, [&](std::size_t i) {
        if (nearest[i] != i)
            std::copy_n(&image.pixels[nearest[i] * channels], channels,
                        &image.pixels[i * channels]);
    });
}

} // namespace scree
