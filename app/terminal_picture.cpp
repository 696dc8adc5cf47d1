// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace scree {

namespace {

// Mean over the pixels [begin, end) of a coarse pixel, at least one.
struct Span {
    int begin, end;
};

Span span_of(int index, int count, int pixels) {
    const int begin = static_cast<int>(std::int64_t(index) * pixels / count);
    const int end = static_cast<int>(std::int64_t(index + 1) * pixels / count);
    return {begin, std::max(begin + 1, end)};
}

std::string color_of(const Image& image, Span across, Span down) {
    float sum[3] = {};
    for (int y = down.begin; y < down.end; ++y)
        for (int x = across.begin; x < across.end; ++x)
            for (int c = 0; c < 3; ++c)
                sum[c] += std::clamp(image.at(x, y)[c], 0.0F, 1.0F);
    const auto count = static_cast<float>((across.end - across.begin) * (down.end - down.begin));
    const auto step = [&](int c) { return std::lround(255 * sum[c] / count); };
    return fmt::format("2;{};{};{}", step(0), step(1), step(2));
}

} // namespace

TerminalPicture terminal_picture(const Image& shown, int columns, int rows) {
    TerminalPicture out;
    if (columns < 1 || rows < 1 || shown.width < 1 || shown.height < 1)
        return out;
    const double scale = std::min({double(columns) / shown.width, 2.0 * rows / shown.height, 1.0});
    const int width = std::max(1, static_cast<int>(shown.width * scale));
    const int height = std::max(2, static_cast<int>(shown.height * scale) / 2 * 2);
    out.rows = height / 2;
    for (int y = 0; y < height; y += 2) {
        for (int x = 0; x < width; ++x) {
            const Span across = span_of(x, width, shown.width);
            fmt::format_to(std::back_inserter(out.text), "\x1b[38;{};48;{}m\u2580",
                           color_of(shown, across, span_of(y, height, shown.height)),
                           color_of(shown, across, span_of(y + 1, height, shown.height)));
        }
        out.text += "\x1b[0m\n";
    }
    return out;
}

} // namespace scree
