// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/plot_sheet.h"

#include "analysis/plot.h"
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace scree {

namespace {

const Color ink(0.15F, 0.15F, 0.17F);
const Color blue(0.12F, 0.40F, 0.66F);
const Color light_blue(0.62F, 0.77F, 0.89F);
const Color red(0.80F, 0.22F, 0.16F);
const Color grey(0.55F, 0.55F, 0.57F);

constexpr int width = 1680;
constexpr int height = 1060;
constexpr std::size_t kinds_shown = 6; // more curves cannot be distinguished

// The frame of a panel; there are two rows of three.
Box2 panel(int column, int row) {
    const Vec2 corner(110 + 560.0 * column, 110 + 500.0 * row);
    return {corner, corner + Vec2(420, 370)};
}

// The unit in which lengths are shown, so that numbers lie between 0.1 and 1000.
struct Unit {
    double per_metre;
    const char* name;
};
Unit unit_for(double length) {
    return length < 0.5 ? Unit{1e3, "mm"} : length < 500 ? Unit{1, "m"} : Unit{1e-3, "km"};
}

Ring to_pixels(const Ring& ring, const Vec2& origin, const Vec2& corner, double scale) {
    Ring out;
    for (const Vec2& p : ring)
        out.push_back(corner + (p - origin) * scale);
    return out;
}

std::vector<Ring> to_pixels(const std::vector<Ring>& rings, const Vec2& origin, const Vec2& corner,
                            double scale) {
    std::vector<Ring> out;
    out.reserve(rings.size());
    for (const Ring& ring : rings)
        out.push_back(to_pixels(ring, origin, corner, scale));
    return out;
}

void draw_layout(Canvas& canvas, const AnalysisReport& report, const PlacedRegions& layout) {
    const Box2 frame = panel(0, 0);
    const Box2 box = bounds(*layout.window.domain);
    // Leaves room for elements beyond the window; there are no labels below.
    const Vec2 room = frame.size() + Vec2(20, 30);
    const double scale = 0.94 * std::min(room.x / box.size().x, room.y / box.size().y);
    const Vec2 corner = frame.center() + Vec2(-20, 15) - box.size() * (scale / 2);
    if (layout.window.torus)
        canvas.clip({corner, corner + box.size() * scale});
    canvas.fill(to_pixels(layout.window.domain->rings, box.min, corner, scale),
                Color(0.955F, 0.95F, 0.94F));
    const auto turns = layout.window.torus ? std::vector<double>{-1, 0, 1} : std::vector<double>{0};
    for (const double x : turns)
        for (const double y : turns) {
            const Vec2 moved = corner + Vec2(x * box.size().x, y * box.size().y) * scale;
            for (std::size_t i = 0; i < layout.positions.size(); ++i) {
                const Color color = palette_color(layout.kinds[i]);
                if (report.has_regions)
                    canvas.fill(to_pixels(layout.outlines[i].rings, box.min, moved, scale), color);
                else
                    canvas.fill(std::vector<Ring>{circle_ring(
                                    moved + (layout.positions[i] - box.min) * scale, 2.5, 16)},
                                color);
            }
            if (const auto& circle = report.layouts[0].largest_empty_circle; circle) {
                const Ring ring = to_pixels(circle_ring(circle->centre, circle->radius, 128),
                                            box.min, moved, scale);
                canvas.fill(std::span(&ring, 1), red, 0.25);
                canvas.stroke(ring, 1.8, red, true);
            }
        }
    for (const Ring& ring : to_pixels(layout.window.domain->rings, box.min, corner, scale))
        canvas.stroke(ring, 1.2, ink, true);
    canvas.clip_nothing();

    const LayoutFigures& figures = report.layouts[0];
    std::string facts = counted(figures.count, "element");
    if (figures.fill)
        facts += fmt::format(", fill {:.1f}%", 100 * *figures.fill);
    canvas.text({frame.center().x - 20, frame.min.y - 12}, facts, 18, ink, Align::centre);
    if (const auto& circle = figures.largest_empty_circle; circle) {
        const Unit unit = unit_for(circle->radius);
        canvas.text({frame.center().x - 20, frame.max.y + 50},
                    fmt::format("largest empty circle: radius {:.3g} {}",
                                circle->radius * unit.per_metre, unit.name),
                    15, red, Align::centre);
    }
}

std::vector<Vec2> centres_of_bins(const std::vector<double>& values, double step) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < values.size(); ++k)
        points.emplace_back((double(k) + 0.5) * step, values[k]);
    return points;
}

double highest(const std::vector<double>& values) {
    double out = 0;
    for (const double value : values)
        if (std::isfinite(value))
            out = std::max(out, value);
    return out;
}

void draw_gaps(Canvas& canvas, const AnalysisReport& report) {
    const Histogram& gaps = report.gap_histogram;
    const Histogram& neighbours = report.neighbour_histogram;
    const double limit = std::max(gaps.bin_width * double(gaps.density.size()),
                                  neighbours.bin_width * double(neighbours.density.size()));
    const Unit unit = unit_for(limit);
    const auto share = [](const Histogram& histogram) { // percent per bin
        std::vector<double> out;
        for (const double density : histogram.density)
            out.push_back(100 * density * histogram.bin_width);
        return out;
    };
    const std::vector<double> gap_share = share(gaps);
    const std::vector<double> neighbour_share = share(neighbours);
    Plot plot(
        canvas, panel(1, 0), "Gaps",
        {0, limit * unit.per_metre, fmt::format("distance [{}]", unit.name)},
        {0, 1.15 * std::max(highest(gap_share), highest(neighbour_share)), "share per bin [%]"});
    plot.bars(gaps.bin_width * unit.per_metre, gap_share, light_blue);
    plot.curve(centres_of_bins(neighbour_share, neighbours.bin_width * unit.per_metre), 2, red);
    plot.legend(0, "free space to nearest region", light_blue);
    plot.legend(1, "region to nearest region", red);
    plot.legend(2, fmt::format("mean {:.3g} {}", report.gap.mean * unit.per_metre, unit.name),
                blue);
    plot.vertical(report.gap.mean * unit.per_metre, blue);
}

void draw_pairs(Canvas& canvas, const AnalysisReport& report) {
    const double step = report.pair_correlation.bin_width / report.spacing;
    double top = std::max(2.0, 1.1 * highest(report.pair_correlation.value));
    const std::size_t kinds = report.kind_names.size();
    const bool by_kind = kinds > 1 && kinds <= kinds_shown;
    Plot plot(canvas, panel(2, 0), "Pair correlation g(r)",
              {0, step * double(report.pair_correlation.value.size()), "r / mean spacing"},
              {0, top, "g"});
    plot.horizontal(1, grey);
    for (std::size_t kind = 0; by_kind && kind < kinds; ++kind) {
        plot.curve(centres_of_bins(report.pair_correlation_by_kind[kind].value, step), 1.3,
                   palette_color(kind));
        plot.legend(static_cast<int>(kind) + 1, report.kind_names[kind], palette_color(kind));
    }
    plot.curve(centres_of_bins(report.pair_correlation.value, step), 2.4, ink);
    if (by_kind)
        plot.legend(0, "all", ink);
}

// Draws the curve of each kind, unless there are too many kinds, before the curve of all points.
void draw_kinds(Plot& plot, const AnalysisReport& report, const auto& values_of, double step,
                bool named) {
    const std::size_t kinds = report.kind_names.size();
    if (kinds > 1 && kinds <= kinds_shown) {
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            plot.curve(centres_of_bins(values_of(report.radial_by_kind[kind]), step), 1.3,
                       palette_color(kind));
            if (named)
                plot.legend(static_cast<int>(kind) + 1, report.kind_names[kind],
                            palette_color(kind));
        }
        if (named)
            plot.legend(0, "all", ink);
    }
    plot.curve(centres_of_bins(values_of(report.radial), step), 2.4, ink);
}

void draw_power(Canvas& canvas, const AnalysisReport& report) {
    const double step = report.radial.bin_width * report.spacing;
    const double limit = step * double(report.radial.power.size());
    double top = std::max(2.0, 1.1 * highest(report.radial.power));
    Plot power(canvas, panel(0, 1), "Radial mean power", {0, limit, "frequency [1 / mean spacing]"},
               {0, top, "power"});
    power.horizontal(1, grey);
    draw_kinds(
        power, report,
        [](const RadialSpectrum& radial) {
            std::vector<double> known = radial.power;
            for (std::size_t k = 0; k < known.size(); ++k)
                if (radial.count[k] == 0) // the first annulus may contain only frequency 0
                    known[k] = std::numeric_limits<double>::quiet_NaN();
            return known;
        },
        step, true);

    const double expected = -10 * std::log10(double(report.layouts.size()));
    Plot anisotropy(canvas, panel(1, 1), "Anisotropy", {0, limit, "frequency [1 / mean spacing]"},
                    {expected - 15, expected + 15, "anisotropy [dB]"});
    anisotropy.horizontal(expected, grey);
    draw_kinds(
        anisotropy, report, [](const RadialSpectrum& radial) { return radial.anisotropy_db; }, step,
        false);
}

// Grey from 0 (black) to twice the power of a Poisson process (white). Each pixel is the mean of
// the frequencies that it covers.
void draw_spectrum(Canvas& canvas, const AnalysisReport& report) {
    const PowerSpectrum& spectrum = report.spectrum;
    const Box2 area = panel(2, 1);
    const double side = std::min(area.size().x, area.size().y);
    const Vec2 centre = area.center();
    const Box2 frame(centre - Vec2(side / 2, side / 2), centre + Vec2(side / 2, side / 2));
    const double limit =
        std::min(spectrum.reach_x * spectrum.step.x, spectrum.reach_y * spectrum.step.y);
    const Axis axis{-limit * report.spacing, limit * report.spacing,
                    "frequency [1 / mean spacing]"};
    const Plot plot(canvas, frame, "Power spectrum (black 0, white 2)", axis, axis);
    const auto range = [&](int pixel, double step, int reach) {
        const double per_pixel = 2 * limit / side;
        const double low = (-limit + pixel * per_pixel) / step;
        const int first = std::clamp(static_cast<int>(std::ceil(low)), -reach, reach);
        const int last =
            std::clamp(static_cast<int>(std::ceil(low + per_pixel / step)) - 1, -reach, reach);
        const int nearest =
            std::clamp(static_cast<int>(std::round(low + per_pixel / step / 2)), -reach, reach);
        return first <= last ? std::pair(first, last) : std::pair(nearest, nearest);
    };
    for (int row = 1; row < static_cast<int>(side); ++row)
        for (int column = 1; column < static_cast<int>(side); ++column) {
            const auto [x0, x1] = range(column, spectrum.step.x, spectrum.reach_x);
            const auto [y0, y1] =
                range(static_cast<int>(side) - row, spectrum.step.y, spectrum.reach_y);
            double sum = 0;
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x)
                    sum += spectrum.at(x, y);
            const double mean = sum / double((x1 - x0 + 1) * (y1 - y0 + 1));
            const auto grey_level = static_cast<float>(std::clamp(mean / 2, 0.0, 1.0));
            float* pixel = canvas.image().at(static_cast<int>(frame.min.x) + column,
                                             static_cast<int>(frame.min.y) + row);
            std::fill(pixel, pixel + 3, grey_level);
        }
}

} // namespace

Image plot_sheet(const AnalysisReport& report, const PlacedRegions& layout,
                 const std::string& title) {
    Canvas canvas(width, height, Color(1, 1, 1));
    std::string heading = title;
    if (report.layouts.size() > 1)
        heading += fmt::format(", {} seeds", report.layouts.size());
    canvas.text({width / 2.0, 42}, heading, 24, ink, Align::centre);
    draw_layout(canvas, report, layout);
    if (report.has_regions)
        draw_gaps(canvas, report);
    draw_pairs(canvas, report);
    draw_power(canvas, report);
    draw_spectrum(canvas, report);
    return canvas.image();
}

} // namespace scree
