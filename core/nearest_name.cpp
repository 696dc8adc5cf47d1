// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nearest_name.h"

#include "core/text.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace scree {

namespace {

// Words that other programs use for the same thing, in lower case and without separators.
using Group = std::array<std::string_view, 6>;
constexpr std::array<Group, 28> synonyms{{
    {"disk", "circle", "disc"},
    {"sphere", "ball", "uvsphere", "icosphere"},
    {"box", "cube", "cuboid", "block"},
    {"plane", "quad", "ground", "floor", "grid"},
    {"torus", "donut", "doughnut", "ring"},
    {"cylinder", "tube", "pipe", "rod"},
    {"rectangle", "rect", "square", "box"},
    {"color", "colour", "albedo", "basecolor", "diffuse", "reflectance"},
    {"centre", "center", "middle", "origin"},
    {"grey", "gray"},
    {"position", "translate", "translation", "location", "pos", "move"},
    {"rotation", "rotate", "angle", "orientation"},
    {"scale", "size", "scaling"},
    {"strength", "intensity", "power", "brightness", "radiance", "emission"},
    {"width", "length", "w"},
    {"depth", "length", "d"},
    {"from", "eye", "position", "origin"},
    {"at", "target", "lookat", "look"},
    {"fov", "fieldofview", "viewangle"},
    {"path", "file", "filename", "image", "texture", "map"},
    {"image", "hdri", "envmap", "environment", "path", "texture"},
    {"matte", "diffuse", "lambert", "lambertian"},
    {"metal", "conductor", "metallic"},
    {"glass", "dielectric", "transparent"},
    {"plastic", "glossy", "principled", "coated"},
    {"sky", "dome", "environment", "envmap", "ambient", "hdri"},
    {"sun", "directional", "distant"},
    {"ior", "indexofrefraction", "eta", "refraction"},
}};

std::string folded(std::string_view name) {
    std::string out = lower_case(name);
    std::erase_if(out, [](char c) { return c == '_' || c == '-' || c == ' ' || c == '.'; });
    return out;
}

bool contains(const Group& group, std::string_view word) {
    return !word.empty() && std::find(group.begin(), group.end(), word) != group.end();
}

/// Damerau-Levenshtein distance (optimal string alignment): a swap of adjacent letters counts as
/// one.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> above(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(above.begin(), above.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(above);
        above.swap(row);
    }
    return above[b.size()];
}

const std::string* same_letters(const std::string& word, std::span<const std::string> known) {
    for (const std::string& name : known)
        if (folded(name) == word)
            return &name;
    return nullptr;
}

// Groups begin with the word that Scree prefers; the first group that knows both decides.
const std::string* synonym(const std::string& word, std::span<const std::string> known) {
    for (const Group& group : synonyms)
        if (contains(group, word))
            for (const std::string_view other : group)
                for (const std::string& name : known)
                    if (!other.empty() && folded(name) == other)
                        return &name;
    return nullptr;
}

const std::string* only_beginning(const std::string& word, std::span<const std::string> known) {
    constexpr std::size_t least_letters = 3;
    const std::string* found = nullptr;
    for (const std::string& name : known)
        if (word.size() >= least_letters && folded(name).starts_with(word)) {
            if (found != nullptr)
                return nullptr;
            found = &name;
        }
    return found;
}

const std::string* misspelt(const std::string& word, std::span<const std::string> known) {
    const std::string* best = nullptr;
    std::size_t best_distance = (word.size() + 1) / 3 + 1;
    for (const std::string& name : known) {
        const std::string letters = folded(name);
        const std::size_t distance = edit_distance(word, letters);
        if (distance < best_distance && distance < std::max(word.size(), letters.size())) {
            best_distance = distance;
            best = &name;
        }
    }
    return best;
}

} // namespace

std::string nearest_name(std::string_view given, std::span<const std::string> known) {
    const std::string word = folded(given);
    for (const auto find : {same_letters, synonym, only_beginning, misspelt})
        if (const std::string* name = find(word, known))
            return *name;
    return {};
}

std::string did_you_mean(std::string_view given, std::span<const std::string> known) {
    const std::string name = nearest_name(given, known);
    return name.empty() ? std::string{} : "did you mean " + name + "?";
}

} // namespace scree
