// SPDX-License-Identifier: GPL-3.0-or-later
// Helpers for tests of pictures.
#pragma once

#include "core/error.h"
#include "core/file.h"
#include "core/picture.h"
#include "tests/support/folder.h"

#include <array>
#include <functional>
#include <string>

namespace scree::test {

using Look = std::function<std::array<float, 4>(double x, double y)>; // linear, not premultiplied

/// The look sampled at pixel centres, premultiplied.
inline Image picture_of(int width, int height, const Look& look) {
    Image image(width, height, {"R", "G", "B", "A"});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::array<float, 4> v = look((x + 0.5) / width, (y + 0.5) / height);
            float* out = image.at(x, y);
            for (int c = 0; c < 3; ++c)
                out[c] = v[std::size_t(c)] * v[3];
            out[3] = v[3];
        }
    return image;
}

inline std::string svg(const std::string& body,
                       const std::string& attributes = "width='40' height='20'") {
    return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' " +
           attributes + ">\n" + body + "</svg>";
}

inline std::string error_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

} // namespace scree::test
