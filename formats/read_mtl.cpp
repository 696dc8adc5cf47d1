// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/read_mtl.h"

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "formats/text_lines.h"
#include "formats/uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace scree {

namespace {

constexpr std::uint64_t largest_library = std::uint64_t{64} << 20; // [bytes]

/// A material while its statements are read.
struct Draft {
    MeshMaterial material;
    double highlight = 0; // the largest part of Ks
    bool matte = false;   // its illumination model has no highlights
    bool has_roughness = false;
    bool has_dissolve = false;
};

/// The statements of one library.
class Library {
  public:
    Library(std::string_view text, std::string folder)
        : folder_(std::move(folder)), lines_(plain_text(text)) {}

    std::map<std::string, Draft> drafts;
    std::vector<std::string> not_read;

    void read() {
        while (lines_.next()) {
            std::string_view rest = lines_.text();
            const std::string_view keyword = take_word(rest);
            rest = trimmed(rest);
            if (keyword.empty() || keyword.starts_with('#'))
                continue;
            if (same_word(keyword, "newmtl")) {
                draft_ = &drafts[std::string(rest)];
                *draft_ = {};
                draft_->material = {.name = std::string(rest), .color = Color(1.0F)};
            } else if (draft_ != nullptr) {
                try {
                    statement(keyword, rest);
                } catch (const Error& problem) {
                    note(fmt::format("line {} ({})", lines_.number(),
                                     problem.diagnostics().front().message));
                }
            }
        }
    }

  private:
    void note(const std::string& what) {
        not_read.push_back(fmt::format("{} of {}", what, draft_->material.name));
    }

    void statement(std::string_view keyword, std::string_view rest) {
        statement_ = in_words(keyword, rest);
        MeshMaterial& material = draft_->material;
        const auto is = [keyword](std::string_view word) { return same_word(keyword, word); };
        if (is("Kd"))
            material.color = color(rest);
        else if (is("Ks")) {
            const Color ks = color(rest);
            draft_->highlight = std::max({ks.x, ks.y, ks.z});
            if (ks != Color(ks.x)) // highlights are white
                note("the colour of Ks");
        } else if (is("Ns"))
            shininess(number(rest));
        else if (is("Ni"))
            refraction(number(rest));
        else if (is("d"))
            dissolve(rest);
        else if (is("Tr")) {
            if (!draft_->has_dissolve)
                transmission(share(number(rest)));
        } else if (is("Pr")) {
            material.roughness = share(number(rest));
            draft_->has_roughness = true;
        } else if (is("Pm")) {
            material.metallic = share(number(rest));
            material.words.metallic = statement_;
        } else if (is("illum"))
            illumination(number(rest));
        else if (is("map_Kd"))
            picture(rest);
        else
            other(keyword, rest);
    }

    /// What changes nothing is not worth a word: ambient light, and effects of strength 0.
    void other(std::string_view keyword, std::string_view rest) {
        if (same_word(keyword, "Ka"))
            return;
        const bool filter = same_word(keyword, "Tf");
        for (const char* strength : {"Ke", "Tf", "Ps", "Pc", "Pcr", "aniso", "anisor"})
            if (same_word(keyword, strength) && all_are(rest, filter ? 1 : 0))
                return;
        note(std::string(keyword));
    }

    /// The statement with its first few values, without a comment.
    static std::string in_words(std::string_view keyword, std::string_view rest) {
        std::string out(keyword);
        rest = rest.substr(0, rest.find('#'));
        std::string_view word = take_word(rest);
        for (int i = 0; i < 3 && !word.empty(); ++i, word = take_word(rest))
            out += fmt::format(" {}", word);
        return out;
    }

    static bool all_are(std::string_view rest, double value) {
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
            if (number_of(word) != value)
                return false;
        return true;
    }

    static double number(std::string_view rest) { return finite_number_of(take_word(rest)); }

    double share(double value) {
        if (value < 0 || value > 1)
            note(statement_);
        return std::clamp(value, 0.0, 1.0);
    }

    /// Three numbers, or one for grey.
    Color color(std::string_view rest) {
        Color out;
        double value = 0;
        bool beyond = false;
        for (int i = 0; i < 3; ++i) {
            if (const std::string_view word = take_word(rest); i == 0 || !word.empty())
                value = finite_number_of(word);
            beyond = beyond || value < 0 || value > 1;
            out[i] = static_cast<float>(std::clamp(value, 0.0, 1.0));
        }
        if (beyond)
            note(statement_);
        return out;
    }

    void refraction(double ior) {
        draft_->material.ior = ior;
        draft_->material.words.ior = statement_;
    }

    void transmission(double share) {
        draft_->material.transmission = share;
        draft_->material.words.transmission = statement_;
    }

    /// Phong's exponent n is about that of a microfacet distribution of alpha = sqrt(2 / (n + 2))
    /// (Walter et al. 2007), whose root is the perceptual roughness.
    void shininess(double exponent) {
        if (!draft_->has_roughness)
            draft_->material.roughness = std::pow(2 / (std::max(exponent, 0.0) + 2), 0.25);
    }

    void dissolve(std::string_view rest) {
        std::string_view word = take_word(rest);
        if (word == "-halo") {
            note("d -halo");
            word = take_word(rest);
        }
        transmission(1 - share(finite_number_of(word)));
        draft_->has_dissolve = true;
    }

    void illumination(double model) {
        draft_->matte = model < 2;
        if (model > 2)
            note(fmt::format("illum {}", model));
    }

    /// map_Kd [options] file: the name may hold blanks.
    void picture(std::string_view rest) {
        MeshPicture picture;
        Vec2 scale(1.0);
        Vec2 move(0.0);
        while (rest.starts_with('-')) {
            const std::string option(take_word(rest));
            if (option == "-s")
                scale = pair(rest, scale);
            else if (option == "-o")
                move = pair(rest, move);
            else if (option == "-clamp")
                picture.repeats = !same_word(take_word(rest), "on");
            else {
                note(fmt::format("option {} of map_Kd", option));
                skip_values(option, rest);
            }
            rest = trimmed(rest);
        }
        picture.picture_from_uv = {scale.x, 0, 0, 0, scale.y, 0, move.x, move.y, 1};
        picture.name = std::string(rest);
        try {
            picture.path = file_of_uri(picture.name, folder_);
        } catch (const Error& problem) { // told to whoever wants the picture
            picture.problem = problem.diagnostics().front().message;
        }
        draft_->material.picture = std::move(picture);
    }

    /// One to three numbers, of which the third does not matter for pictures.
    static Vec2 pair(std::string_view& rest, Vec2 out) {
        for (int i = 0; i < 3; ++i) {
            std::string_view after = rest;
            const std::string_view word = take_word(after);
            if (word.find_first_not_of("0123456789+-.eE") != std::string_view::npos || word.empty())
                break;
            if (i < 2)
                out[i] = finite_number_of(word);
            rest = after;
        }
        return out;
    }

    static void skip_values(const std::string& option, std::string_view& rest) {
        if (option == "-t") {
            pair(rest, {});
            return;
        }
        for (int i = 0; i < (option == "-mm" ? 2 : 1); ++i)
            take_word(rest);
    }

    std::string folder_;
    TextLines lines_;
    std::string statement_; // that is read: "Kd 1 0 0"
    Draft* draft_ = nullptr;
};

MeshMaterial finished(const Draft& draft) {
    MeshMaterial material = draft.material;
    material.coated = !draft.matte && draft.highlight > 0;
    if (material.ior < 1) // programs write 0 for "none"
        material.ior = 1.5;
    return material;
}

/// The text behind `mtllib`: one name with blanks, or several.
std::vector<std::string> files_of(const std::string& names, const std::string& folder) {
    try {
        return {file_of_uri(names, folder)};
    } catch (const Error&) {
        std::vector<std::string> out;
        std::string_view rest = names;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
            out.push_back(file_of_uri(std::string(word), folder));
        return out;
    }
}

std::string missing(const MaterialUse& use, const std::map<std::string, Draft>& drafts) {
    std::vector<std::string> known;
    known.reserve(drafts.size());
    for (const auto& [name, draft] : drafts)
        known.push_back(name);
    const std::string near = did_you_mean(use.name, known);
    return fmt::format("usemtl {} at line {}, which no mtllib has (taken as grey{})", use.name,
                       use.line, near.empty() ? "" : "; " + near);
}

} // namespace

MeshMaterials read_mtl(const std::vector<std::string>& libraries,
                       const std::vector<MaterialUse>& uses, const std::string& folder) {
    MeshMaterials out;
    if (libraries.empty() && !uses.empty())
        out.problem = "it names some, but no library of them (mtllib)";
    std::map<std::string, Draft> drafts;
    for (const std::string& library : libraries) {
        try {
            for (const std::string& path : files_of(library, folder)) {
                const std::string text = read_file(path, largest_library);
                Library read(text, folder);
                read.read();
                drafts.merge(read.drafts);
                out.not_read.insert(out.not_read.end(), read.not_read.begin(), read.not_read.end());
            }
        } catch (const Error& problem) {
            out.problem = problem.diagnostics().front().message;
        }
    }
    if (drafts.empty())
        return out;
    for (const MaterialUse& use : uses) {
        const auto found = drafts.find(use.name);
        if (found == drafts.end() && !use.name.empty())
            out.not_read.push_back(missing(use, drafts));
        out.list.push_back(found == drafts.end() ? MeshMaterial{} : finished(found->second));
    }
    return out;
}

} // namespace scree
