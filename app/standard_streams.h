// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says on stderr, and the results that it prints on stdout.
#pragma once

#include <string_view>

namespace scree {

/// Opens something in place of those of stdin, stdout and stderr that are closed, or a picture
/// would get the number of one of them. What is written there fails as before.
void fill_closed_streams() noexcept;

/// Writes to stderr, as `visible` (core/utf8.h) shows it. What cannot be written is lost: the work
/// is worth more than its messages.
void tell(std::string_view text) noexcept;

/// The same for what controls the terminal.
void control_terminal(std::string_view text) noexcept;

/// Writes a result to stdout. Throws Error (resource) when that is not possible.
void print_result(std::string_view text);

/// To be called at the end: what was printed may still be in a buffer. Throws as print_result.
void finish_results();

} // namespace scree
