// SPDX-License-Identifier: GPL-3.0-or-later
// Values as the bytes that they have in memory: for files that the same program reads again.
#pragma once

#include <istream>
#include <ostream>
#include <span>
#include <type_traits>

namespace scree {

/// Types that are their bytes. Imath's vectors define copying, but as the compiler would.
template <class T>
concept PlainData = std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T>;

template <PlainData T>
void write_values(std::ostream& out, std::span<const T> values) {
    out.write(reinterpret_cast<const char*>(values.data()),
              static_cast<std::streamsize>(values.size_bytes()));
}

template <PlainData T>
void write_value(std::ostream& out, const T& value) {
    write_values(out, std::span(&value, 1));
}

/// Leaves the stream in a failed state when it holds fewer.
template <PlainData T>
void read_values(std::istream& in, std::span<T> values) {
    in.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size_bytes()));
}

template <PlainData T>
T read_value(std::istream& in) {
    T value{};
    read_values(in, std::span(&value, 1));
    return value;
}

} // namespace scree
