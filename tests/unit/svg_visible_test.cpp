// SPDX-License-Identifier: GPL-3.0-or-later
// What of a drawing can be seen is its area: against areas by closed form, and against the pixels
// that librsvg paints.
#include "core/drawing_raster.h"
#include "tests/support/errors.h"
#include "tests/support/svg.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree {
namespace {

using tests::error_of;
using tests::svg;
using tests::svg_region;

constexpr int page = 100;

std::string on_page(const std::string& body) {
    return svg(body, "width='100' height='100' viewBox='0 0 100 100'");
}

/// The area that librsvg paints [square pixels].
double painted(const std::string& text) {
    constexpr int fine = 8; // pixels of the raster for each of the page
    const Image image = rasterised(text, Vec2(page), page * fine, page * fine);
    double sum = 0;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4)
        sum += image.pixels[i] > 0 ? 1 : 0;
    return sum / (fine * fine);
}

/// Where they differ librsvg 2.54 does not know the feature, follows the locale's language, or has
/// a mistake: it cuts symbols just when they overflow visibly, and clips no clips.
enum class Painted { same, differs };

struct Case {
    const char* name;
    std::string body; // beside a square of 10 x 10 pixels at (80, 80)
    double area;      // without that square
    Painted by_librsvg = Painted::same;
};

constexpr const char* square = "<rect x='80' y='80' width='10' height='10'/>";

void check(const std::vector<Case>& cases) {
    for (const Case& tested : cases) {
        const std::string text = on_page(tested.body + square);
        double got = -1;
        EXPECT_EQ(error_of([&] { got = area(svg_region(text)); }), "no error") << tested.name;
        const double want = tested.area + 100;
        EXPECT_NEAR(got, want, 1e-3 * want) << tested.name;
        if (tested.by_librsvg == Painted::same) {
            EXPECT_NEAR(painted(text), want, 0.02 * want) << tested.name << ", librsvg";
        }
    }
}

std::string rect(const std::string& attributes) {
    return "<rect x='10' y='10' width='20' height='20' " + attributes + "/>";
}

TEST(SvgVisible, PaintIsAreaUnlessItIsTransparent) {
    std::vector<Case> cases;
    for (const char* paint : {"none", "NONE", "transparent", "Transparent", "rgba(0, 0, 0, 0)",
                              "rgba(0 0 0 / 0)", "rgb(0 0 0 / 0%)", "rgba(0,0,0,0.0)", "#0000",
                              "#FFF0", "#ffffff00", "hsla(0,0%,0%,0)", "hsl(120deg 50% 50% / 0)"})
        cases.push_back({paint, rect(std::string("fill='") + paint + "'"), 0});
    for (const char* paint : {"oklch(50% 0.1 20 / 0)", "hwb(0 0% 0% / 0%)", "color(srgb 1 0 0 / 0)",
                              "light-dark(transparent, red)"})
        cases.push_back(
            {paint, rect(std::string("style='fill:") + paint + "'"), 0, Painted::differs});
    for (const char* paint :
         {"red", "Red", "#fff", "#FFFF", "#12345678", "rgb(1,2,3)", "rgba(1,2,3,.5)",
          "rgb(1 2 3 / 50%)", "hsl(1,2%,3%)", "currentColor", "CurrentColor", "#cd853f"})
        cases.push_back({paint, rect(std::string("fill='") + paint + "'"), 400});
    check(cases);
    check({{"current colour", "<g color='#0000'>" + rect("fill='currentColor'") + "</g>", 0},
           {"current colour of the element",
            "<g color='#0000'>" + rect("fill='currentColor' color='red'") + "</g>", 400},
           {"current colour is inherited as such",
            "<g fill='currentColor' color='#0000'>" + rect("color='red'") + "</g>", 400},
           {"icc colour", rect("fill='#cd853f icc-color(acmecmyk, 0.1, 0.2, 0.3)'"), 400,
            Painted::differs},
           {"variable", "<g style='--no: none'>" + rect("style='fill: var(--no)'") + "</g>", 0,
            Painted::differs},
           {"variable's fallback", rect("style='fill: var(--no, none)'"), 0, Painted::differs}});
}

TEST(SvgVisible, OpacitiesMultiply) {
    check({{"fill-opacity", rect("fill='white' fill-opacity='0'"), 0},
           {"per cent", rect("fill-opacity='0%'"), 0},
           {"in style", rect("style='fill:#fff;fill-opacity:0'"), 0},
           {"inherited", "<g fill-opacity='0'>" + rect("") + "</g>", 0},
           {"inherited and overridden", "<g fill-opacity='0'>" + rect("fill-opacity='1'") + "</g>",
            400},
           {"opacity", rect("opacity='0'"), 0},
           {"negative", rect("opacity='-1'"), 0},
           {"opacity of a group",
            "<g opacity='0'><g opacity='1'>" + rect("opacity='1'") + "</g></g>", 0},
           {"faint", rect("opacity='.1' fill='rgba(0,0,0,.5)' fill-opacity='.5'"), 400},
           {"opacity does not lift fill-opacity", rect("opacity='1' fill-opacity='0'"), 0}});
}

TEST(SvgVisible, DisplayAndVisibility) {
    check({{"display", rect("display='none'"), 0},
           {"display in capitals", rect("style='DISPLAY: None'"), 0, Painted::differs},
           {"display is not undone inside",
            "<g display='none'>" + rect("display='inline'") + "</g>", 0},
           {"visibility", rect("visibility='hidden'"), 0},
           {"collapse", rect("visibility='collapse'"), 0},
           {"visibility is undone inside",
            "<g visibility='hidden'>" + rect("visibility='visible'") + "</g>", 400}});
}

TEST(SvgVisible, TheCascadeDecides) {
    const auto styled = [](const std::string& sheet, const std::string& attributes) {
        return "<style>" + sheet + "</style>" + rect(attributes);
    };
    // The square beside is a rect too and has neither class nor id.
    check(
        {{"class", styled(".a{fill:none}", "class='a'"), 0},
         {"comma list", styled(".a,.b{fill:none}.b{stroke-width:2}", "class='a'"), 0},
         {"several classes", styled(".b{fill:none}", "class='a b  c'"), 0},
         {"both classes", styled(".a.b{fill:none}", "class='a'"), 400},
         {"case of classes", styled(".A{fill:none}", "class='a'"), 400},
         {"id", styled("#i{fill:none}", "id='i'"), 0},
         {"before the attribute", styled(".a{fill:red}", "class='a' fill='none'"), 400},
         {"after the style", styled(".a{fill:red}", "class='a' style='fill:none'"), 0},
         {"important before the style",
          styled(".a{fill:red ! IMPORTANT}", "class='a' style='fill:none'"), 400},
         {"both important",
          styled(".a{fill:red!important}", "class='a' style='fill:none!important'"), 0},
         {"important in the style", rect("style='fill:none!important'"), 0},
         {"the later one", styled(".a{fill:red}.a{fill:none}", "class='a'"), 0},
         {"the more specific one",
          styled("#i{fill:none}.a{fill:red}rect{fill:blue}", "id='i' class='a'"), 0},
         {"the last of a block", styled(".a{fill:none;fill:red}", "class='a'"), 400},
         {"element and class", styled("rect.a{fill:none}circle.a{fill:red}", "class='a'"), 0},
         {"capitals in properties", styled(".a{FILL:None}", "class='a'"), 0, Painted::differs},
         {"comments", styled("/* .a{} */ .a /*x*/ {/*y*/fill/**/:none/*;*/}", "class='a'"), 0},
         {"CDATA",
          "<style><![CDATA[ .a > .b { fill: none } ]]></style><g class='a'>" + rect("class='b'") +
              "</g>",
          0},
         {"descendant",
          "<style>.a .b{fill:none}</style><g class='a'><g>" + rect("class='b'") + "</g></g>", 0},
         {"not a child",
          "<style>.a>.b{fill:none}</style><g class='a'><g>" + rect("class='b'") + "</g></g>", 400},
         {"sibling", "<style>.a+.b{fill:none}</style><g class='a'/>" + rect("class='b'"), 0},
         {"later sibling", "<style>.a~.b{fill:none}</style><g class='a'/><g/>" + rect("class='b'"),
          0},
         {"attribute", styled("[data-x]{fill:none}", "data-x='1'"), 0},
         {"attribute's value", styled("[data-x='bg'],[data-x^=q]{fill:none}", "data-x='bg'"), 0},
         {"attribute's end", styled("[data-x$='d']{fill:none}", "data-x='background'"), 0},
         {"first child", "<style>g>:first-child{fill:none}</style><g>" + rect("") + "</g>", 0},
         {"second child", "<style>g>:nth-child(2n){fill:none}</style><g><g/>" + rect("") + "</g>",
          0},
         {"not", "<style>rect:not(.keep):not([x='80']){fill:none}</style>" + rect(""), 0},
         {"pointer", styled(".a:hover{fill:none}", "class='a'"), 400},
         {"media", styled("@media screen{.a{fill:none}}", "class='a'"), 0, Painted::differs},
         {"dark screens", styled("@media (prefers-color-scheme: dark){.a{fill:none}}", "class='a'"),
          400},
         {"light screens",
          styled("@media (prefers-color-scheme:light){.a{fill:none}}", "class='a'"), 0,
          Painted::differs},
         {"print", styled("@media print{.a{fill:none}}", "class='a'"), 400},
         {"fonts", styled("@font-face{font-family:x;src:local(y)}.a{fill:none}", "class='a'"), 0},
         {"a style after its use", rect("class='a'") + "<style>.a{fill:none}</style>", 0},
         {"of a group", "<style>.a{fill:none}</style><g class='a'>" + rect("") + "</g>", 0},
         {"empty rule", styled(".a{}.a{;;fill:none;;}", "class='a'"), 0}});
}

TEST(SvgVisible, GradientsAreAreaUnlessAllIsTransparent) {
    const auto gradient = [](const std::string& stops) {
        return "<defs><linearGradient id='g'>" + stops + "</linearGradient></defs>" +
               rect("fill='url(#g)'");
    };
    check(
        {{"opaque", gradient("<stop stop-color='red'/><stop offset='1' stop-color='blue'/>"), 400},
         {"transparent",
          gradient("<stop stop-opacity='0'/><stop offset='1' "
                   "style='stop-color:transparent'/>"),
          0},
         {"none", gradient(""), 0},
         {"of another",
          "<linearGradient id='h'><stop stop-opacity='0'/></linearGradient>"
          "<radialGradient id='g' xlink:href='#h'/>" +
              rect("fill='url(#g)'"),
          0},
         {"fallback", rect("fill='url(#nothing) none'"), 0}});
}

TEST(SvgVisible, TransformsOfCss) {
    // Twice as large in both directions, or in one; turned about its corner it leaves nothing.
    check({{"scale", rect("style='transform:scale(2)'"), 1600},
           {"scale per axis", rect("style='transform: scaleX(2) scaleY(.5)'"), 400},
           {"before the attribute", rect("transform='scale(3)' style='transform:scale(2)'"), 1600,
            Painted::differs},
           {"none", rect("transform='scale(3)' style='transform:none'"), 400, Painted::differs},
           {"matrix", rect("style='transform:matrix(2,0,0,1,0,0)'"), 800},
           {"by class", "<style>.a{transform:scale(2)}</style>" + rect("class='a'"), 1600}});
    struct Placed {
        const char* style;
        Vec2 min, max;
    };
    // The square from (10, 10) to (30, 30) on a page of 100 x 100.
    for (const auto& [style, min, max] : std::vector<Placed>{
             {"transform:translate(5px, 10px)", {15, 20}, {35, 40}},
             {"transform:translateX(1in)", {106, 10}, {126, 30}},
             {"transform:translate(10%)", {20, 10}, {40, 30}},
             {"transform:rotate(90deg)", {-30, 10}, {-10, 30}},
             {"transform:rotate(0.25turn)", {-30, 10}, {-10, 30}},
             {"transform:rotate(100grad)", {-30, 10}, {-10, 30}},
             {"transform:ROTATE(1.5707963268rad)", {-30, 10}, {-10, 30}},
             {"transform:rotate(90deg);transform-origin:50% 50%", {70, 10}, {90, 30}},
             {"transform:rotate(90deg);transform-origin:center", {70, 10}, {90, 30}},
             {"transform:rotate(180deg);transform-origin:right top", {170, -30}, {190, -10}},
             {"transform:rotate(180deg);transform-origin:20px 20px", {10, 10}, {30, 30}},
             {"transform:scale(2);transform-box:fill-box;transform-origin:center",
              {0, 0},
              {40, 40}},
             {"transform:scale(2);transform-box:fill-box", {10, 10}, {50, 50}},
             {"transform:translate(50%,0);transform-box:fill-box", {20, 10}, {40, 30}},
             {"translate:5px 10px", {15, 20}, {35, 40}},
             {"scale:2;translate:5px", {25, 20}, {65, 60}},
             {"rotate:90deg", {-30, 10}, {-10, 30}},
             {"transform:skewX(45deg)", {20, 10}, {60, 30}},
             {"transform:translate(10px) scale(2)", {30, 20}, {70, 60}},
             {"transform-origin:20px 20px", {10, 10}, {30, 30}}}) {
        const Box2 box = bounds(svg_region(on_page(rect(std::string("style='") + style + "'"))));
        EXPECT_NEAR((box.min - min).length(), 0, 1e-4) << style << " " << box.min;
        EXPECT_NEAR((box.max - max).length(), 0, 1e-4) << style << " " << box.max;
    }
    const Box2 turned =
        bounds(svg_region(on_page(rect("transform='rotate(180)' transform-origin='20 20'"))));
    EXPECT_NEAR((turned.min - Vec2(10)).length(), 0, 1e-4);
}

TEST(SvgVisible, SwitchesShowTheFirstThatFits) {
    const std::string small = "<rect width='10' height='10'/>";
    check({{"first", "<switch>" + small + rect("") + "</switch>", 100},
           {"extension",
            "<switch><foreignObject requiredExtensions='http://x/'/>" + small + "</switch>", 100},
           {"language", "<switch>" + rect("systemLanguage='xx'") + small + "</switch>", 100},
           {"languages", "<switch>" + rect("systemLanguage='de, en-GB'") + small + "</switch>", 400,
            Painted::differs},
           {"none fits", "<switch>" + rect("systemLanguage='xx'") + "</switch>", 0},
           {"titles are no choice", "<switch><title>x</title>" + small + "</switch>", 100,
            Painted::differs},
           {"HTML that is missing",
            "<switch><foreignObject requiredFeatures="
            "'http://www.w3.org/TR/SVG11/feature#Extensibility'/>" +
                small + "</switch>",
            100, Painted::differs},
           {"hidden but chosen",
            "<switch><g display='none'>" + rect("") + "</g>" + small + "</switch>", 0}});
}

TEST(SvgVisible, ClonesSymbolsAndViewports) {
    const std::string shape = "<defs><rect id='r' width='20' height='10'/></defs>";
    check({{"use", shape + "<use href='#r' x='10' y='20'/>", 200},
           {"use by xlink", shape + "<use xlink:href='#r'/>", 200},
           {"use of a group",
            "<defs><g id='g'><rect width='5' height='5'/><rect x='10' width='5' "
            "height='5'/></g></defs><use href='#g' transform='scale(2)'/>",
            200},
           {"inherits from the clone", shape + "<use href='#r' fill='none'/>", 0},
           {"use of a clone",
            shape + "<defs><use id='u' href='#r' x='5'/></defs>"
                    "<use href='#u' y='30'/>",
            200},
           {"symbol",
            "<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol>"
            "<use href='#s' x='10' y='10' width='30' height='30'/>",
            900},
           {"symbol that cuts",
            "<symbol id='s' viewBox='0 0 10 10'><rect width='50' height='5'/>"
            "</symbol><use href='#s' width='20' height='20'/>",
            200, Painted::differs},
           {"symbol that does not cut",
            "<symbol id='s' viewBox='0 0 10 10' overflow='visible'><rect width='20' height='5'/>"
            "</symbol><use href='#s' width='20' height='20'/>",
            400, Painted::differs},
           {"a nested svg cuts",
            "<svg x='10' y='10' width='20' height='20'><rect x='10' "
            "width='50' height='50'/></svg>",
            200},
           {"or does not",
            "<svg x='10' y='10' width='20' height='20' overflow='visible'><rect "
            "x='10' width='20' height='30'/></svg>",
            600},
           {"of no width", "<svg width='0' height='20'>" + rect("") + "</svg>", 0},
           {"shares", "<rect width='20%' height='10%'/>", 200},
           {"shares of a nested svg",
            "<svg width='50' height='40'><rect width='20%' "
            "height='50%'/></svg>",
            200},
           {"share of a radius", "<circle cx='30' cy='30' r='10%'/>", pi * 100},
           {"ems", "<g font-size='10'><rect width='2em' height='1em'/></g>", 200},
           {"geometry by style",
            "<style>.c{r:10px;cx:30px;cy:30px}</style><circle class='c' r='1'/>", pi * 100},
           {"path by style", "<path d='M0 0h1v1z' style='d:path(\"M0 0h20v10h-20z\")'/>", 200,
            Painted::differs},
           {"empty paths", "<path/><path d=''/><path d='none'/>", 0}});
}

TEST(SvgVisible, ClipsCut) {
    const std::string half = "<clipPath id='c'><rect width='20' height='100'/></clipPath>";
    check(
        {{"a shape", half + rect("clip-path='url(#c)'"), 200},
         {"a group", half + "<g clip-path='url(#c)'>" + rect("") + "</g>", 200},
         {"in style", half + rect("style='clip-path:url(\"#c\")'"), 200},
         {"of no area", "<clipPath id='c'/>" + rect("clip-path='url(#c)'"), 0},
         {"moved with the shape", half + rect("clip-path='url(#c)' transform='translate(5)'"), 200},
         {"in shares of the box",
          "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='.25'/>"
          "</clipPath>" +
              rect("clip-path='url(#c)'"),
          50},
         {"two shapes",
          "<clipPath id='c'><rect x='10' width='5' height='100'/><rect x='20' width='5' "
          "height='100'/></clipPath>" +
              rect("clip-path='url(#c)'"),
          200},
         {"by evenodd",
          "<clipPath id='c'><path clip-rule='evenodd' d='M10 10h20v20h-20zM15 15h10v10h-10z'/>"
          "</clipPath>" +
              rect("clip-path='url(#c)'"),
          300},
         {"a clipped clip",
          half +
              "<clipPath id='d' clip-path='url(#c)'><rect width='100' "
              "height='15'/></clipPath>" +
              rect("clip-path='url(#d)'"),
          50, Painted::differs},
         {"twice",
          half +
              "<clipPath id='d'><rect width='100' height='15'/></clipPath>"
              "<g clip-path='url(#c)'>" +
              rect("clip-path='url(#d)'") + "</g>",
          50},
         {"by a clone",
          "<defs><rect id='r' width='20' height='100'/></defs><clipPath id='c'>"
          "<use href='#r'/></clipPath>" +
              rect("clip-path='url(#c)'"),
          200},
         {"fill does not matter",
          "<clipPath id='c'><rect width='20' height='100' fill='none'/></clipPath>" +
              rect("clip-path='url(#c)'"),
          200},
         {"hidden shapes do not clip",
          "<clipPath id='c'><rect width='20' height='100'/><rect width='99' height='99' "
          "display='none'/></clipPath>" +
              rect("clip-path='url(#c)'"),
          200}});
}

TEST(SvgVisible, FillRulesAndPrefixes) {
    const std::string ring = "d='M10 10h20v20h-20zM15 15h10v10h-10z'";
    check({{"by style", "<path " + ring + " style='fill-rule:evenodd'/>", 300},
           {"by class", "<style>.a{fill-rule:EvenOdd}</style><path class='a' " + ring + "/>", 300},
           {"inherited", "<g fill-rule='evenodd'><path " + ring + "/></g>", 300},
           {"nonzero", "<path " + ring + "/>", 400}});
    EXPECT_NEAR(area(svg_region("<ns0:svg xmlns:ns0='http://www.w3.org/2000/svg'><ns0:g><ns0:rect "
                                "width='3' height='2'/></ns0:g></ns0:svg>")),
                6, 1e-6);
}

} // namespace
} // namespace scree
