// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures sampled at any size and angle without aliasing.
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <array>

namespace scree {

using Rgba = std::array<float, 4>; // linear, multiplied by alpha

/// How a picture goes on beyond its borders.
enum class Beyond { clamped, repeated };

/// Where a picture's unit square lies [pixels]: its top left corner, and what goes along its top
/// and its left side.
struct PicturePlace {
    Vec2 origin, u, v;
};

/// A picture with its halvings, each filtered from the one before. Thread-safe once made.
class PictureFilter {
  public:
    /// `picture` has R, G, B, A, multiplied by alpha.
    PictureFilter(const Image& picture, Beyond beyond);

    /// The picture put in its place: what a pixel shows.
    class Placed {
      public:
        /// Filtered about `pixel` by Mitchell & Netravali's cubic (1988), two pixels of the target
        /// or of the picture wide to each side, whichever is larger, along each axis of the
        /// transform. Ringing is cut off where it would leave alpha's [0, 1] or colours below 0.
        Rgba at(const Vec2& pixel) const;

      private:
        friend class PictureFilter;
        const PictureFilter* picture_ = nullptr;
        const Image* level_ = nullptr;
        Vec2 origin_{0.0};
        std::array<Vec2, 2> texel_from_pixel_; // images of the axes
        std::array<Vec2, 2> kernel_from_texel_;
        Vec2 reach_{0.0}; // of the kernel [texels]
    };
    Placed placed(const PicturePlace& place) const;

    /// The mean around `uv`, whose (0, 0) is the lower left corner, over about the square of
    /// `width`, as a share of the picture's area: bilinear in the two nearest halvings (Williams
    /// 1983).
    Rgba trilinear(const Vec2& uv, double width) const;

    int levels() const { return static_cast<int>(levels_.size()); }
    const Image& level(int i) const { return levels_[static_cast<std::size_t>(i)]; }

  private:
    int wrapped(int i, int size) const;
    Rgba bilinear(const Image& level, const Vec2& uv) const;
    Image halved(const Image& from) const;

    Beyond beyond_;
    std::vector<Image> levels_; // the picture first, one pixel last
};

} // namespace scree
