// SPDX-License-Identifier: GPL-3.0-or-later
// How far a picture is from a reference. Pictures begin with R, G and B.
#pragma once

#include "core/image.h"
#include "core/math.h"

namespace scree::bench {

/// relMSE: the mean over pixels and colours of the squared error over the squared reference + 0.01.
inline double relative_error(const Image& picture, const Image& reference) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int color = 0; color < 3; ++color) {
                const double truth = double(reference.at(x, y)[color]);
                const double error = double(picture.at(x, y)[color]) - truth;
                sum += error * error / (truth * truth + 0.01);
            }
    return sum / (3.0 * picture.width * picture.height);
}

/// The means of squares of `side` x `side` pixels; what is left over at the edges is cut off.
inline Image shrunk(const Image& picture, int side) {
    Image out(picture.width / side, picture.height / side, {"R", "G", "B"});
    for (int y = 0; y < out.height * side; ++y)
        for (int x = 0; x < out.width * side; ++x)
            for (int color = 0; color < 3; ++color)
                out.at(x / side, y / side)[color] +=
                    picture.at(x, y)[color] / static_cast<float>(side * side);
    return out;
}

inline double mean_luminance(const Image& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float* p = picture.at(x, y);
            sum += double(luminance(Color(p[0], p[1], p[2])));
        }
    return sum / (double(picture.width) * picture.height);
}

} // namespace scree::bench
