// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/css_transform.h"

#include "core/error.h"
#include "core/text.h"
#include "geometry/plane/svg/css_sheet.h"
#include "geometry/plane/svg/number_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace scree {

namespace {

using Words = std::vector<std::string_view>;

/// Between commas and blanks.
Words words_of(std::string_view text) {
    Words out;
    for (const std::string_view part : css_split(text, ','))
        for (const std::string_view word : css_split(part, ' '))
            if (!trimmed(word).empty())
                out.push_back(trimmed(word));
    return out;
}

double number_of(std::string_view text, bool share_allowed = false) {
    NumberScanner scanner(text);
    const double number = scanner.number();
    const bool share = share_allowed && scanner.peek() == '%' && scanner.letter() == '%';
    if (!scanner.at_end())
        throw Error(fmt::format("expected a number, got \"{:.30}\"", text));
    return share ? number / 100 : number;
}

/// [rad]
double angle_of(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, double>, 4> units{
        {{"deg", pi / 180}, {"grad", pi / 200}, {"rad", 1}, {"turn", 2 * pi}}};
    NumberScanner scanner(text);
    const double number = scanner.number();
    const std::string unit = lower_case(scanner.word());
    if (scanner.at_end()) {
        if (unit.empty() && number == 0)
            return 0;
        for (const auto& [name, radians] : units)
            if (unit == name)
                return number * radians;
    }
    throw Error(fmt::format("expected an angle in deg, grad, rad or turn, got \"{:.30}\"", text));
}

class Function {
  public:
    Function(std::string name, Words arguments, const Vec2& box, double font_size)
        : name_(std::move(name)), arguments_(std::move(arguments)), box_(box), font_(font_size) {}

    Affine matrix() const {
        if (name_ == "translate" || name_ == "translatex" || name_ == "translatey")
            return translation();
        if (name_ == "scale" || name_ == "scalex" || name_ == "scaley")
            return scaling();
        if (name_ == "rotate" || name_ == "rotatez") {
            takes(1, 1);
            const double c = std::cos(angle(0)), s = std::sin(angle(0));
            return of(c, s, -s, c, 0, 0);
        }
        if (name_ == "skew" || name_ == "skewx" || name_ == "skewy") {
            takes(1, name_ == "skew" ? 2 : 1);
            const double first = std::tan(angle(0));
            if (name_ == "skewy")
                return of(1, first, 0, 1, 0, 0);
            return of(1, arguments_.size() > 1 ? std::tan(angle(1)) : 0, first, 1, 0, 0);
        }
        if (name_ == "matrix") {
            takes(6, 6);
            return of(number_of(arguments_[0]), number_of(arguments_[1]), number_of(arguments_[2]),
                      number_of(arguments_[3]), number_of(arguments_[4]), number_of(arguments_[5]));
        }
        throw Error(fmt::format("unknown transform \"{:.30}\"; there are: matrix, translate, "
                                "scale, rotate, skew and their kinds for x and y",
                                name_));
    }

  private:
    static Affine of(double a, double b, double c, double d, double e, double f) {
        return {a, b, 0, c, d, 0, e, f, 1};
    }

    void takes(std::size_t least, std::size_t most) const {
        if (arguments_.size() < least || arguments_.size() > most)
            throw Error(fmt::format("{} cannot have {} value{}", name_, arguments_.size(),
                                    arguments_.size() == 1 ? "" : "s"));
    }

    double angle(std::size_t i) const { return angle_of(arguments_[i]); }

    double length(std::size_t i, double whole) const {
        const std::string text = lower_case(arguments_[i]);
        const double value = parse_length(text, {.whole = whole, .font = font_});
        if (value != 0 &&
            std::string_view("0123456789.").find(text.back()) != std::string_view::npos)
            throw Error(fmt::format("{}: \"{:.30}\" has no unit", name_, text));
        return value;
    }

    Affine translation() const {
        takes(1, name_ == "translate" ? 2 : 1);
        if (name_ == "translatey")
            return of(1, 0, 0, 1, 0, length(0, box_.y));
        return of(1, 0, 0, 1, length(0, box_.x), arguments_.size() > 1 ? length(1, box_.y) : 0);
    }

    Affine scaling() const {
        takes(1, name_ == "scale" ? 2 : 1);
        const double first = number_of(arguments_[0], true);
        if (name_ == "scalex")
            return of(first, 0, 0, 1, 0, 0);
        if (name_ == "scaley")
            return of(1, 0, 0, first, 0, 0);
        return of(first, 0, 0, arguments_.size() > 1 ? number_of(arguments_[1], true) : first, 0,
                  0);
    }

    std::string name_;
    Words arguments_;
    Vec2 box_;
    double font_;
};

} // namespace

Affine css_transform(std::string_view text, const Vec2& box, double font_size) {
    Affine all;
    if (lower_case(trimmed(text)) == "none")
        return all;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t open = text.find('(');
        const std::size_t close = text.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open)
            throw Error(
                fmt::format("expected a function like rotate(30deg), got \"{:.30}\"", text));
        all = Function(lower_case(trimmed(text.substr(0, open))),
                       words_of(text.substr(open + 1, close - open - 1)), box, font_size)
                  .matrix() *
              all;
        text.remove_prefix(close + 1);
    }
    return all;
}

Vec2 css_transform_origin(std::string_view text, const Box2& box, double font_size) {
    Words words = words_of(text);
    if (words.empty())
        return Vec2(0.0);
    if (words.size() == 3) // z
        words.pop_back();
    if (words.size() == 1)
        words.emplace_back("center");
    if (words.size() != 2)
        throw Error(fmt::format("expected two lengths or keywords, got \"{:.40}\"", text));
    const auto is_vertical = [](std::string_view word) {
        return lower_case(word) == "top" || lower_case(word) == "bottom";
    };
    const auto is_horizontal = [](std::string_view word) {
        return lower_case(word) == "left" || lower_case(word) == "right";
    };
    if (is_vertical(words[0]) || is_horizontal(words[1]))
        std::swap(words[0], words[1]);
    const auto place = [&](std::string_view word, double whole) {
        const std::string small = lower_case(word);
        if (small == "center")
            return whole / 2;
        if (small == "left" || small == "top")
            return 0.0;
        if (small == "right" || small == "bottom")
            return whole;
        return parse_length(small, {.whole = whole, .font = font_size});
    };
    return box.min + Vec2(place(words[0], box.size().x), place(words[1], box.size().y));
}

} // namespace scree
