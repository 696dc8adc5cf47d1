// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/css_color.h"

#include "core/error.h"
#include "core/text.h"
#include "geometry/plane/svg/css_sheet.h"
#include "geometry/plane/svg/number_scanner.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

// CSS Color 4, section 6.1, each between blanks.
constexpr std::string_view names =
    " aliceblue antiquewhite aqua aquamarine azure beige bisque black blanchedalmond blue "
    "blueviolet brown burlywood cadetblue chartreuse chocolate coral cornflowerblue cornsilk "
    "crimson cyan darkblue darkcyan darkgoldenrod darkgray darkgreen darkgrey darkkhaki "
    "darkmagenta darkolivegreen darkorange darkorchid darkred darksalmon darkseagreen "
    "darkslateblue darkslategray darkslategrey darkturquoise darkviolet deeppink deepskyblue "
    "dimgray dimgrey dodgerblue firebrick floralwhite forestgreen fuchsia gainsboro ghostwhite "
    "gold goldenrod gray green greenyellow grey honeydew hotpink indianred indigo ivory khaki "
    "lavender lavenderblush lawngreen lemonchiffon lightblue lightcoral lightcyan "
    "lightgoldenrodyellow lightgray lightgreen lightgrey lightpink lightsalmon lightseagreen "
    "lightskyblue lightslategray lightslategrey lightsteelblue lightyellow lime limegreen linen "
    "magenta maroon mediumaquamarine mediumblue mediumorchid mediumpurple mediumseagreen "
    "mediumslateblue mediumspringgreen mediumturquoise mediumvioletred midnightblue mintcream "
    "mistyrose moccasin navajowhite navy oldlace olive olivedrab orange orangered orchid "
    "palegoldenrod palegreen paleturquoise palevioletred papayawhip peachpuff peru pink plum "
    "powderblue purple rebeccapurple red rosybrown royalblue saddlebrown salmon sandybrown "
    "seagreen seashell sienna silver skyblue slateblue slategray slategrey snow springgreen "
    "steelblue tan teal thistle tomato turquoise violet wheat white whitesmoke yellow "
    "yellowgreen canvas canvastext buttonface buttontext highlight highlighttext window "
    "windowtext ";

constexpr std::string_view functions =
    " rgb rgba hsl hsla hwb lab lch oklab oklch color light-dark ";

bool is_in(std::string_view list, std::string_view word) {
    return !word.empty() && word.find(' ') == std::string_view::npos &&
           list.find(" " + std::string(word) + " ") != std::string_view::npos;
}

[[noreturn]] void fail(std::string_view color) {
    throw Error(fmt::format("\"{:.40}\" is no colour that is read", color));
}

double hex_alpha(std::string_view color) {
    const std::string_view digits = color.substr(1);
    if (digits.find_first_not_of("0123456789abcdef") != std::string_view::npos)
        fail(color);
    const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
    switch (digits.size()) {
    case 3:
    case 6:
        return 1;
    case 4:
        return value(digits[3]) / 15.0;
    case 8:
        return (16 * value(digits[6]) + value(digits[7])) / 255.0;
    default:
        fail(color);
    }
}

/// After a slash, or as the fourth of values between commas.
std::optional<double> function_alpha(std::string_view color, std::string_view name,
                                     std::string_view inside) {
    const std::vector<std::string_view> by_comma = css_split(inside, ',');
    if (name == "light-dark") {
        if (by_comma.size() != 2)
            fail(color);
        return css_alpha(by_comma.front());
    }
    const std::vector<std::string_view> by_slash = css_split(inside, '/');
    if (by_slash.size() == 2)
        return css_opacity(by_slash[1]);
    if (by_slash.size() > 2 || by_comma.size() == 2 || by_comma.size() > 4 ||
        trimmed(inside).empty())
        fail(color);
    return by_comma.size() == 4 ? css_opacity(by_comma[3]) : 1.0;
}

} // namespace

std::optional<double> css_alpha(std::string_view text) {
    const std::string color = lower_case(trimmed(text));
    if (color == "currentcolor")
        return {};
    if (color == "transparent")
        return 0.0;
    if (color.starts_with('#'))
        return hex_alpha(color.substr(0, color.find(' '))); // an icc-color() may follow
    if (is_in(names, color.substr(0, color.find(' '))))
        return 1.0;
    const std::size_t open = color.find('(');
    if (open == std::string::npos || !is_in(functions, color.substr(0, open)))
        fail(text);
    const std::string_view rest = std::string_view(color).substr(open + 1);
    const std::size_t close = css_split(rest, ')').front().size();
    if (close == rest.size())
        fail(text);
    return function_alpha(text, std::string_view(color).substr(0, open), rest.substr(0, close));
}

double css_opacity(std::string_view text) {
    if (lower_case(trimmed(text)) == "none") // of a component: as 0
        return 0;
    NumberScanner scanner(text);
    scanner.skip_spaces();
    double value = scanner.number();
    const std::string_view unit = scanner.word();
    if (unit == "%")
        value /= 100;
    if (!scanner.at_end() || !(unit.empty() || unit == "%"))
        throw Error(fmt::format("\"{:.40}\" is no opacity: expected a number or per cent", text));
    return std::clamp(value, 0.0, 1.0);
}

} // namespace scree
