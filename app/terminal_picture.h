// SPDX-License-Identifier: GPL-3.0-or-later
// A picture as text for a terminal of 24-bit colours.
#pragma once

#include "core/image.h"

#include <string>

namespace scree {

/// A picture in a terminal.
struct TerminalPicture {
    std::string text; // lines, each with an end
    int rows = 0;
};

/// `shown`: R, G, B for a screen, as of to_display. Fits into `columns` x `rows` characters, each
/// of which shows two square pixels, one above the other. Empty when there is no room.
TerminalPicture terminal_picture(const Image& shown, int columns, int rows);

} // namespace scree
