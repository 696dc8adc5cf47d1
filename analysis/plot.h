// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/canvas.h"

#include <string>
#include <vector>

namespace scree {

/// One axis of a plot: its limits and its label.
struct Axis {
    double low = 0;
    double high = 1;
    std::string label;
};

/// Tick positions on the axis, about `count`, at steps of 1, 2 or 5 times a power of ten.
std::vector<double> ticks(const Axis& axis, int count = 6);

/// A frame with axes, ticks and labels, in which curves are drawn, clipped to the frame.
class Plot {
  public:
    /// `frame` in pixels is the area between the axes; labels lie around it.
    Plot(Canvas& canvas, const Box2& frame, const std::string& title, Axis x, Axis y);

    /// Converts plot coordinates to pixels.
    Vec2 at(double x, double y) const;

    /// A polyline through points (x, y); a non-finite y makes a gap.
    void curve(const std::vector<Vec2>& points, double width, const Color& color);

    /// Bars of the given heights and width `step`, from x = 0.
    void bars(double step, const std::vector<double>& heights, const Color& color);

    void horizontal(double y, const Color& color);
    void vertical(double x, const Color& color);

    /// A legend entry, a coloured dash with a name, in the given row at the top right.
    void legend(int row, const std::string& name, const Color& color);

    const Box2& frame() const { return frame_; }

  private:
    void draw_axes(const std::string& title);

    Canvas& canvas_;
    Box2 frame_;
    Axis x_;
    Axis y_;
};

} // namespace scree
