// SPDX-License-Identifier: GPL-3.0-or-later
// Rules of the architecture: folders depend downwards only, each library is used in one place only,
// headers do not include libraries, a type has one definition, and no file is long.
#include "core/file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

namespace {

namespace fs = std::filesystem;

struct Include {
    std::string file;   // "render/world/world.cpp"
    std::string target; // "core/math.h" or "embree3/rtcore.h"
};

bool is_source(const fs::path& path) {
    return path.extension() == ".h" || path.extension() == ".cpp" || path.extension() == ".cl";
}

/// All source files of the checkout, as relative paths.
const std::vector<std::string>& all_sources() {
    static const std::vector<std::string> sources = [] {
        std::vector<std::string> out;
        const fs::path root(SCREE_SOURCE_DIR);
        for (const fs::directory_entry& top : fs::directory_iterator(root)) {
            const std::string name = top.path().filename();
            if (!top.is_directory() || name.starts_with("build") || name.starts_with("."))
                continue;
            for (const auto& entry : fs::recursive_directory_iterator(top.path()))
                if (entry.is_regular_file() && is_source(entry.path()))
                    out.push_back(fs::relative(entry.path(), root).string());
        }
        std::sort(out.begin(), out.end());
        return out;
    }();
    return sources;
}

std::string text_of(const std::string& file) {
    return scree::read_file((fs::path(SCREE_SOURCE_DIR) / file).string());
}

const std::vector<Include>& all_includes() {
    static const std::vector<Include> includes = [] {
        static const std::regex line(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])",
                                     std::regex::multiline);
        std::vector<Include> out;
        for (const std::string& file : all_sources()) {
            const std::string text = text_of(file);
            for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
                out.push_back({file, (*it)[1]});
        }
        return out;
    }();
    return includes;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
}

/// The folders that each folder may include besides itself. A name that ends in / stands for all
/// folders below it.
using Rules = std::map<std::string, std::vector<std::string>>;

const std::vector<std::string> model_and_below{"core", "geometry/", "model"};

std::vector<std::string> and_also(std::vector<std::string> folders,
                                  const std::vector<std::string>& more) {
    folders.insert(folders.end(), more.begin(), more.end());
    return folders;
}

Rules house_rules() {
    const std::vector<std::string> solid{"core",
                                         "geometry/",
                                         "model",
                                         "procedurals",
                                         "procedurals/solid/lattice",
                                         "procedurals/solid"};
    const std::vector<std::string> solid_cells = and_also(solid, {"procedurals/solid/cells"});
    const std::vector<std::string> below_session = and_also(
        model_and_below, {"shapes", "generators", "procedurals", "render", "render/film",
                          "render/world", "formats", "analysis", "fabrication", "scenes/reader"});
    return {
        {"core", {}},
        {"geometry/plane", {"core", "geometry/mesh"}},
        {"geometry/plane/svg", {"core", "geometry/plane"}},
        {"geometry/mesh", {"core"}},
        {"geometry/figures", {"core", "geometry/plane"}},
        {"geometry/sampling", {"core", "geometry/plane", "geometry/mesh"}},
        {"geometry/bodies", {"core", "geometry/plane", "geometry/mesh", "geometry/sampling"}},
        {"geometry/rock", {"core", "geometry/mesh"}},
        {"model", {"core", "geometry/"}},
        {"shapes", {"core", "geometry/"}},
        {"shapes/curve", {"core", "geometry/", "shapes"}},
        {"shapes/mesh", {"core", "geometry/", "shapes"}},
        {"shapes/region", {"core", "geometry/", "shapes"}},
        {"shapes/field", {"core", "geometry/", "shapes"}},
        {"generators", and_also(model_and_below,
                                {"generators/layout", "generators/elements", "generators/leather",
                                 "generators/pile", "generators/rocks", "generators/fibres"})},
        {"generators/fibres", model_and_below},
        {"generators/layout", model_and_below},
        {"generators/elements", model_and_below},
        {"generators/leather", model_and_below},
        {"generators/pile", model_and_below},
        {"generators/rocks", model_and_below},
        {"procedurals", and_also(model_and_below, {"procedurals/solid/"})},
        {"procedurals/solid/lattice", {"core"}},
        {"procedurals/solid", solid},
        {"procedurals/solid/cells", solid},
        {"procedurals/solid/bark", solid_cells},
        {"procedurals/solid/breccia", solid_cells},
        {"procedurals/solid/granite", solid_cells},
        {"procedurals/solid/leather", solid_cells},
        {"procedurals/solid/marble", solid},
        {"procedurals/solid/stone", solid_cells},
        {"procedurals/solid/wood", solid},
        {"render/world", model_and_below},
        {"render/bsdf", and_also(model_and_below, {"render/world"})},
        {"render/light", model_and_below},
        {"render/film", model_and_below},
        {"render", and_also(model_and_below, {"render/"})},
        {"formats", model_and_below},
        {"analysis", model_and_below},
        {"fabrication", model_and_below},
        {"scenes/reader", model_and_below},
        {"session", below_session},
        {"app", and_also(below_session, {"session"})},
    };
}

/// Folders that may include everything.
bool is_above_the_house(const std::string& folder) {
    return folder.starts_with("tests") || folder.starts_with("bench") || folder == "cmake";
}

bool may_include(const std::vector<std::string>& allowed, const std::string& folder) {
    return std::any_of(allowed.begin(), allowed.end(), [&](const std::string& rule) {
        return rule.ends_with('/') ? folder.starts_with(rule) : folder == rule;
    });
}

/// Violations of the rules: folders without a rule, and includes of folders above or beside.
std::vector<std::string> broken(const Rules& rules, const std::vector<std::string>& files,
                                const std::vector<Include>& includes) {
    std::set<std::string> out;
    std::set<std::string> folders;
    for (const std::string& file : files) {
        folders.insert(folder_of(file));
        if (!is_above_the_house(folder_of(file)) && !rules.contains(folder_of(file)))
            out.insert(folder_of(file) + " has no rule");
    }
    for (const Include& include : includes) {
        const std::string from = folder_of(include.file);
        const std::string to = folder_of(include.target);
        if (from == to || !rules.contains(from) || !folders.contains(to))
            continue; // a header of a library, or one generated in the same folder
        if (!may_include(rules.at(from), to))
            out.insert(include.file + " includes " + include.target +
                       ", which lies above or beside it");
    }
    return {out.begin(), out.end()};
}

TEST(Architecture, FoldersDependDownwardsOnly) {
    ASSERT_GT(all_includes().size(), 1000U);
    for (const std::string& breach : broken(house_rules(), all_sources(), all_includes()))
        ADD_FAILURE() << breach;
}

TEST(Architecture, RulesSpeakOfFoldersThatExist) {
    std::set<std::string> folders;
    for (const std::string& file : all_sources())
        folders.insert(folder_of(file));
    for (const auto& [folder, allowed] : house_rules())
        EXPECT_TRUE(folders.contains(folder)) << folder;
}

TEST(Architecture, BreachesAreSeen) {
    const std::vector<std::string> files{"generators/unruly/a.cpp",
                                         "generators/pile/b.cpp",
                                         "generators/layout/c.h",
                                         "formats/d.cpp",
                                         "render/e.h",
                                         "core/f.cpp"};
    const auto breaches_of = [&](const Include& include) {
        Rules rules = house_rules();
        rules["generators/unruly"] = model_and_below;
        return broken(rules, files, {include});
    };
    EXPECT_EQ(broken(house_rules(), files, {}),
              std::vector<std::string>{"generators/unruly has no rule"});
    EXPECT_EQ(breaches_of({"generators/pile/b.cpp", "generators/layout/c.h"}).size(), 1U);
    EXPECT_EQ(breaches_of({"formats/d.cpp", "render/e.h"}).size(), 1U);
    EXPECT_EQ(breaches_of({"core/f.cpp", "render/e.h"}).size(), 1U);
    EXPECT_EQ(breaches_of({"render/e.h", "core/f.cpp"}).size(), 0U);
}

struct Door {
    const char* library;
    const char* includes;            // pattern of its include directives
    std::vector<std::string> opened; // prefixes of the paths of files that may use it
};

const std::vector<Door>& doors() {
    static const std::vector<Door> table{
        {"Embree", "^embree[34]/", {"render/world/"}},
        {"OpenCL", "^CL/", {"core/device"}},
        {"CGAL",
         "^CGAL/",
         {"geometry/mesh/medial_balls.cpp", "geometry/plane/fill.cpp", "geometry/plane/offset.cpp",
          "geometry/plane/power_diagram.cpp", "geometry/plane/triangulate.cpp",
          "geometry/plane/triangulate_face.cpp", "tests/exact/"}},
        {"OpenImageIO", "^OpenImageIO/", {"core/image"}},
        {"zlib", "^zlib", {"core/image_tags.cpp"}},
        {"OpenEXR", "^(OpenEXR/)?Imf", {"core/image"}},
        {"OpenColorIO", "^OpenColorIO/", {"render/film/color"}},
        {"pugixml", "^pugixml", {"geometry/plane/svg/svg_tree.cpp", "core/drawing.cpp"}},
        {"librsvg", "^librsvg/", {"core/drawing_raster.cpp"}},
        {"OpenVDB", "^openvdb/", {"formats/write_vdb.cpp", "tests/unit/texture_test.cpp"}},
        {"lib3mf",
         "^(Model|Common)/.*NMR_",
         {"formats/write_3mf.cpp", "tests/unit/fabrication_test.cpp"}},
        {"Lua", "^(lua|lauxlib|lualib)\\.h(pp)?$", {"scenes/reader/"}},
        {"nlohmann-json", "^nlohmann/", {"formats/", "scenes/reader/", "session/", "tests/"}},
        {"CLI11", "^CLI/", {"app/"}},
        {"oneTBB", "^(tbb|oneapi)/", {"core/parallel.h"}},
        {"Highway",
         "^hwy/",
         {"procedurals/solid/lattice/lattice_vector.cpp",
          "procedurals/solid/lattice/levels_vector.cpp",
          "procedurals/solid/lattice/path_vector.cpp", "procedurals/solid/lattice/quads_vector.cpp",
          "procedurals/solid/marble/marble_vector.cpp",
          "procedurals/solid/marble/stripes_vector.cpp", "render/film/denoise_vector.cpp"}},
        {"Random123", "^Random123/", {"core/random.h", "tests/unit/core_test.cpp"}},
    };
    return table;
}

bool starts_with_any(const std::string& text, const std::vector<std::string>& prefixes) {
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](const std::string& prefix) { return text.starts_with(prefix); });
}

TEST(Architecture, EachLibraryHasOneDoor) {
    for (const Door& door : doors()) {
        const std::regex pattern(door.includes);
        bool used = false;
        for (const Include& include : all_includes()) {
            if (!std::regex_search(include.target, pattern))
                continue;
            used = true;
            EXPECT_TRUE(starts_with_any(include.file, door.opened))
                << include.file << " includes " << include.target << "; " << door.library
                << " may only be used by " << door.opened.front();
        }
        EXPECT_TRUE(used) << door.library << " is included nowhere: is its pattern right?";
    }
}

/// The types that a header defines, with its namespace: "scree::rocks::BoxGrid".
std::vector<std::string> types_of(const std::string& text) {
    static const std::regex space("^namespace ([a-z_:]+) \\{", std::regex::multiline);
    static const std::regex type(
        "^(?:struct|class|enum class) (?:alignas\\([^)]*\\) )?([A-Za-z0-9_:]+)[^;\\n]*\\{",
        std::regex::multiline);
    std::smatch in;
    const std::string prefix = std::regex_search(text, in, space) ? in[1].str() + "::" : "";
    std::vector<std::string> out;
    for (std::sregex_iterator it(text.begin(), text.end(), type), end; it != end; ++it)
        out.push_back(prefix + (*it)[1].str());
    return out;
}

// A second type of the same name in the same namespace is undefined behaviour that links.
TEST(Architecture, TypesAreDefinedOnce) {
    EXPECT_EQ(types_of("namespace scree::rocks {\n\nstruct A;\nclass B final : A {\n};\n}"),
              std::vector<std::string>{"scree::rocks::B"});
    std::map<std::string, std::string> defined_in;
    for (const std::string& file : all_sources()) {
        if (!file.ends_with(".h"))
            continue;
        for (const std::string& type : types_of(text_of(file))) {
            const auto [first, is_new] = defined_in.try_emplace(type, file);
            EXPECT_TRUE(is_new) << type << " is defined in " << first->second << " and " << file;
        }
    }
    EXPECT_GT(defined_in.size(), 300U);
}

TEST(Architecture, FilesHaveAtMost400Lines) {
    for (const std::string& file : all_sources()) {
        const std::string text = text_of(file);
        EXPECT_LE(std::ranges::count(text, '\n'), 400) << file;
    }
}

TEST(Architecture, HeadersShowNoLibraryButImath) {
    const std::set<std::string> exceptions{"core/parallel.h", "core/random.h",
                                           "render/world/embree_adapter.h"};
    for (const Include& include : all_includes()) {
        if (!include.file.ends_with(".h") || include.file.ends_with("-inl.h") ||
            exceptions.contains(include.file) || is_above_the_house(folder_of(include.file)))
            continue;
        for (const Door& door : doors())
            EXPECT_FALSE(std::regex_search(include.target, std::regex(door.includes)))
                << include.file << " is a header and includes " << include.target;
    }
}

} // namespace
