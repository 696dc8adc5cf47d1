// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/ply_header.h"

#include "formats/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace scree {

namespace {

using Scalar = PlyHeader::Scalar;

Scalar scalar_type(std::string_view name) {
    static const std::pair<const char*, Scalar> names[] = {
        {"char", Scalar::i8},    {"int8", Scalar::i8},     {"uchar", Scalar::u8},
        {"uint8", Scalar::u8},   {"short", Scalar::i16},   {"int16", Scalar::i16},
        {"ushort", Scalar::u16}, {"uint16", Scalar::u16},  {"int", Scalar::i32},
        {"int32", Scalar::i32},  {"uint", Scalar::u32},    {"uint32", Scalar::u32},
        {"float", Scalar::f32},  {"float32", Scalar::f32}, {"double", Scalar::f64},
        {"float64", Scalar::f64}};
    for (const auto& [known, type] : names)
        if (name == known)
            return type;
    throw Error("unknown type " + in_quotes(name));
}

PlyHeader::Encoding encoding_of(std::string_view name) {
    if (name == "ascii")
        return PlyHeader::Encoding::ascii;
    if (name == "binary_little_endian")
        return PlyHeader::Encoding::little;
    if (name == "binary_big_endian")
        return PlyHeader::Encoding::big;
    throw Error("unknown format " + in_quotes(name) +
                "; expected ascii, binary_little_endian or binary_big_endian");
}

PlyHeader::Element parse_element(std::string_view words) {
    PlyHeader::Element element;
    element.name = take_word(words);
    const std::string_view count = take_word(words);
    const auto [end, code] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (count.empty() || code != std::errc() || end != count.data() + count.size())
        throw Error("an element has no valid number of rows");
    return element;
}

PlyHeader::Property parse_property(std::string_view words) {
    PlyHeader::Property property;
    std::string_view type = take_word(words);
    if (type == "list") {
        property.count = scalar_type(take_word(words));
        type = take_word(words);
    }
    property.type = scalar_type(type);
    property.name = take_word(words);
    if (property.name.empty())
        throw Error("a property has no name");
    return property;
}

class Parser {
  public:
    // Adds what a line says; false at the end of the header.
    bool add(std::string_view line) {
        const std::string_view keyword = take_word(line);
        if (keyword == "end_header")
            return false;
        if (keyword == "format") {
            header.encoding = encoding_of(take_word(line));
            has_format = true;
        } else if (keyword == "element") {
            header.elements.push_back(parse_element(line));
        } else if (keyword == "property") {
            if (header.elements.empty())
                throw Error("a property comes before the first element");
            header.elements.back().properties.push_back(parse_property(line));
        } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
            throw Error(in_quotes(keyword) + " is not expected here; expected format, comment, "
                                             "element, property or end_header");
        }
        return true;
    }

    PlyHeader header;
    bool has_format = false;
};

} // namespace

PlyHeader parse_ply_header(std::string_view bytes) {
    if (bytes.starts_with("\xef\xbb\xbf")) // a byte order mark
        bytes.remove_prefix(3);
    TextLines lines(bytes);
    std::string_view first = lines.next() ? lines.text() : std::string_view();
    if (take_word(first) != "ply")
        throw Error("it is not a PLY file");
    // A binary body may begin with the byte LF, which is no part of a line end that is CR.
    const bool cr_alone = lines.text().data() + lines.text().size() < bytes.data() + bytes.size() &&
                          lines.rest().data() - (lines.text().data() + lines.text().size()) == 1 &&
                          *(lines.rest().data() - 1) == '\r';
    Parser parser;
    while (lines.next()) {
        try {
            if (parser.add(lines.text()))
                continue;
        } catch (const Error& problem) {
            throw line_error(lines.number(), problem.diagnostics().front().message);
        }
        const char* end = lines.text().data() + lines.text().size();
        if (end == bytes.data() + bytes.size())
            break; // the line is cut
        if (!parser.has_format)
            throw Error("its header names no format");
        parser.header.lines = lines.number();
        parser.header.body = lines.rest();
        if (cr_alone && *(lines.rest().data() - 1) == '\n')
            parser.header.body = {end + 1, lines.rest().size() + 1};
        return std::move(parser.header);
    }
    throw Error("its header has no end");
}

} // namespace scree
