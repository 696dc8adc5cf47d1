// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/svg_text.h"

#include "core/error.h"
#include "core/text.h"
#include "geometry/plane/svg/number_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace scree {

namespace {

/// One pass over a path's data.
class PathParser {
  public:
    explicit PathParser(std::string_view data) : scanner_(data) {}

    BezierPath run() {
        if (scanner_.at_end())
            throw Error("the path is empty");
        while (!scanner_.at_end()) {
            if (std::string_view("MmLlHhVvCcSsQqTtAaZz").find(scanner_.peek()) ==
                std::string_view::npos)
                scanner_.fail("a command");
            if (path_.empty() && scanner_.peek() != 'M' && scanner_.peek() != 'm')
                scanner_.fail("the command M, with which a path begins");
            command_ = scanner_.letter();
            if (command_ == 'Z' || command_ == 'z') {
                path_.close();
                last_ = 'Z';
                continue;
            }
            do
                segment();
            while (scanner_.number_follows());
        }
        return std::move(path_);
    }

  private:
    bool relative() const { return command_ >= 'a'; }

    Vec2 point() {
        const double x = scanner_.number();
        const double y = scanner_.number();
        return relative() ? path_.current() + Vec2(x, y) : Vec2(x, y);
    }

    double coordinate(double now) {
        const double value = scanner_.number();
        return relative() ? now + value : value;
    }

    // The last curve's control point seen from its end, for S after C or S and T after Q or T.
    Vec2 mirrored(char one, char other) const {
        const Vec2 now = path_.current();
        return last_ == one || last_ == other ? now * 2 - control_ : now;
    }

    void segment() {
        const char kind = relative() ? static_cast<char>(command_ - 'a' + 'A') : command_;
        const Vec2 now = path_.current();
        switch (kind) {
        case 'M':
            path_.move_to(point());
            command_ = relative() ? 'l' : 'L'; // more pairs are lines
            break;
        case 'L':
            path_.line_to(point());
            break;
        case 'H':
            path_.line_to({coordinate(now.x), now.y});
            break;
        case 'V':
            path_.line_to({now.x, coordinate(now.y)});
            break;
        case 'C':
        case 'S': {
            const Vec2 first = kind == 'C' ? point() : mirrored('C', 'S');
            control_ = point();
            path_.cubic_to(first, control_, point());
            break;
        }
        case 'Q':
        case 'T':
            control_ = kind == 'Q' ? point() : mirrored('Q', 'T');
            path_.quadratic_to(control_, point());
            break;
        default: { // A
            const double rx = scanner_.number();
            const double ry = scanner_.number();
            const double turn = radians(scanner_.number());
            const bool large = scanner_.flag();
            const bool clockwise = scanner_.flag();
            path_.arc_to({rx, ry}, turn, large, clockwise, point());
        }
        }
        last_ = kind;
    }

    NumberScanner scanner_;
    BezierPath path_;
    char command_ = 'M';
    char last_ = '\0';
    Vec2 control_{0.0};
};

std::vector<double> arguments(NumberScanner& scanner) {
    scanner.skip_spaces();
    if (scanner.letter() != '(')
        throw Error("expected ( after the name of a transform");
    std::vector<double> out;
    while (scanner.number_follows())
        out.push_back(scanner.number());
    scanner.skip_spaces();
    if (scanner.peek() != ')')
        scanner.fail(")");
    scanner.letter();
    return out;
}

Affine affine(double a, double b, double c, double d, double e, double f) {
    return {a, b, 0, c, d, 0, e, f, 1};
}

Affine transform_of(std::string_view name, const std::vector<double>& n) {
    const auto takes = [&](std::initializer_list<std::size_t> counts) {
        if (std::find(counts.begin(), counts.end(), n.size()) == counts.end())
            throw Error(fmt::format("{} cannot have {} number{}", name, n.size(),
                                    n.size() == 1 ? "" : "s"));
    };
    const auto or_else = [&](std::size_t i, double otherwise) {
        return i < n.size() ? n[i] : otherwise;
    };
    if (name == "matrix") {
        takes({6});
        return affine(n[0], n[1], n[2], n[3], n[4], n[5]);
    }
    if (name == "translate") {
        takes({1, 2});
        return affine(1, 0, 0, 1, n[0], or_else(1, 0));
    }
    if (name == "scale") {
        takes({1, 2});
        return affine(n[0], 0, 0, or_else(1, n[0]), 0, 0);
    }
    if (name == "rotate") {
        takes({1, 3});
        const double c = std::cos(radians(n[0])), s = std::sin(radians(n[0]));
        const Vec2 centre(or_else(1, 0), or_else(2, 0));
        return affine(1, 0, 0, 1, -centre.x, -centre.y) * affine(c, s, -s, c, 0, 0) *
               affine(1, 0, 0, 1, centre.x, centre.y);
    }
    if (name == "skewX" || name == "skewY") {
        takes({1});
        const double slope = std::tan(radians(n[0]));
        return name == "skewX" ? affine(1, 0, slope, 1, 0, 0) : affine(1, slope, 0, 1, 0, 0);
    }
    throw Error(fmt::format("unknown transform \"{}\"; there are: matrix, translate, scale, "
                            "rotate, skewX, skewY",
                            name.substr(0, 30)));
}

} // namespace

BezierPath parse_path_data(std::string_view data) { return PathParser(data).run(); }

Affine parse_transform(std::string_view text) {
    NumberScanner scanner(text);
    Affine all;
    while (!scanner.at_end()) {
        const std::string_view name = scanner.word();
        if (name.empty())
            scanner.fail("the name of a transform");
        all = transform_of(name, arguments(scanner)) * all;
        scanner.skip_comma();
    }
    return all;
}

std::vector<double> parse_numbers(std::string_view text) {
    NumberScanner scanner(text);
    std::vector<double> out;
    while (scanner.number_follows())
        out.push_back(scanner.number());
    if (!scanner.at_end())
        scanner.fail("a number");
    return out;
}

double parse_length(std::string_view text, const LengthBase& base) {
    struct Unit {
        std::string_view name;
        double pixels;
    };
    // An ex is taken as half an em (CSS 2.1, section 4.3.2).
    const std::array units{Unit{"", 1},
                           Unit{"px", 1},
                           Unit{"mm", 96 / 25.4},
                           Unit{"cm", 96 / 2.54},
                           Unit{"q", 24 / 25.4},
                           Unit{"in", 96},
                           Unit{"pt", 96.0 / 72},
                           Unit{"pc", 16},
                           Unit{"em", base.font},
                           Unit{"ex", base.font / 2},
                           Unit{"%", base.whole / 100}};
    NumberScanner scanner(text);
    const double number = scanner.number();
    const std::string name = lower_case(scanner.word());
    for (const Unit& unit : units)
        if (name == unit.name && scanner.at_end()) {
            if (std::isnan(unit.pixels))
                throw Error(fmt::format("\"{:.30}\" is relative to a {} that is not given", text,
                                        name == "%" ? "size" : "font's size"));
            return number * unit.pixels;
        }
    throw Error(fmt::format("\"{}\" is not a length that can be read; units are px, mm, cm, Q, in, "
                            "pt, pc, em, ex and %",
                            text.substr(0, 30)));
}

} // namespace scree
