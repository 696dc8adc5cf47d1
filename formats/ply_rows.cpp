// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/ply_rows.h"

#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace scree {

namespace {

using Encoding = PlyHeader::Encoding;
using Scalar = PlyHeader::Scalar;

constexpr std::string_view white = " \t\r\n\v\f";

} // namespace

PlyRows::PlyRows(const PlyHeader& header)
    : header_(header),
      lines_(header.encoding == Encoding::ascii ? plain_text(header.body) : std::string_view()),
      rest_(header.encoding == Encoding::ascii ? std::string_view() : header.body) {}

std::size_t PlyRows::place(std::size_t row) const {
    return header_.encoding == Encoding::ascii ? header_.lines + lines_.number() : row;
}

std::string PlyRows::place_in_words(const PlyHeader::Element& element, std::size_t place) const {
    return fmt::format("{} {}", header_.encoding == Encoding::ascii ? "line" : element.name, place);
}

void PlyRows::next(const PlyHeader::Element& element, std::size_t row) {
    if (element.properties.empty())
        return; // such rows take no space
    try {
        read(element);
    } catch (const Error& problem) {
        throw Error(place_in_words(element, place(row)) + ": " +
                    problem.diagnostics().front().message);
    }
}

void PlyRows::read(const PlyHeader::Element& element) {
    if (header_.encoding == Encoding::ascii)
        do {
            if (!lines_.next())
                throw Error(fmt::format("the file ends too early: its header counts {} of {}",
                                        counted(element.count, "row"), element.name));
            rest_ = lines_.text();
        } while (rest_.find_first_not_of(white) == std::string_view::npos);
    values_.clear();
    starts_.assign(1, 0);
    for (const PlyHeader::Property& property : element.properties) {
        const std::size_t count = property.count ? list_length(*property.count) : 1;
        for (std::size_t k = 0; k < count; ++k)
            values_.push_back(number(property.type));
        starts_.push_back(values_.size());
    }
    if (header_.encoding == Encoding::ascii)
        if (const std::string_view more = take_word(rest_); !more.empty())
            throw Error(fmt::format("{} follows the {} that the properties of {} take",
                                    in_quotes(more), counted(values_.size(), "number"),
                                    element.name));
}

void PlyRows::finish() {
    if (header_.encoding == Encoding::ascii) {
        while (lines_.next())
            if (lines_.text().find_first_not_of(white) != std::string_view::npos)
                throw line_error(header_.lines + lines_.number(),
                                 "it goes on after the rows that its header counts");
    } else if (rest_.find_first_not_of(white) != std::string_view::npos) {
        throw Error(fmt::format("{} bytes follow the rows that its header counts", rest_.size()));
    }
}

double PlyRows::number(Scalar type) {
    if (header_.encoding != Encoding::ascii)
        return binary(type);
    const std::string_view word = take_word(rest_);
    if (word.empty())
        throw Error(
            fmt::format("the row ends too early, after {}", counted(values_.size(), "number")));
    return number_of(word);
}

std::size_t PlyRows::list_length(Scalar type) {
    const double count = number(type);
    // Every item takes at least one byte in all encodings.
    if (!(count >= 0 && count == std::floor(count)) || count > double(rest_.size()))
        throw Error("a list has an impossible length");
    return static_cast<std::size_t>(count);
}

template <class T>
double PlyRows::take() {
    if (rest_.size() < sizeof(T))
        throw Error("the file ends too early");
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), rest_.data(), sizeof(T));
    rest_.remove_prefix(sizeof(T));
    constexpr bool little = std::endian::native == std::endian::little;
    if (little != (header_.encoding == Encoding::little))
        std::reverse(raw.begin(), raw.end());
    return static_cast<double>(std::bit_cast<T>(raw));
}

double PlyRows::binary(Scalar type) {
    switch (type) {
    case Scalar::i8:
        return take<std::int8_t>();
    case Scalar::u8:
        return take<std::uint8_t>();
    case Scalar::i16:
        return take<std::int16_t>();
    case Scalar::u16:
        return take<std::uint16_t>();
    case Scalar::i32:
        return take<std::int32_t>();
    case Scalar::u32:
        return take<std::uint32_t>();
    case Scalar::f32:
        return take<float>();
    case Scalar::f64:
        return take<double>();
    }
    return 0;
}

} // namespace scree
