// SPDX-License-Identifier: GPL-3.0-or-later
// What of a drawing is left out of its area is told.
#include "tests/support/errors.h"
#include "tests/support/svg.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using tests::error_of;
using tests::svg;
using tests::svg_region;

std::string on_page(const std::string& body) {
    return svg("\n" + body + "<rect x='80' y='80' width='10' height='10'/>",
               "width='100' height='100' viewBox='0 0 100 100'");
}

std::string rect(const std::string& attributes) {
    return "<rect x='10' y='10' width='20' height='20' " + attributes + "/>";
}

TEST(SvgLeftOut, WarningsTellWhatIsLeftOut) {
    const auto said = [](const std::string& body, const std::string& element = "") {
        std::string out;
        svg_region(on_page(body), element, [&](const std::string& text) { out += text + "|"; });
        return out;
    };
    const std::string stroke = "line 2: rect: its stroke is no part of the region, which is what "
                               "is filled";
    EXPECT_EQ(said(rect("")), "");
    EXPECT_EQ(said(rect("stroke='red'")), stroke + "|");
    EXPECT_EQ(said(rect("stroke='red'") + "<line stroke='red'/>"), stroke + "; 1 more is like it|");
    for (const char* unseen :
         {"stroke='none'", "stroke='red' stroke-width='0'", "stroke='red' stroke-opacity='0'",
          "stroke='red' opacity='0'", "stroke='red' visibility='hidden'"})
        EXPECT_EQ(said(rect(unseen)), "") << unseen;
    EXPECT_EQ(said(rect("filter='url(#f)'")), "line 2: rect: its filter is not read|");
    EXPECT_EQ(said("<path d='M0 0h9v9z' style='marker-end:url(#m)'/>"),
              "line 2: path: its markers are not read|");
    const std::string beyond =
        "line 2: circle: reaches beyond the drawing's page, which does not cut it|";
    EXPECT_EQ(said("<circle cx='95' cy='50' r='10'/>"), beyond);
    EXPECT_EQ(said("<circle cx='950' cy='50' r='10'/>"), beyond);
    EXPECT_EQ(said("<circle id='c' cx='95' cy='50' r='10'/>", "c"), "");
    // Control points reach beyond the page, the curve does not.
    EXPECT_EQ(said("<path d='M90 40C105 40 105 60 90 60z'/>"), "line 2: path: reaches beyond the "
                                                               "drawing's page, which does not "
                                                               "cut it|");
    EXPECT_EQ(said("<path d='M90 40C101 40 101 60 90 60z'/>"), "");
}

TEST(SvgLeftOut, ClonesOfClonesEnd) {
    std::string body = "<defs><g id='c0'><rect width='1' height='1'/></g>";
    for (int i = 1; i < 40; ++i) {
        const std::string use = "<use href='#c" + std::to_string(i - 1) + "'/>";
        body += "<g id='c" + std::to_string(i) + "'>" + use + use + "</g>";
    }
    EXPECT_NE(error_of([&] {
                  svg_region(svg(body + "</defs><use href='#c39'/>"));
              }).find("more than 200000 elements are drawn, with clones"),
              std::string::npos);
}

} // namespace
} // namespace scree
