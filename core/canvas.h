// SPDX-License-Identifier: GPL-3.0-or-later
// Anti-aliased drawing of polygons, lines and text, for plots and layouts seen from above.
#pragma once

#include "core/image.h"
#include "core/math.h"
#include "core/picture_filter.h"

#include <span>
#include <string>

namespace scree {

/// Which point of a text's baseline lies at the given position.
enum class Align { left, centre, right };

class Coverage;

/// A picture to draw on. Coordinates are pixels with (0, 0) at the top left corner of the picture.
/// Edges are anti-aliased by the exact area of each pixel that a shape covers. Colours are blended
/// without conversion: give display-encoded (sRGB) ones for plots, linear ones to composite
/// pictures.
class Canvas {
  public:
    Canvas(int width, int height, const Color& paper);

    /// A transparent canvas: R, G, B premultiplied by A, all 0.
    Canvas(int width, int height);

    /// Fills a polygon with holes. Holes wind opposite to outer rings; rings may touch but not
    /// overlap.
    void fill(std::span<const Ring> rings, const Color& color, double opacity = 1);

    /// Composites a picture over the canvas, filtered where it is rotated or scaled.
    void draw(const PictureFilter& picture, const PicturePlace& place);

    /// Lines of `width` pixels with round joints and ends.
    void stroke(std::span<const Vec2> points, double width, const Color& color, bool closed = false,
                double opacity = 1);
    void line(const Vec2& a, const Vec2& b, double width, const Color& color);

    /// A line of text whose baseline starts, is centred, or ends at `at`; `size` is the height of
    /// a line in pixels. `upwards` rotates the text by 90 degrees so that it reads upwards. Throws
    /// Error (resource) when the font is not installed.
    void text(const Vec2& at, const std::string& text, double size, const Color& color,
              Align align = Align::left, bool upwards = false);

    /// Restricts drawing to this box until `clip` or `clip_nothing` is called.
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

/// The text's coverage in one channel "A", cropped to its ink. The image's top left pixel lies at
/// (`left`, `top`) relative to the start of the baseline.
struct TextMask {
    Image image;
    int left = 0;
    int top = 0;
};
TextMask text_mask(const std::string& text, double size);

/// The display-encoded colour: IEC 61966-2-1 (sRGB) applied to clamped linear Rec. 709.
Color display_color(const Color& linear);

/// A categorical palette of ten display-encoded colours that are easy to tell apart; it repeats.
Color palette_color(std::size_t index);

/// A circle as a ring of `segments` points.
Ring circle_ring(const Vec2& centre, double radius, int segments = 64);

} // namespace scree
