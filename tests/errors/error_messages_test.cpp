// SPDX-License-Identifier: GPL-3.0-or-later
// The exact error messages of invalid scenes: cases/NAME.lua (or .json) must fail, or warn, with
// the text of cases/NAME.txt. A script's first lines may contain `--! set name=value`, `--! seconds
// 0.3` or
// `--! memory 32` (MiB). SCREE_UPDATE_ERRORS=1 updates the .txt files.
#include "core/file.h"
#include "scenes/reader/scene.h"
#include "scenes/reader/script.h"
#include "session/catalog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace scree {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(SCREE_SOURCE_DIR) / "tests/errors/cases";

std::vector<std::string> case_names() {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".lua" || entry.path().extension() == ".json")
            names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

ScriptOptions options_of(const std::string& script) {
    ScriptOptions options;
    options.limits.seconds = 5;
    options.print = [](std::string_view) {};
    std::istringstream lines(script);
    std::string line;
    while (std::getline(lines, line) && line.starts_with("--! ")) {
        std::istringstream words(line.substr(4));
        std::string what;
        std::string value;
        words >> what >> value;
        if (what == "set")
            options.overrides[value.substr(0, value.find('='))] = value.substr(value.find('=') + 1);
        else if (what == "seconds")
            options.limits.seconds = std::stod(value);
        else if (what == "memory")
            options.limits.memory = std::stoul(value) << 20;
    }
    return options;
}

// `scree check` does not bake. What only the work itself can find is listed here, with the reason.
const std::vector<std::string> found_by_work{
    "elements_too_many.lua",   // by counting
    "fibres_thin_target.lua",  // by measuring
    "layout_nothing_fits.lua", // by trying
    "pile_too_many.lua",       // by counting
};

struct Found {
    std::string text;     // of the error of a scene, or of its warnings
    bool by_work = false; // the scene was refused by a bake only
};

Found found_in(const std::string& name) {
    Found found;
    try {
        static const Catalog catalog = standard_catalog();
        ScriptOptions options = options_of(read_file(name));
        options.families = catalog.constructor_families();
        const DescriptionNode root =
            name.ends_with(".json") ? read_description(name, options.overrides, options.families)
                                    : run_script(name, options);
        const SceneDraft draft = resolve(root, name, catalog);
        found.by_work = true;
        for (const auto& item : draft.items)
            item->bake({}, 0);
        found.by_work = false;
        for (const Diagnostic& warning : *draft.warnings)
            found.text += "warning: " + warning.text() + "\n";
        if (found.text.empty())
            found.text = "no error\n";
    } catch (const Error& error) {
        found.text = std::string(error.what()) + "\n";
    }
    const std::string here = fs::current_path().string() + "/";
    for (std::size_t at = 0; (at = found.text.find(here)) != std::string::npos;)
        found.text.erase(at, here.size());
    return found;
}

TEST(ErrorMessages, OfTheWorkAreAmongTheCases) {
    for (const std::string& name : found_by_work)
        EXPECT_TRUE(fs::exists(folder / name)) << name;
}

class ErrorMessage : public testing::TestWithParam<std::string> {};

TEST_P(ErrorMessage, IsWordForWord) {
    fs::current_path(folder); // messages show paths as given, here file names only
    const std::string expected_file = fs::path(GetParam()).replace_extension(".txt").string();
    const Found found = found_in(GetParam());
    if (std::getenv("SCREE_UPDATE_ERRORS") != nullptr)
        write_file(expected_file, found.text);
    EXPECT_EQ(found.text, read_file(expected_file));
    EXPECT_EQ(found.by_work, std::ranges::count(found_by_work, GetParam()) > 0)
        << "whether `scree check` finds it";
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ErrorMessage, testing::ValuesIn(case_names()), [](const auto& tested) {
        std::string name = tested.param;
        std::replace_if(
            name.begin(), name.end(),
            [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
        return name;
    });

} // namespace
} // namespace scree
