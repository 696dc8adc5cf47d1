// SPDX-License-Identifier: GPL-3.0-or-later
// Anti-aliased sampling of pictures at any scale and rotation.
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <array>

namespace scree {

using Rgba = std::array<float, 4>; // linear, premultiplied

/// How a picture is extended beyond its borders.
enum class Beyond { clamped, repeated };

/// Where a picture is drawn [pixels]: its top left corner and the vectors along its top side and
/// its left side.
struct PicturePlace {
    Vec2 origin, u, v;
};

/// A picture with its mip levels, each filtered from the one before. Immutable, so thread-safe.
class PictureFilter {
  public:
    /// `picture` has premultiplied R, G, B, A.
    PictureFilter(const Image& picture, Beyond beyond);

    /// The picture at a fixed place on a target.
    class Placed {
      public:
        /// The colour at a position on the target, filtered by Mitchell & Netravali's cubic (1988).
        /// Along each principal axis of the transform its radius is two pixels of the target or two
        /// of the picture, whichever is larger. Alpha is clamped to [0, 1], colours to >= 0.
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

    /// The mean over about a square around `uv`, whose (0, 0) is the lower left corner; the area of
    /// the square is `width`^2 times that of the picture. By trilinear mip mapping (Williams 1983).
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
