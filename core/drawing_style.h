// SPDX-License-Identifier: GPL-3.0-or-later
// References and rules in the styles of SVG drawings.
#pragma once

#include <string>
#include <string_view>

namespace scree {

/// Whether a reference stays in the file: `#id`, or an embedded PNG or JPEG.
bool is_inside(std::string_view reference);

/// The first reference of a property's value or a style sheet that leaves the file, or what might
/// hide one (an escape beside a bracket); empty when there is none.
std::string outside_reference(std::string_view value);

/// Throws Error for a style sheet that leaves the file, or has rules with @.
void check_style(std::string_view sheet);

/// The value with `prefix` before each id in its `url(#id)`.
std::string with_prefix(std::string_view value, std::string_view prefix);

/// A checked style sheet whose rules apply only within the element of the id `scope`, with
/// `prefix` before all ids that it names.
std::string scoped_style(std::string_view sheet, std::string_view prefix, std::string_view scope);

} // namespace scree
