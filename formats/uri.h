// SPDX-License-Identifier: GPL-3.0-or-later
// How files name other files that belong to them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace scree {

/// A URI's text with its %XX replaced by bytes (RFC 3986, section 2.1); what is no such escape
/// stays as it is, and so does a plus sign.
std::string percent_decoded(std::string_view uri);

/// The bytes of a data: URI (RFC 2397); none for URIs of other kinds. Throws Error (input) when it
/// has no comma or its base64 is damaged.
std::optional<std::string> data_of_uri(std::string_view uri);

/// The path of an existing regular file that a file in `folder` names by a URI, or by a plain path:
/// it is tried decoded, as it stands, and with / for \. Throws Error (input) when there is none, or
/// it lies on a network.
std::string file_of_uri(const std::string& uri, const std::string& folder);

} // namespace scree
