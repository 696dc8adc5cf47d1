// SPDX-License-Identifier: GPL-3.0-or-later
// Anti-aliased drawing of polygons, lines and text, for plots and layouts seen from above.
#pragma once

#include "core/image.h"
#include "core/math.h"
#include "core/picture_filter.h"

#include <span>
#include <string>

namespace scree {

/// Which point of a text lies at the place it is drawn at.
enum class Align { left, centre, right };

class Coverage;

/// A picture to draw on. Coordinates are pixels with (0, 0) at the top left corner of the picture.
/// Edges are smoothed by the exact area that a shape covers of each pixel. Colours are mixed as
/// they are given: display-encoded (sRGB) for plots, linear to put pictures over each other.
class Canvas {
  public:
    Canvas(int width, int height, const Color& paper);

    /// Without paper: R, G, B multiplied by A, all 0.
    Canvas(int width, int height);

    /// Fills rings whose outer ones turn one way and whose holes turn the other; rings may meet
    /// but not overlap.
    void fill(std::span<const Ring> rings, const Color& color, double opacity = 1);

    /// Puts a picture over what is there, filtered where it is turned, shrunk or grown.
    void draw(const PictureFilter& picture, const PicturePlace& place);

    /// Lines of `width` pixels with round joints and ends.
    void stroke(std::span<const Vec2> points, double width, const Color& color, bool closed = false,
                double opacity = 1);
    void line(const Vec2& a, const Vec2& b, double width, const Color& color);

    /// A line of text whose baseline starts, is centred, or ends at `at`; `size` is the height of
    /// a line in pixels. `upwards` turns it by a quarter to the left. Throws Error (resource)
    /// where the font is not installed.
    void text(const Vec2& at, const std::string& text, double size, const Color& color,
              Align align = Align::left, bool upwards = false);

    /// Nothing is drawn outside this box until it is set again.
    void clip(const Box2& box);
    void clip_nothing();

    Image& image() { return image_; }
    const Image& image() const { return image_; }

  private:
    void paint(const Coverage& coverage, const Color& color, double opacity);
    void blend(int x, int y, double share, const Color& color);

    Image image_;
    Box2 clip_;
};

/// The text's coverage in one channel "A", cropped to its ink; the pixel at (`left`, `top`)
/// relative to the start of its baseline is the image's first.
struct TextMask {
    Image image;
    int left = 0;
    int top = 0;
};
TextMask text_mask(const std::string& text, double size);

/// A colour as the display shows it: IEC 61966-2-1 applied to clamped linear Rec. 709.
Color display_color(const Color& linear);

/// Display colours that are easy to tell apart, for the parts of a whole; they repeat after ten.
Color palette_color(std::size_t index);

/// A circle as a ring of `segments` points.
Ring circle_ring(const Vec2& centre, double radius, int segments = 64);

} // namespace scree
