// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/svg_shapes.h"

#include "core/error.h"
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace scree {

namespace {

double size_of(const Attribute& attribute, const std::string& name, double otherwise = 0) {
    const double size = svg_length(attribute, name, otherwise);
    if (size < 0)
        throw Error(fmt::format("{}: is negative: {:g}", name, size));
    return size;
}

BezierPath ellipse(const Vec2& centre, const Vec2& radii) {
    BezierPath path;
    if (radii.x == 0 || radii.y == 0)
        return path;
    path.move_to(centre + Vec2(radii.x, 0));
    path.arc_to(radii, 0, false, true, centre - Vec2(radii.x, 0));
    path.arc_to(radii, 0, false, true, centre + Vec2(radii.x, 0));
    path.close();
    return path;
}

Vec2 centre_of(const Attribute& attribute) {
    return {svg_length(attribute, "cx", 0), svg_length(attribute, "cy", 0)};
}

/// One radius given stands for both.
Vec2 radii_of(const Attribute& attribute) {
    const auto given = [&](const char* name) { return attribute(name).value_or("auto") != "auto"; };
    Vec2 radii(given("rx") ? size_of(attribute, "rx") : 0,
               given("ry") ? size_of(attribute, "ry") : 0);
    if (!given("rx"))
        radii.x = radii.y;
    if (!given("ry"))
        radii.y = radii.x;
    return radii;
}

BezierPath rectangle(const Attribute& attribute) {
    const Vec2 at(svg_length(attribute, "x", 0), svg_length(attribute, "y", 0));
    const Vec2 size(size_of(attribute, "width"), size_of(attribute, "height"));
    BezierPath path;
    if (size.x == 0 || size.y == 0)
        return path;
    Vec2 round = radii_of(attribute); // none is larger than half a side
    round = {std::min(round.x, size.x / 2), std::min(round.y, size.y / 2)};
    if (round.x == 0 || round.y == 0)
        round = Vec2(0.0);
    const Vec2 end = at + size;
    const auto corner = [&](const Vec2& to) { path.arc_to(round, 0, false, true, to); };
    path.move_to({at.x + round.x, at.y});
    path.line_to({end.x - round.x, at.y});
    corner({end.x, at.y + round.y});
    path.line_to({end.x, end.y - round.y});
    corner({end.x - round.x, end.y});
    path.line_to({at.x + round.x, end.y});
    corner({at.x, end.y - round.y});
    path.line_to({at.x, at.y + round.y});
    corner({at.x + round.x, at.y});
    path.close();
    return path;
}

BezierPath polygon(const std::string& points) {
    const std::vector<double> numbers = parse_numbers(points);
    if (numbers.size() % 2 != 0)
        throw Error(fmt::format("expected pairs of numbers, got {} numbers", numbers.size()));
    BezierPath path;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        const Vec2 point(numbers[i], numbers[i + 1]);
        if (i == 0)
            path.move_to(point);
        else
            path.line_to(point);
    }
    return path;
}

} // namespace

double svg_length(const Attribute& attribute, const std::string& name, double otherwise) {
    const std::optional<std::string> text = attribute(name);
    if (!text)
        return otherwise;
    return named(name, [&] { return parse_length(*text, attribute.lengths.base(name)); });
}

LengthBase SvgLengths::base(std::string_view name) const {
    const Vec2 known(viewport.x > 0 ? viewport.x : std::nan(""),
                     viewport.y > 0 ? viewport.y : std::nan(""));
    double whole = known.length() / std::sqrt(2.0);
    if (name == "x" || name == "width" || name == "cx" || name == "rx")
        whole = known.x;
    if (name == "y" || name == "height" || name == "cy" || name == "ry")
        whole = known.y;
    return {whole, font_size};
}

bool is_svg_shape(const std::string& element) {
    static constexpr std::array<std::string_view, 6> known{"path",    "rect",    "circle",
                                                           "ellipse", "polygon", "polyline"};
    return std::find(known.begin(), known.end(), element) != known.end();
}

BezierPath svg_shape(const std::string& element, const Attribute& attribute) {
    if (element == "rect")
        return rectangle(attribute);
    if (element == "circle")
        return ellipse(centre_of(attribute), Vec2(size_of(attribute, "r")));
    if (element == "ellipse")
        return ellipse(centre_of(attribute), radii_of(attribute));
    if (element == "path") {
        const std::string data = attribute("d").value_or("none");
        if (trimmed(data).empty() || data == "none")
            return {};
        return named("d", [&] { return parse_path_data(data); });
    }
    const std::string points = attribute("points").value_or("");
    return named("points", [&] { return polygon(points); });
}

} // namespace scree
