// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/glyphs.h"

#include "shapes/mesh/outline.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>

namespace scree {

namespace {

// Rings separated by '|', the outer one first. A ring consists of corners "x,y" and arcs
// "a:x,y,radius,from,to" with angles in degrees.
struct Glyph {
    char character;
    const char* rings;
};

constexpr Glyph glyphs[] = {
    {'A', "0,0 1.55,0 1.98,1.3 4.22,1.3 4.65,0 6.2,0 3.9,7 2.3,7 | 2.37,2.5 3.83,2.5 3.1,4.72"},
    {'B', "0,0 a:3.1,1.95,1.95,-90,63 a:3,5.2,1.8,-57,90 0,7 | 1.5,1.3 a:3.05,2,.7,-90,90 "
          "1.5,2.7 | 1.5,4.3 a:2.95,4.98,.68,-90,90 1.5,5.66"},
    {'C', "a:2.8,4.2,2.8,25,180 a:2.8,2.8,2.8,180,335 a:2.8,2.8,1.35,335,180 "
          "a:2.8,4.2,1.35,180,25"},
    {'D', "0,0 a:2.5,2.9,2.9,-90,0 a:2.5,4.1,2.9,0,90 0,7 | 1.5,1.4 a:2.5,2.9,1.5,-90,0 "
          "a:2.5,4.1,1.5,0,90 1.5,5.6"},
    {'E', "0,0 4.6,0 4.6,1.4 1.5,1.4 1.5,2.8 4.1,2.8 4.1,4.2 1.5,4.2 1.5,5.6 4.6,5.6 4.6,7 0,7"},
    {'F', "0,0 1.5,0 1.5,2.7 4.1,2.7 4.1,4.1 1.5,4.1 1.5,5.6 4.6,5.6 4.6,7 0,7"},
    {'G', "a:2.8,4.2,2.8,25,180 a:2.8,2.8,2.8,180,360 5.6,3.7 3,3.7 3,2.45 "
          "a:2.8,2.8,1.35,345,180 a:2.8,4.2,1.35,180,25"},
    {'H', "0,0 1.5,0 1.5,2.8 3.9,2.8 3.9,0 5.4,0 5.4,7 3.9,7 3.9,4.2 1.5,4.2 1.5,7 0,7"},
    {'I', "0,0 1.5,0 1.5,7 0,7"},
    {'J', "a:2.3,2.3,2.3,190,360 4.6,7 3.1,7 a:2.3,2.3,.8,360,190"},
    {'K', "0,0 1.5,0 1.5,2.1 2.3,3.05 3.9,0 5.6,0 3.3,4.2 5.5,7 3.7,7 1.5,4.1 1.5,7 0,7"},
    {'L', "0,0 4.4,0 4.4,1.4 1.5,1.4 1.5,7 0,7"},
    {'M', "0,0 1.45,0 1.45,4.4 3.2,1.7 4.95,4.4 4.95,0 6.4,0 6.4,7 5,7 3.2,4.1 1.4,7 0,7"},
    {'N', "0,0 1.45,0 1.45,4.5 4,0 5.5,0 5.5,7 4.05,7 4.05,2.5 1.5,7 0,7"},
    {'O', "a:2.8,2.8,2.8,180,360 a:2.8,4.2,2.8,0,180 | a:2.8,2.8,1.35,180,360 "
          "a:2.8,4.2,1.35,0,180"},
    {'P', "0,0 1.5,0 1.5,2.5 a:3,4.75,2.25,-90,90 0,7 | 1.5,3.87 a:2.95,4.75,.88,-90,90 1.5,5.63"},
    {'Q', "a:2.8,2.8,2.8,180,303 5,-.4 6,.55 a:2.8,2.8,2.8,333,360 a:2.8,4.2,2.8,0,180 | "
          "a:2.8,2.8,1.35,180,360 a:2.8,4.2,1.35,0,180"},
    {'R', "0,0 1.5,0 1.5,2.5 2.3,2.5 3.75,0 5.5,0 a:3,4.75,2.25,-62,90 0,7 | 1.5,3.87 "
          "a:2.95,4.75,.88,-90,90 1.5,5.63"},
    {'S', "a:2.9,4.875,2.125,25,90 a:2.1,4.875,2.125,90,270 a:2.9,2.125,.625,90,-90 "
          "a:2.1,2.125,.625,-90,-155 a:2.1,2.125,2.125,-155,-90 a:2.9,2.125,2.125,-90,90 "
          "a:2.1,4.875,.625,270,90 a:2.9,4.875,.625,90,25"},
    {'T', "1.9,0 3.4,0 3.4,5.6 5.3,5.6 5.3,7 0,7 0,5.6 1.9,5.6"},
    {'U', "a:2.7,2.7,2.7,180,360 5.4,7 3.9,7 a:2.7,2.7,1.2,360,180 1.5,7 0,7"},
    {'V', "2.2,0 3.8,0 6,7 4.4,7 3,2.3 1.6,7 0,7"},
    {'W', "1.6,0 3.1,0 4.2,4 5.3,0 6.8,0 8.4,7 6.85,7 6,2.9 4.95,7 3.45,7 2.4,2.9 1.55,7 0,7"},
    {'X', "0,0 1.75,0 2.9,2.2 4.05,0 5.8,0 3.85,3.55 5.7,7 3.95,7 2.9,4.95 1.85,7 .1,7 1.95,3.55"},
    {'Y', "2.15,0 3.65,0 3.65,2.7 5.8,7 4.15,7 2.9,4.2 1.65,7 0,7 2.15,2.7"},
    {'Z', "0,0 5,0 5,1.4 2.1,1.4 5,5.6 5,7 .2,7 .2,5.6 2.9,5.6 0,1.4"},
    {'0', "a:2.4,2.4,2.4,180,360 a:2.4,4.6,2.4,0,180 | a:2.4,2.4,.95,180,360 a:2.4,4.6,.95,0,180"},
    {'1', "1.6,0 3.1,0 3.1,7 1.9,7 .2,5.6 .2,4.1 1.6,5.1"},
    {'2', "0,0 4.8,0 4.8,1.4 2.3,1.4 a:2.4,4.7,2.3,-38,170 a:2.4,4.7,.85,170,-40 0,1.4"},
    {'3', "a:2.3,2.1,2.1,-160,48 a:2.3,5.05,1.95,-44,160 a:2.3,5.05,.6,160,-90 1.5,4.45 1.5,2.8 "
          "a:2.3,2.1,.7,90,-160"},
    {'4', "3,0 4.5,0 4.5,1.5 5.4,1.5 5.4,2.85 4.5,2.85 4.5,7 2.8,7 0,2.8 0,1.5 3,1.5 | "
          "1.75,2.85 3,2.85 3,4.85"},
    {'5', "a:2.4,2.3,2.3,-155,100 1.85,4.5 1.85,5.6 4.4,5.6 4.4,7 .4,7 .4,2.95 "
          "a:2.4,2.3,.85,140,-155"},
    {'6', "a:2.4,2.3,2.3,180,472 a:2.4,4.7,.85,180,30 a:2.4,4.7,2.3,30,180 | "
          "a:2.4,2.3,.85,0,342"},
    {'7', "1.1,0 2.75,0 4.9,5.6 4.9,7 0,7 0,5.6 3.2,5.6"},
    {'8', "a:2.4,2.15,2.15,130,410 a:2.4,5.1,1.9,-43,223 | a:2.4,2.15,.75,0,342 | "
          "a:2.4,5.1,.6,0,342"},
    {'9', "a:2.4,4.7,2.3,0,292 a:2.4,2.3,.85,0,-150 a:2.4,2.3,2.3,-150,0 | a:2.4,4.7,.85,0,342"},
    {'.', "0,0 1.5,0 1.5,1.5 0,1.5"},
    {'-', "0,2.7 2.6,2.7 2.6,4.1 0,4.1"},
};

constexpr double corner_radius = 0.22;
constexpr int arc_segments_per_turn = 36;

void add_corner(std::vector<Corner>& corners, const Corner& c) {
    const auto same = [&](const Corner& other) {
        return std::abs(other.x - c.x) + std::abs(other.y - c.y) < 1e-6;
    };
    if (corners.empty() || !same(corners.back()))
        corners.push_back(c);
}

void add_token(std::vector<Corner>& corners, const std::string& token) {
    Corner corner{.radius = corner_radius};
    double radius = 0;
    double from = 0;
    double to = 0;
    if (std::sscanf(token.c_str(), "a:%lf,%lf,%lf,%lf,%lf", &corner.x, &corner.y, &radius, &from,
                    &to) == 5) {
        const int segments =
            std::max(3, int(std::lround(std::abs(to - from) / 360 * arc_segments_per_turn)));
        for (const Vec2& p :
             arc({corner.x, corner.y}, radius, radians(from), radians(to), segments))
            add_corner(corners, {p.x, p.y, 0});
    } else if (std::sscanf(token.c_str(), "%lf,%lf", &corner.x, &corner.y) == 2) {
        add_corner(corners, corner);
    }
}

Ring ring_of(std::vector<Corner> corners) {
    const Corner& first = corners.front();
    const Corner& last = corners.back();
    if (std::abs(first.x - last.x) + std::abs(first.y - last.y) < 1e-6)
        corners.pop_back();
    return round_corners(corners, 5);
}

} // namespace

std::vector<Ring> glyph_rings(char character) {
    const auto* const glyph =
        std::find_if(std::begin(glyphs), std::end(glyphs),
                     [&](const Glyph& g) { return g.character == character; });
    std::vector<Ring> rings;
    if (glyph == std::end(glyphs))
        return rings;
    std::istringstream tokens(glyph->rings);
    std::vector<Corner> corners;
    for (std::string token; tokens >> token;) {
        if (token != "|") {
            add_token(corners, token);
            continue;
        }
        rings.push_back(ring_of(std::move(corners)));
        corners.clear();
    }
    rings.push_back(ring_of(std::move(corners)));
    for (std::size_t i = 0; i < rings.size(); ++i)
        if ((signed_area(rings[i]) > 0) != (i == 0))
            std::reverse(rings[i].begin(), rings[i].end());
    return rings;
}

} // namespace scree
