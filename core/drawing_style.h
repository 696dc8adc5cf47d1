// SPDX-License-Identifier: GPL-3.0-or-later
// References and rules in the style sheets of SVG drawings.
#pragma once

#include <string>
#include <string_view>

namespace scree {

/// A style sheet or an attribute `style` with a space for each comment, and without the <!-- and
/// --> that hid style sheets from old browsers.
std::string without_comments(std::string_view text);

/// Whether a reference stays in the file: `#id`, or an embedded PNG or JPEG.
bool is_inside(std::string_view reference);

/// The first reference in a property's value or a style sheet that points outside the file, or that
/// may be disguised (an escape together with a bracket); empty when there is none.
std::string outside_reference(std::string_view value);

/// Throws Error for a style sheet that refers to anything outside the file or has at-rules.
void check_style(std::string_view sheet);

/// The value with `prefix` before each id in its `url(#id)`.
std::string with_prefix(std::string_view value, std::string_view prefix);

/// A checked style sheet, rewritten so that its rules apply only within the element with the id
/// `scope` and `prefix` stands before all ids that it names.
std::string scoped_style(std::string_view sheet, std::string_view prefix, std::string_view scope);

} // namespace scree
