// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

const Color ink(0.15F, 0.15F, 0.17F);
const Color faint(0.90F, 0.90F, 0.91F);
constexpr double label_size = 15;
constexpr double title_size = 18;

} // namespace

std::vector<double> ticks(const Axis& axis, int count) {
    const double raw = (axis.high - axis.low) / count;
    if (!(raw > 0) || !std::isfinite(raw))
        return {};
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    const double digit = raw / power;
    const double step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
    std::vector<double> out;
    for (double i = std::ceil(axis.low / step - 1e-9); i * step <= axis.high + 1e-9 * step; ++i)
        out.push_back(i == 0 ? 0 : i * step); // never -0
    return out;
}

Plot::Plot(Canvas& canvas, const Box2& frame, const std::string& title, Axis x, Axis y)
    : canvas_(canvas), frame_(frame), x_(std::move(x)), y_(std::move(y)) {
    for (Axis* axis : {&x_, &y_})
        if (!(axis->high > axis->low))
            axis->high = axis->low + 1;
    draw_axes(title);
}

Vec2 Plot::at(double x, double y) const {
    return {frame_.min.x + (x - x_.low) / (x_.high - x_.low) * frame_.size().x,
            frame_.max.y - (y - y_.low) / (y_.high - y_.low) * frame_.size().y};
}

void Plot::draw_axes(const std::string& title) {
    for (const double tick : ticks(x_)) {
        const double x = std::round(at(tick, 0).x) + 0.5;
        canvas_.line({x, frame_.min.y}, {x, frame_.max.y}, 1, faint);
        canvas_.line({x, frame_.max.y}, {x, frame_.max.y + 5}, 1, ink);
        canvas_.text({x, frame_.max.y + 21}, fmt::format("{:.6g}", tick), label_size, ink,
                     Align::centre);
    }
    for (const double tick : ticks(y_, 5)) {
        const double y = std::round(at(0, tick).y) + 0.5;
        canvas_.line({frame_.min.x, y}, {frame_.max.x, y}, 1, faint);
        canvas_.line({frame_.min.x - 5, y}, {frame_.min.x, y}, 1, ink);
        canvas_.text({frame_.min.x - 9, y + 5}, fmt::format("{:.6g}", tick), label_size, ink,
                     Align::right);
    }
    const Vec2 low = frame_.min + Vec2(0.5, 0.5);
    const Vec2 high = frame_.max + Vec2(0.5, 0.5);
    const Vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    canvas_.stroke(corners, 1, ink, true);
    const Vec2 centre = frame_.center();
    canvas_.text({centre.x, frame_.min.y - 12}, title, title_size, ink, Align::centre);
    canvas_.text({centre.x, frame_.max.y + 44}, x_.label, label_size, ink, Align::centre);
    canvas_.text({frame_.min.x - 58, centre.y}, y_.label, label_size, ink, Align::centre, true);
}

void Plot::curve(const std::vector<Vec2>& points, double width, const Color& color) {
    canvas_.clip(frame_);
    std::vector<Vec2> run;
    for (const Vec2& point : points) {
        if (std::isfinite(point.y)) {
            run.push_back(at(point.x, point.y));
            continue;
        }
        canvas_.stroke(run, width, color);
        run.clear();
    }
    canvas_.stroke(run, width, color);
    canvas_.clip_nothing();
}

void Plot::bars(double step, const std::vector<double>& heights, const Color& color) {
    canvas_.clip(frame_);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const Vec2 a = at(double(i) * step, 0);
        const Vec2 b = at(double(i + 1) * step, heights[i]);
        const Ring bar{a, {b.x, a.y}, b, {a.x, b.y}};
        canvas_.fill(std::span(&bar, 1), color);
    }
    canvas_.clip_nothing();
}

void Plot::horizontal(double y, const Color& color) {
    const double row = std::round(at(0, y).y) + 0.5;
    for (double x = frame_.min.x + 4; x < frame_.max.x - 4; x += 9)
        canvas_.line({x, row}, {x + 4, row}, 1, color);
}

void Plot::vertical(double x, const Color& color) {
    const double column = std::round(at(x, 0).x) + 0.5;
    canvas_.line({column, frame_.min.y + 1}, {column, frame_.max.y - 1}, 1.5, color);
}

void Plot::legend(int row, const std::string& name, const Color& color) {
    const double y = frame_.min.y + 17 + 20 * row;
    const double x = frame_.max.x - 12;
    canvas_.line({x - 22, y}, {x, y}, 3, color);
    canvas_.text({x - 30, y + 5}, name, label_size, ink, Align::right);
}

} // namespace scree
