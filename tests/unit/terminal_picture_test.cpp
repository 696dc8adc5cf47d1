// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal_picture.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace scree {
namespace {

TEST(TerminalPicture, ShowsTwoPixelsPerCharacter) {
    Image image(2, 2, {"R", "G", "B"});
    image.pixels = {1, 0, 0, 0, 1, 0, 0, 0, 1, 2, -1, 0.5F};
    const TerminalPicture picture = terminal_picture(image, 80, 24);
    EXPECT_EQ(picture.rows, 1);
    EXPECT_EQ(picture.text, "\x1b[38;2;255;0;0;48;2;0;0;255m\u2580"
                            "\x1b[38;2;0;255;0;48;2;255;0;128m\u2580"
                            "\x1b[0m\n");
}

TEST(TerminalPicture, FitsAndKeepsItsProportions) {
    const Image image(1280, 720, {"R", "G", "B"});
    for (const auto& [columns, rows, expected] :
         {std::array{80, 24, 22}, {80, 10, 10}, {1, 24, 1}, {400, 400, 112}}) {
        const TerminalPicture picture = terminal_picture(image, columns, rows);
        EXPECT_EQ(picture.rows, expected);
        EXPECT_EQ(std::ranges::count(picture.text, '\n'), expected);
    }
    EXPECT_EQ(terminal_picture(image, 80, 0).rows, 0);
    EXPECT_EQ(terminal_picture(image, 80, -3).text, "");
}

} // namespace
} // namespace scree
