// SPDX-License-Identifier: GPL-3.0-or-later
// PLY (Turk 1994): polygons and strips of triangles. What else the header declares is skipped and
// named.
#include "core/text.h"
#include "formats/ply_rows.h"
#include "formats/read_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree {

namespace {

using Element = PlyHeader::Element;
using Property = PlyHeader::Property;

constexpr std::size_t unread = ~std::size_t{0};

// What is kept of a vertex: position, normal, UV.
std::size_t vertex_slot(const Property& property) {
    static const std::pair<const char*, std::size_t> slots[] = {
        {"x", 0},         {"y", 1},         {"z", 2},         {"nx", 3},       {"ny", 4},
        {"nz", 5},        {"u", 6},         {"v", 7},         {"s", 6},        {"t", 7},
        {"texture_u", 6}, {"texture_v", 7}, {"texture_s", 6}, {"texture_t", 7}};
    for (const auto& [known, slot] : slots)
        if (property.name == known && !property.count)
            return slot;
    return unread;
}

bool is_corner_list(const Property& property) {
    return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool is_strips(const Element& element) {
    return element.name == "tristrips" || element.name == "tristrip";
}

class Reader {
  public:
    explicit Reader(const PlyHeader& header) : header_(header), rows_(header) {}

    FileMesh read() {
        check_header();
        for (const Element& element : header_.elements) {
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face" || is_strips(element))
                read_faces(element);
            else
                skip(element);
        }
        rows_.finish();
        add_triangles();
        if (!unread_.empty() && mesh_.triangles.empty())
            throw Error(fmt::format("it has no triangles; not read: {}", fmt::join(unread_, ", ")));
        if (!unread_.empty())
            mesh_.warnings.push_back(fmt::format("not read: {}", fmt::join(unread_, ", ")));
        return std::move(mesh_);
    }

  private:
    struct Place {
        const Element* element = nullptr;
        std::size_t row = 0; // or its line
    };

    struct Face {
        std::size_t first = 0; // of its corners in corners_
        std::size_t count = 0;
        Place place;
    };

    std::string in_words(const Place& place) const {
        return rows_.place_in_words(*place.element, place.row);
    }

    void check_header() const {
        std::size_t vertices = 0;
        for (const Element& element : header_.elements) {
            const bool lists = std::ranges::any_of(element.properties, is_corner_list);
            const bool is_face = element.name == "face" || is_strips(element);
            vertices += element.name == "vertex" ? 1 : 0;
            if (is_face && !lists && element.count > 0)
                throw Error(fmt::format("its element {} has no list vertex_indices or vertex_index",
                                        in_quotes(element.name)));
            if (!is_face && lists && element.count > 0)
                throw Error(fmt::format("its element {} has a list of vertices that is not read; "
                                        "expected face or tristrips",
                                        in_quotes(element.name)));
        }
        if (vertices > 1)
            throw Error("its header has several elements \"vertex\"; expected one");
    }

    void read_vertices(const Element& element) {
        std::array<bool, 8> has{};
        std::vector<std::size_t> slots;
        for (const Property& property : element.properties) {
            slots.push_back(vertex_slot(property));
            if (slots.back() != unread)
                has[slots.back()] = true;
        }
        if (!has[0] || !has[1] || !has[2])
            throw Error("its vertices have no x, y, z");
        const bool normals = has[3] && has[4] && has[5];
        const bool uvs = has[6] && has[7];
        for (std::size_t p = 0; p < slots.size(); ++p)
            if (slots[p] == unread || (slots[p] >= 6 ? !uvs : slots[p] >= 3 && !normals))
                note_unread(element, element.properties[p]);
        for (std::size_t row = 0; row < element.count; ++row) {
            rows_.next(element, row);
            std::array<double, 8> value{};
            for (std::size_t p = 0; p < slots.size(); ++p)
                if (slots[p] != unread)
                    value[slots[p]] = rows_.values(p).front();
            mesh_.positions.emplace_back(value[0], value[1], value[2]);
            if (normals)
                mesh_.normals.emplace_back(Imath::V3d(value[3], value[4], value[5]));
            if (uvs)
                mesh_.uvs.emplace_back(Vec2(value[6], value[7]));
        }
    }

    void read_faces(const Element& element) {
        std::size_t list = unread;
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            if (is_corner_list(element.properties[p]) && list == unread)
                list = p;
            else
                note_unread(element, element.properties[p]);
        }
        for (std::size_t row = 0; row < element.count; ++row) {
            rows_.next(element, row);
            const Place place{&element, rows_.place(row)};
            if (is_strips(element))
                add_strips(rows_.values(list), place);
            else if (rows_.values(list).size() < 3)
                throw Error(fmt::format("{}: a face has {} corners; expected at least 3",
                                        in_words(place), rows_.values(list).size()));
            else
                add_face(rows_.values(list), place);
        }
    }

    // Strips parted by -1. Every corner after the second makes a triangle with the two before it;
    // every second one turns the other way round.
    void add_strips(std::span<const double> strips, const Place& place) {
        std::size_t first = 0;
        for (std::size_t i = 0; i < strips.size(); ++i) {
            if (strips[i] == -1) {
                first = i + 1;
                continue;
            }
            if (i < first + 2)
                continue;
            const bool even = (i - first) % 2 == 0;
            const std::array<double, 3> triangle{strips[even ? i - 2 : i - 1],
                                                 strips[even ? i - 1 : i - 2], strips[i]};
            // A corner is repeated to turn the strip or to go to another place.
            if (triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
                triangle[2] != triangle[0])
                add_face(triangle, place);
        }
    }

    // Vertices may follow later in the file, so that indices are checked at its end.
    void add_face(std::span<const double> corners, const Place& place) {
        faces_.push_back({corners_.size(), corners.size(), place});
        corners_.insert(corners_.end(), corners.begin(), corners.end());
    }

    void add_triangles() {
        std::vector<Place> crossing;
        std::vector<std::uint32_t> vertices;
        for (const Face& face : faces_) {
            vertices.clear();
            for (const double index : std::span(corners_).subspan(face.first, face.count)) {
                if (!(index >= 0 && index < double(mesh_.positions.size())) ||
                    index != std::floor(index))
                    throw Error(fmt::format("{}: a face names vertex {} of {}",
                                            in_words(face.place), index, mesh_.positions.size()));
                vertices.push_back(static_cast<std::uint32_t>(index));
            }
            if (append_face(mesh_, vertices))
                crossing.push_back(face.place);
        }
        if (!crossing.empty())
            mesh_.warnings.push_back(
                fmt::format("{} of its faces cross themselves, the first in {}", crossing.size(),
                            in_words(crossing.front())));
    }

    void skip(const Element& element) {
        if (element.count > 0)
            unread_.push_back(fmt::format("{} of element {}", counted(element.count, "row"),
                                          in_quotes(element.name)));
        for (std::size_t row = 0; row < element.count && !element.properties.empty(); ++row)
            rows_.next(element, row);
    }

    void note_unread(const Element& element, const Property& property) {
        unread_.push_back(property.name + " of " + element.name);
    }

    const PlyHeader& header_;
    PlyRows rows_;
    FileMesh mesh_;
    std::vector<Face> faces_;
    std::vector<double> corners_; // of all faces: indices of vertices
    std::vector<std::string> unread_;
};

} // namespace

FileMesh read_ply(std::string_view bytes) {
    const PlyHeader header = parse_ply_header(bytes);
    return Reader(header).read();
}

} // namespace scree
