// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/uri.h"

#include "core/base64.h"
#include "core/error.h"

#include <algorithm>
#include <filesystem>

namespace scree {

namespace {

std::optional<int> hex_digit(char c) {
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    return std::nullopt;
}

// For messages: data that was meant as a path would fill pages.
std::string shortened(const std::string& uri) {
    constexpr std::size_t most = 200;
    return uri.size() <= most ? uri : uri.substr(0, most) + "...";
}

} // namespace

std::string percent_decoded(std::string_view uri) {
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size()) {
            const auto high = hex_digit(uri[i + 1]);
            const auto low = hex_digit(uri[i + 2]);
            if (high && low) {
                out += static_cast<char>(*high * 16 + *low);
                i += 2;
                continue;
            }
        }
        out += uri[i];
    }
    return out;
}

std::optional<std::string> data_of_uri(std::string_view uri) {
    if (!uri.starts_with("data:"))
        return std::nullopt;
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos)
        throw Error("a data: URI has no comma");
    const std::string data = percent_decoded(uri.substr(comma + 1));
    if (!uri.substr(0, comma).ends_with(";base64"))
        return data;
    auto bytes = base64_decoded(data);
    if (!bytes)
        throw Error("the base64 of a data: URI is damaged");
    return bytes;
}

std::string file_of_uri(const std::string& uri, const std::string& folder) {
    if (uri.find("://") != std::string::npos)
        throw Error(shortened(uri) + " is not a file beside it");
    std::string with_slashes = uri;
    std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
    for (const std::string& name :
         {percent_decoded(uri), uri, percent_decoded(with_slashes), with_slashes}) {
        std::string path = (std::filesystem::path(folder) / name).string();
        std::error_code code;
        if (std::filesystem::is_regular_file(path, code)) // no pipe and no device
            return path;
    }
    throw Error("there is no file " + shortened(uri) + " beside it");
}

} // namespace scree
