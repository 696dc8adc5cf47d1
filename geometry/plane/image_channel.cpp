// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/image_channel.h"

#include "core/error.h"
#include "core/math.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace scree {

namespace {

std::optional<std::size_t> index_of(const Image& image, const std::string& name) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), name);
    if (found == image.channels.end())
        return {};
    return static_cast<std::size_t>(found - image.channels.begin());
}

/// Where a channel's numbers stand in a pixel: one place, or those of red, green and blue.
std::vector<std::size_t> sources(const Image& image, const std::string& channel) {
    const std::optional<std::size_t> grey = index_of(image, "Y");
    if (channel == "luminance") {
        const auto r = index_of(image, "R"), g = index_of(image, "G"), b = index_of(image, "B");
        if (r && g && b)
            return {*r, *g, *b};
        if (grey)
            return {*grey};
    } else {
        const std::string name(1, static_cast<char>(channel.front() - 'a' + 'A'));
        if (const auto named = index_of(image, name))
            return {*named};
        if (grey && name != "A")
            return {*grey};
    }
    throw Error(fmt::format("the image has no {}; its channels are {}", channel,
                            fmt::join(image.channels, ", ")));
}

} // namespace

bool has_alpha(const Image& image) { return index_of(image, "A").has_value(); }

std::vector<float> channel_values(const Image& image, const std::string& channel) {
    const std::vector<std::size_t> from = sources(image, channel);
    const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height);
    const std::size_t stride = image.channels.size();
    std::vector<float> out(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* pixel = &image.pixels[i * stride];
        out[i] = from.size() == 1
                     ? pixel[from[0]]
                     : luminance(Color(pixel[from[0]], pixel[from[1]], pixel[from[2]]));
        if (!std::isfinite(out[i]))
            throw Error(fmt::format("pixel ({}, {}) of the image is not a finite number",
                                    i % std::size_t(image.width), i / std::size_t(image.width)));
    }
    return out;
}

} // namespace scree
