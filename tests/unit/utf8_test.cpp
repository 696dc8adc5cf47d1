// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/utf8.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

TEST(Utf8, KnowsWhatIsUtf8) {
    for (const char* text : {"", "plain", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"})
        EXPECT_TRUE(is_utf8(text)) << text;
    for (const char* text : {"\x80", "\xC3", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80",
                             "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "ab\xFF"})
        EXPECT_FALSE(is_utf8(text)) << visible(text);
}

TEST(Utf8, TextForATerminalCannotControlIt) {
    EXPECT_EQ(visible("a\tb\n\xC3\xA9\xE2\x82\xAC"), "a\tb\n\xC3\xA9\xE2\x82\xAC");
    EXPECT_EQ(visible("\x1b[31mred\r\a\x7f"), "\\x1b[31mred\\x0d\\x07\\x7f");
    EXPECT_EQ(visible("\xC2\x9B"
                      "31m"),
              "\\xc2\\x9b31m"); // a control sequence introducer of one character
    EXPECT_EQ(visible("\x9B\xFF"), "\\x9b\\xff");
    EXPECT_EQ(visible("a\xE2\x80\xAEtxt.exe"), "a\\xe2\\x80\\xaetxt.exe"); // right to left
    EXPECT_EQ(visible(std::string_view("\0", 1)), "\\x00");
}

} // namespace
} // namespace scree
