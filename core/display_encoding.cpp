// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/display_encoding.h"

#include <algorithm>
#include <cassert>

namespace scree {

Image display_image(const Image& linear) {
    assert(linear.channels.size() == 4);
    const std::size_t pixels = linear.pixels.size() / 4;
    bool opaque = true;
    for (std::size_t i = 0; i < pixels && opaque; ++i)
        opaque = linear.pixels[4 * i + 3] >= 1;
    Image out(linear.width, linear.height,
              opaque ? std::vector<std::string>{"R", "G", "B"}
                     : std::vector<std::string>{"R", "G", "B", "A"});
    const std::size_t stride = out.channels.size();
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* from = &linear.pixels[4 * i];
        float* to = &out.pixels[stride * i];
        const float alpha = std::clamp(from[3], 0.0F, 1.0F);
        for (int c = 0; c < 3 && alpha > 0; ++c)
            to[c] = display_from_linear(std::clamp(from[c] / alpha, 0.0F, 1.0F));
        if (!opaque)
            to[3] = alpha;
    }
    return out;
}

} // namespace scree
