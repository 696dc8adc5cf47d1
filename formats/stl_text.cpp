// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/stl_text.h"

#include "core/text.h"
#include "formats/text_lines.h"
#include "formats/vertex_merger.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

constexpr std::size_t looked_at = 1024; // bytes: a binary file has its first triangle there

class Parser {
  public:
    Parser(std::string_view bytes, FileMesh& mesh)
        : lines_(plain_text(bytes)), mesh_(mesh), merger_(mesh) {}

    void parse() {
        bool open = false; // within a solid
        for (std::string_view next = word(); !next.empty(); next = word()) {
            if (same_word(next, "solid") || same_word(next, "endsolid")) {
                open = same_word(next, "solid");
                rest_ = {}; // its name
            } else if (same_word(next, "facet")) {
                facet();
            } else {
                unexpected(next, "facet, solid or endsolid");
            }
        }
        if (open)
            mesh_.warnings.emplace_back("it ends without \"endsolid\": is it complete?");
        if (crossing_.count() > 0)
            mesh_.warnings.push_back(
                fmt::format("{} of its facets cross themselves, the first in line {}",
                            crossing_.count(), crossing_.first()));
    }

  private:
    // facet normal x y z, outer loop, at least three times vertex x y z, endloop, endfacet. The
    // normal says nothing that the order of the corners does not.
    void facet() {
        const std::size_t line = lines_.number();
        std::string_view next = word();
        if (same_word(next, "normal")) {
            numbers(next, number_of);
            next = word();
        }
        if (!same_word(next, "outer") || !same_word(next = word(), "loop"))
            unexpected(next, "outer loop");
        corners_.clear();
        for (next = word(); same_word(next, "vertex"); next = word())
            corners_.push_back(merger_.add(numbers(next, finite_number_of)));
        if (!same_word(next, "endloop"))
            unexpected(next, "vertex or endloop");
        if (!same_word(next = word(), "endfacet"))
            unexpected(next, "endfacet");
        if (corners_.size() < 3)
            throw line_error(line, fmt::format("a facet has {}; expected at least 3",
                                               counted(corners_.size(), "corner")));
        if (append_face(mesh_, corners_))
            crossing_.add(line);
    }

    // The next word of the file; "" at its end.
    std::string_view word() {
        for (;;) {
            if (const std::string_view word = take_word(rest_); !word.empty())
                return word;
            if (!lines_.next())
                return {};
            rest_ = lines_.text();
        }
    }

    // The three numbers behind a keyword. A program may break the line between them, but when they
    // end before a word of the next line, this one is at fault.
    Imath::V3d numbers(std::string_view keyword, double (*number)(std::string_view)) {
        const std::size_t line = lines_.number();
        Imath::V3d out(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string_view next = word();
            if (next.empty())
                unexpected(next, "a number");
            try {
                out[int(k)] = number(next);
            } catch (const Error& problem) {
                throw lines_.number() == line
                    ? line_error(line, problem.diagnostics().front().message)
                    : line_error(line, fmt::format("{} has {}; expected 3", keyword,
                                                   counted(k, "number")));
            }
        }
        return out;
    }

    [[noreturn]] void unexpected(std::string_view word, const std::string& expected) const {
        if (word.empty())
            throw Error("it ends too early, within a facet");
        throw line_error(lines_.number(), fmt::format("{} is not expected here; expected {}",
                                                      in_quotes(word), expected));
    }

    TextLines lines_;
    std::string_view rest_;
    FileMesh& mesh_;
    VertexMerger merger_;
    std::vector<std::uint32_t> corners_;
    Tally crossing_;
};

} // namespace

bool is_stl_text(std::string_view bytes) {
    const std::string_view start = plain_text(bytes.substr(0, looked_at));
    const auto control = [](char c) { return c >= 0 && c < ' ' && (c < '\t' || c > '\r'); };
    if (start.empty() || std::any_of(start.begin(), start.end(), control))
        return false;
    std::string_view rest =
        start.substr(std::min(start.find_first_not_of("\r\n\t "), start.size()));
    const std::string_view first = take_word(rest);
    return same_word(first, "solid") || same_word(first, "facet") ||
           std::none_of(start.begin(), start.end(), [](char c) { return c < 0; });
}

void read_stl_text(std::string_view bytes, FileMesh& mesh) { Parser(bytes, mesh).parse(); }

} // namespace scree
