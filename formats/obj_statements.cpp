// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ ("Advanced Visualizer manual", appendix B1): polygons with normals and texture
// coordinates. Every statement is read, or named with its line.
#include "formats/obj_statements.h"

#include "core/text.h"
#include "geometry/mesh/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <map>
#include <span>

namespace scree {

namespace {

constexpr std::size_t most_numbers = 8; // of a vertex: x, y, z, a weight and a colour
constexpr std::array<const char*, 3> index_names{"vertex", "texture coordinate", "normal"};

class Parser {
  public:
    explicit Parser(std::string_view bytes) : lines_(plain_text(bytes)) {}

    Obj parse() {
        while (lines_.next()) {
            line_ = lines_.number();
            rest_ = lines_.text();
            const std::string_view keyword = take_word(rest_);
            if (keyword.empty() || keyword.starts_with('#'))
                continue;
            try {
                statement(keyword);
            } catch (const Error& problem) {
                throw line_error(line_, problem.diagnostics().front().message);
            }
        }
        return std::move(out_);
    }

  private:
    void statement(std::string_view keyword) {
        if (keyword == "v")
            vertex();
        else if (keyword == "vt")
            texture_coordinate();
        else if (keyword == "vn")
            normal();
        else if (keyword == "f" || keyword == "fo") // an older name
            face();
        else if (keyword == "l")
            line();
        else if (keyword == "usemtl")
            use_material();
        else if (keyword == "mtllib")
            out_.libraries.emplace_back(trimmed(rest_));
        else
            other_statement(std::string(keyword));
    }

    void use_material() {
        material_ = trimmed(rest_); // one name, which may hold blanks
        material_line_ = line_;
    }

    std::uint16_t material_number() {
        const auto next = static_cast<std::uint16_t>(out_.materials.size());
        const auto known = material_numbers_.find(material_);
        if (known != material_numbers_.end())
            return known->second;
        if (out_.materials.size() == Mesh::most_parts)
            throw Error(fmt::format("it uses more than {} materials", Mesh::most_parts));
        out_.materials.push_back({std::string(material_), material_line_});
        material_numbers_.emplace(material_, next);
        return next;
    }

    // The next word of the statement, which goes on in the next line after a backslash.
    std::string_view word() {
        for (;;) {
            std::string_view word = take_word(rest_);
            if (word.starts_with('#'))
                return {}; // a comment
            std::string_view after = rest_;
            if (!word.ends_with('\\') || !take_word(after).empty())
                return word;
            word.remove_suffix(1);
            const bool more = lines_.next();
            rest_ = more ? lines_.text() : std::string_view();
            if (!word.empty() || !more)
                return word;
        }
    }

    std::span<const double> numbers(double (*read)(std::string_view), const char* what,
                                    const char* expected, std::size_t least, std::size_t most) {
        std::size_t count = 0;
        for (std::string_view next = word(); !next.empty(); next = word(), ++count) {
            const double value = read(next);
            if (count < most_numbers)
                numbers_[count] = value;
        }
        if (count < least || count > most)
            throw Error(
                fmt::format("a {} has {}; expected {}", what, counted(count, "number"), expected));
        return {numbers_.data(), count};
    }

    void vertex() {
        constexpr const char* expected = "x, y, z, perhaps with a weight or a colour";
        const auto n = numbers(finite_number_of, "vertex", expected, 3, most_numbers);
        if (n.size() == 5)
            throw Error(fmt::format("a vertex has 5 numbers; expected {}", expected));
        if (n.size() > 5)
            out_.unread["vertex colours"].add(line_);
        out_.positions.emplace_back(n[0], n[1], n[2]);
    }

    void texture_coordinate() {
        const auto n = numbers(number_of, "texture coordinate", "u, v", 1, 3);
        out_.uvs.emplace_back(Vec2(n[0], n.size() > 1 ? n[1] : 0));
    }

    void normal() {
        const auto n = numbers(number_of, "normal", "x, y, z", 3, 3);
        out_.normals.emplace_back(Imath::V3d(n[0], n[1], n[2]));
    }

    void face() {
        statement_ = "face";
        const std::size_t first = out_.corners.size();
        for (std::string_view next = word(); !next.empty(); next = word())
            out_.corners.push_back(corner(next));
        const std::size_t count = out_.corners.size() - first;
        if (count < 3)
            throw Error(
                fmt::format("a face has {}; expected at least 3", counted(count, "corner")));
        out_.faces.push_back({first, count, line_, material_number()});
    }

    void line() {
        statement_ = "line";
        const std::size_t first = out_.corners.size();
        for (std::string_view next = word(); !next.empty(); next = word())
            out_.corners.push_back(corner(next));
        const std::size_t count = out_.corners.size() - first;
        if (count < 2)
            throw Error(
                fmt::format("a line has {}; expected at least 2", counted(count, "corner")));
        out_.lines.push_back({first, count, line_, 0});
    }

    // v, v/vt, v//vn or v/vt/vn; the slots after the first may be empty.
    ObjCorner corner(std::string_view word) const {
        ObjCorner out{Obj::absent, Obj::absent, Obj::absent};
        const std::array<std::size_t, 3> counts = out_.counts();
        std::string_view rest = word;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string_view slot = rest.substr(0, rest.find('/'));
            if (k == 0 || !slot.empty())
                out[k] = index(slot, word, counts[k], index_names[k]);
            if (slot.size() == rest.size())
                return out;
            rest.remove_prefix(slot.size() + 1);
        }
        throw Error(in_quotes(word) +
                    " is not a corner; expected vertex/texture coordinate/normal");
    }

    // From a 1-based index, or one that counts backwards from the last. Indices of what follows
    // later in the file are valid.
    std::int32_t index(std::string_view slot, std::string_view word, std::size_t count,
                       const char* what) const {
        std::int64_t value = 0;
        const auto [end, code] = std::from_chars(slot.data(), slot.data() + slot.size(), value);
        if (code != std::errc() || end != slot.data() + slot.size())
            throw Error(fmt::format("{} is not a corner of a {}; expected whole numbers{}",
                                    in_quotes(word), statement_,
                                    word.find(',') == word.npos ? "" : " without commas"));
        if (value == 0)
            throw Error(fmt::format("a {} names {} 0; the first is 1", statement_, what));
        const std::int64_t index = value > 0 ? value - 1 : std::int64_t(count) + value;
        if (index < 0 || index >= std::numeric_limits<std::int32_t>::max())
            throw Error(fmt::format("a {} names {} {} of {}", statement_, what, value, count));
        return static_cast<std::int32_t>(index);
    }

    // Statements that hold no polygons.
    void other_statement(const std::string& keyword) {
        static const std::map<std::string, const char*> kinds{
            {"p", "points"},      {"curv", "curves"},  {"curv2", "curves"}, {"cdc", "curves"},
            {"surf", "surfaces"}, {"bzp", "surfaces"}, {"bsp", "surfaces"}, {"cdp", "surfaces"}};
        // Names, groups, materials, levels of detail, and what belongs to curves and surfaces.
        static const std::vector<std::string> without_shape{
            "g",      "s",        "o",        "mg",   "usemap",     "maplib",   "bevel",
            "lod",    "c_interp", "d_interp", "vp",   "deg",        "bmat",     "step",
            "cstype", "parm",     "trim",     "hole", "scrv",       "sp",       "end",
            "con",    "ctech",    "stech",    "res",  "shadow_obj", "trace_obj"};
        const auto kind = kinds.find(keyword);
        const std::string what = kind == kinds.end() ? "" : kind->second;
        if (what == "surfaces")
            throw Error(fmt::format("free-form surfaces ({}) are not read; export them as polygons",
                                    keyword));
        if (keyword == "call")
            throw Error("other files (call) are not read; put everything into one file");
        if (!what.empty())
            out_.unread[what].add(line_);
        else if (std::find(without_shape.begin(), without_shape.end(), keyword) ==
                 without_shape.end())
            out_.unread["unknown statements"].add(line_);
    }

    TextLines lines_;
    std::size_t line_ = 0;           // where the statement begins
    const char* statement_ = "face"; // whose corners are read
    std::string_view rest_;
    std::array<double, most_numbers> numbers_{};
    std::string_view material_; // of the faces that follow
    std::size_t material_line_ = 0;
    std::map<std::string_view, std::uint16_t> material_numbers_;
    Obj out_;
};

// Corners may name what follows later in the file, so that they are checked at its end.
void check_indices(const Obj& obj, const std::vector<Obj::Face>& statements, const char* name) {
    const std::array<std::size_t, 3> counts = obj.counts();
    for (const Obj::Face& statement : statements)
        for (const ObjCorner& corner : obj.corners_of(statement))
            for (std::size_t k = 0; k < 3; ++k)
                if (corner[k] != Obj::absent && std::size_t(corner[k]) >= counts[k])
                    throw line_error(statement.line,
                                     fmt::format("a {} names {} {} of {}", name, index_names[k],
                                                 corner[k] + 1, counts[k]));
}

} // namespace

Obj parse_obj(std::string_view bytes) {
    Obj obj = Parser(bytes).parse();
    check_indices(obj, obj.faces, "face");
    check_indices(obj, obj.lines, "line");
    return obj;
}

} // namespace scree
