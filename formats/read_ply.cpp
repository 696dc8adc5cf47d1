// SPDX-License-Identifier: GPL-3.0-or-later
// PLY (Turk 1994): ASCII and both binary byte orders. Counts are checked against the size of the
// file before memory is allocated for them.
#include "formats/read_mesh.h"

#include "core/error.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>

namespace scree {

namespace {

enum class Encoding { ascii, little, big };
enum class Scalar { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
    std::string name;
    Scalar type = Scalar::f32;
    std::optional<Scalar> count; // of a list
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements;
    std::size_t size = 0; // [bytes]
};

Scalar scalar_type(const std::string& name) {
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
    throw Error("its header has the unknown type " + name);
}

Property parse_property(std::istringstream& words) {
    Property property;
    std::string type;
    words >> type;
    if (type == "list") {
        std::string count;
        words >> count >> type;
        property.count = scalar_type(count);
    }
    property.type = scalar_type(type);
    if (!(words >> property.name))
        throw Error("its header has a property without a name");
    return property;
}

Header parse_header(std::string_view bytes) {
    Header header;
    bool has_format = false;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = bytes.find('\n', at);
        if (end == std::string_view::npos)
            break;
        std::istringstream words{std::string(bytes.substr(at, end - at))};
        at = end + 1;
        std::string keyword;
        words >> keyword;
        if (keyword == "format") {
            std::string name;
            words >> name;
            has_format = true;
            if (name == "ascii")
                header.encoding = Encoding::ascii;
            else if (name == "binary_little_endian")
                header.encoding = Encoding::little;
            else if (name == "binary_big_endian")
                header.encoding = Encoding::big;
            else
                throw Error("its header has the unknown format " + name);
        } else if (keyword == "element") {
            Element element;
            if (!(words >> element.name >> element.count))
                throw Error("its header has an element without a count");
            header.elements.push_back(std::move(element));
        } else if (keyword == "property") {
            if (header.elements.empty())
                throw Error("its header has a property of nothing");
            header.elements.back().properties.push_back(parse_property(words));
        } else if (keyword == "end_header") {
            if (!has_format)
                throw Error("its header names no format");
            header.size = at;
            return header;
        }
    }
    throw Error("its header has no end");
}

// Reads numbers one after the other in any of the three encodings.
class Reader {
  public:
    Reader(std::string_view bytes, Encoding encoding) : rest_(bytes), encoding_(encoding) {}

    double number(Scalar type) { return encoding_ == Encoding::ascii ? word() : binary(type); }

    std::size_t remaining() const { return rest_.size(); }

  private:
    [[noreturn]] static void too_short() { throw Error("it ends too early"); }

    double word() {
        constexpr const char* white = " \t\r\n\v\f";
        const std::size_t start = rest_.find_first_not_of(white);
        if (start == std::string_view::npos)
            too_short();
        rest_.remove_prefix(start);
        const std::string_view token = rest_.substr(0, rest_.find_first_of(white));
        double value = 0;
        const char* first = token.data() + (token.starts_with('+') ? 1 : 0);
        const auto [end, code] = std::from_chars(first, token.data() + token.size(), value);
        if (code != std::errc() || end != token.data() + token.size())
            throw Error("\"" + std::string(token.substr(0, 20)) + "\" is not a number");
        rest_.remove_prefix(token.size());
        return value;
    }

    template <class T>
    double take() {
        if (rest_.size() < sizeof(T))
            too_short();
        std::array<char, sizeof(T)> raw{};
        std::memcpy(raw.data(), rest_.data(), sizeof(T));
        rest_.remove_prefix(sizeof(T));
        constexpr bool little = std::endian::native == std::endian::little;
        if (little != (encoding_ == Encoding::little))
            std::reverse(raw.begin(), raw.end());
        return static_cast<double>(std::bit_cast<T>(raw));
    }

    double binary(Scalar type) {
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

    std::string_view rest_;
    Encoding encoding_;
};

// The index of a vertex property among those that are kept; -1: ignored.
int vertex_slot(const std::string& name) {
    static const std::pair<const char*, int> slots[] = {
        {"x", 0}, {"y", 1}, {"z", 2}, {"nx", 3}, {"ny", 4},        {"nz", 5},
        {"u", 6}, {"v", 7}, {"s", 6}, {"t", 7},  {"texture_u", 6}, {"texture_v", 7}};
    for (const auto& [known, slot] : slots)
        if (name == known)
            return slot;
    return -1;
}

std::size_t list_length(Reader& reader, Scalar type) {
    const double count = reader.number(type);
    // Every item takes at least one byte in all encodings.
    if (!(count >= 0 && count == std::floor(count)) || count > double(reader.remaining()))
        throw Error("it has a list of an impossible length");
    return static_cast<std::size_t>(count);
}

void read_vertices(Reader& reader, const Element& element, FileMesh& mesh) {
    std::array<bool, 8> has{};
    for (const Property& property : element.properties)
        if (const int slot = vertex_slot(property.name); slot >= 0 && !property.count)
            has[std::size_t(slot)] = true;
    if (!has[0] || !has[1] || !has[2])
        throw Error("its vertices have no x, y, z");
    for (std::size_t i = 0; i < element.count; ++i) {
        std::array<double, 8> value{};
        for (const Property& property : element.properties) {
            const std::size_t count = property.count ? list_length(reader, *property.count) : 1;
            for (std::size_t k = 0; k < count; ++k) {
                const double number = reader.number(property.type);
                if (const int slot = vertex_slot(property.name); slot >= 0 && !property.count)
                    value[std::size_t(slot)] = number;
            }
        }
        mesh.positions.emplace_back(value[0], value[1], value[2]);
        if (has[3] && has[4] && has[5])
            mesh.normals.emplace_back(Imath::V3d(value[3], value[4], value[5]));
        if (has[6] && has[7])
            mesh.uvs.emplace_back(Vec2(value[6], value[7]));
    }
}

void read_faces(Reader& reader, const Element& element, FileMesh& mesh) {
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < element.count; ++i)
        for (const Property& property : element.properties) {
            const bool is_face = property.count && (property.name == "vertex_indices" ||
                                                    property.name == "vertex_index");
            const std::size_t count = property.count ? list_length(reader, *property.count) : 1;
            corners.clear();
            for (std::size_t k = 0; k < count; ++k) {
                const double index = reader.number(property.type);
                if (!is_face)
                    continue;
                if (!(index >= 0 && index < 4294967295.0))
                    throw Error("face " + std::to_string(i) + " has an index out of range");
                corners.push_back(static_cast<std::uint32_t>(index));
            }
            for (std::size_t k = 2; k < corners.size(); ++k)
                mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
        }
}

void skip(Reader& reader, const Element& element) {
    if (element.properties.empty())
        return;
    for (std::size_t i = 0; i < element.count; ++i)
        for (const Property& property : element.properties) {
            const std::size_t count = property.count ? list_length(reader, *property.count) : 1;
            for (std::size_t k = 0; k < count; ++k)
                reader.number(property.type);
        }
}

} // namespace

FileMesh read_ply(std::string_view bytes) {
    if (!bytes.starts_with("ply"))
        throw Error("it is not a PLY file");
    const Header header = parse_header(bytes);
    Reader reader(bytes.substr(header.size), header.encoding);
    FileMesh mesh;
    for (const Element& element : header.elements) {
        if (element.name == "vertex")
            read_vertices(reader, element, mesh);
        else if (element.name == "face" && !element.properties.empty())
            read_faces(reader, element, mesh);
        else
            skip(reader, element);
    }
    return mesh;
}

} // namespace scree
