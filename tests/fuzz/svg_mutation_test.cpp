// SPDX-License-Identifier: GPL-3.0-or-later
// Deterministic mutations of small valid drawings: each must either give a region with finite
// coordinates or be rejected with an Error, in bounded time.
#include "core/error.h"
#include "core/file.h"
#include "core/random.h"
#include "geometry/plane/svg/svg_document.h"
#include "tests/support/damaged.h"

#include <gtest/gtest.h>

#include <chrono>

namespace scree {
namespace {

const std::vector<std::string>& drawings() {
    static const std::vector<std::string> all{
        R"svg(<?xml version="1.0"?><svg width="30mm" viewBox="0 0 20 10" fill-rule="evenodd">
<g id="a" transform="translate(2,3) rotate(30 1 1) skewX(5)"><path d="M1 1h4v3a2 1 30 0 1-2 2q1 1-2 0t-1-1z
M2 2c1 0 1 1 0 1s-1-1 0-1"/><rect x="1" y="2" width="5" height="3" rx="1"/></g>
<circle cx="4" cy="5" r="2" style="fill:none"/><svg x="1" viewBox="0 0 5 5" width="4" height="4">
<polygon points="0,0 5,0 5,5 1 4"/></svg><ellipse rx="3" ry="2"/></svg>)svg",
        R"svg(<svg><defs><path id="p" d="M0,0L9,9L9,0L0,9z"/></defs><polyline points="0 0 1 5 3 2"/>
<path transform="matrix(1 .5 -.5 1 3 4)" d="m1e1-1.5.5.5C1 2 3 4 5 6S3 2 1 0zl3 3H8V2Z"/></svg>)svg",
        R"svg(<svg viewBox="0 0 30 30"><style>/*a*/ .a, g > rect:not(.b) { fill : none !important }
@media screen { #c { transform: rotate(.1turn) scale(2, 50%); transform-box: fill-box } }</style>
<clipPath id="k" clipPathUnits="objectBoundingBox"><circle cx=".5" cy=".5" r="50%"/></clipPath>
<linearGradient id="l"><stop stop-color="#1234" stop-opacity="50%"/></linearGradient>
<symbol id="s" viewBox="0 0 4 4"><rect class="b" width="4" height="9"/></symbol>
<switch><g systemLanguage="xx"/><g id="c" clip-path="url(#k)"><rect class="b" x="1em" width="9"
height="50%" fill="url(#l) red"/></g></switch><use href="#s" x="3" width="6" height="6"/>
<rect class="a" width="30" height="30" style="opacity:var(--o, .5)"/></svg>)svg"};
    return all;
}

const std::vector<std::string> pieces{"nan",
                                      "-1",
                                      "1e999",
                                      "1e-999",
                                      "99999999999999999999",
                                      "0",
                                      " ",
                                      ",",
                                      "M",
                                      "z",
                                      "a",
                                      "<",
                                      ">",
                                      "<g>",
                                      "</g>",
                                      "\"",
                                      "&lt;",
                                      "&#x110000;",
                                      "scale(1e9)",
                                      "rotate(1e9)",
                                      "%",
                                      "mm",
                                      "url(#k)",
                                      "url(#c)",
                                      "#s",
                                      "{",
                                      "}",
                                      ";",
                                      "!important",
                                      "var(--o)",
                                      std::string(3, '\xff'),
                                      std::string(2, '\0'),
                                      "<!--",
                                      "<![CDATA[",
                                      "<!DOCTYPE q [<!ENTITY e \"e\">]>"};

void read_and_fill(const std::string& bytes) {
    const SvgDrawing drawing = read_svg_text(bytes, "");
    std::size_t points = 0;
    const auto flattened = [&](const std::vector<SvgShape>& shapes) {
        std::vector<FilledRings> out;
        for (const SvgShape& shape : shapes) {
            const Box2 box = shape.path.control_box();
            const double tolerance = 0.01 * std::max(box.size().x, box.size().y);
            if (tolerance > 0)
                out.push_back(
                    {shape.path.flatten(tolerance, points, 100'000), shape.rule, shape.within});
        }
        return out;
    };
    Clips clips;
    for (const std::vector<SvgShape>& clip : drawing.clips)
        clips.push_back(flattened(clip));
    const Region region = fill(flattened(drawing.shapes), clips);
    for (const Ring& ring : region.rings)
        for (const Vec2& v : ring)
            ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y));
    ASSERT_GT(area(region), 0);
}

TEST(SvgMutation, EveryDamagedDrawingReadsOrIsRefused) {
    for (std::size_t d = 0; d < drawings().size(); ++d) {
        int read = 0;
        int refused = 0;
        double slowest = 0;
        EXPECT_NO_THROW(read_and_fill(drawings()[d])) << d;
        for (std::uint64_t i = 0; i < 3000; ++i) {
            Random random(hash_bytes(drawings()[d]), Purpose::test, i);
            const std::string bytes = damaged(drawings()[d], pieces, random);
            const auto start = std::chrono::steady_clock::now();
            try {
                read_and_fill(bytes);
                ++read;
            } catch (const Error&) {
                ++refused;
            } catch (const std::exception& problem) {
                ADD_FAILURE() << d << ' ' << i << ": " << problem.what() << '\n' << bytes;
            }
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
            slowest = std::max(slowest, taken.count());
        }
        EXPECT_GT(refused, 0) << d;
        EXPECT_GT(read, 0) << d;
        EXPECT_LT(slowest, 5.0) << d;
        RecordProperty("drawing" + std::to_string(d), std::to_string(read) + " read");
    }
}

TEST(SvgMutation, EveryTruncationReadsOrIsRefused) {
    for (const std::string& drawing : drawings())
        for (std::size_t size = 0; size < drawing.size(); ++size) {
            try {
                read_and_fill(drawing.substr(0, size));
            } catch (const Error&) {
                continue;
            } catch (const std::exception& problem) {
                ADD_FAILURE() << size << ": " << problem.what();
            }
        }
}

// A million nested groups, which must not cause recursion.
TEST(SvgMutation, DeepNestingIsRefused) {
    std::string deep = "<svg>";
    for (int i = 0; i < 1'000'000; ++i)
        deep += "<g>";
    EXPECT_THROW(read_svg_text(deep, ""), Error); // not closed
    for (int i = 0; i < 1'000'000; ++i)
        deep += "</g>";
    EXPECT_THROW(read_svg_text(deep + "</svg>", ""), Error);
    EXPECT_THROW(read_svg_text(deep + "</svg>", "nobody"), Error);
}

} // namespace
} // namespace scree
