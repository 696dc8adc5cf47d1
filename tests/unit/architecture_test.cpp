// SPDX-License-Identifier: GPL-3.0-or-later
// The house's two rules: folders depend downwards only, and each library has one door.
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
    std::string file;   // "render/world.cpp"
    std::string target; // "core/mesh.h" or "embree3/rtcore.h"
};

bool is_source(const fs::path& path) {
    return path.extension() == ".h" || path.extension() == ".cpp" || path.extension() == ".cl";
}

std::vector<Include> includes_of(const fs::path& root) {
    static const std::regex line(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])",
                                 std::regex::multiline);
    std::vector<Include> out;
    for (const char* folder : {"core", "analysis", "fabrication", "generators", "procedurals",
                               "render", "formats", "scenes", "app", "bench", "tests"}) {
        if (!fs::exists(root / folder))
            continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (!entry.is_regular_file() || !is_source(entry.path()))
                continue;
            const std::string text = scree::read_file(entry.path().string());
            const std::string name = fs::relative(entry.path(), root).string();
            for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
                out.push_back({name, (*it)[1]});
        }
    }
    return out;
}

bool starts_with_any(const std::string& text, const std::vector<std::string>& prefixes) {
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](const std::string& prefix) { return text.starts_with(prefix); });
}

const std::vector<Include>& all_includes() {
    static const std::vector<Include> includes = includes_of(SCREE_SOURCE_DIR);
    return includes;
}

std::string folder_of(const std::string& path) {
    if (path.starts_with("scenes/reader/"))
        return "scenes/reader";
    return path.substr(0, path.find('/'));
}

TEST(Architecture, FoldersDependDownwardsOnly) {
    const std::map<std::string, std::set<std::string>> allowed{
        {"core", {}},
        {"analysis", {"core"}},
        {"fabrication", {"core"}},
        {"generators", {"core"}},
        {"procedurals", {"core"}},
        {"render", {"core"}},
        {"formats", {"core"}},
        {"scenes/reader", {"core", "generators", "procedurals", "render", "formats"}},
        {"app",
         {"core", "analysis", "fabrication", "generators", "procedurals", "render", "formats",
          "scenes/reader"}},
    };
    ASSERT_GT(all_includes().size(), 100U);
    for (const Include& include : all_includes()) {
        const std::string from = folder_of(include.file);
        const std::string to = folder_of(include.target);
        if (!allowed.contains(from) || !allowed.contains(to) || from == to)
            continue;
        EXPECT_TRUE(allowed.at(from).contains(to))
            << include.file << " includes " << include.target << ", which lies above or beside it";
    }
}

struct Door {
    const char* library;
    const char* includes;            // what its includes look like
    std::vector<std::string> opened; // by files whose path starts so
};

const std::vector<Door>& doors() {
    static const std::vector<Door> table{
        {"Embree", "^embree[34]/", {"render/world", "render/embree"}},
        {"OpenCL", "^CL/", {"core/device"}},
        {"CGAL",
         "^CGAL/",
         {"generators/pile/medial_balls.cpp", "generators/sampling/fill.cpp",
          "generators/sampling/offset.cpp", "generators/sampling/triangulate.cpp",
          "formats/read_stl.cpp", "tests/exact/"}},
        {"OpenImageIO", "^OpenImageIO/", {"core/image"}},
        {"OpenEXR", "^(OpenEXR/)?Imf", {"core/image"}},
        {"OpenColorIO", "^OpenColorIO/", {"render/color"}},
        {"pugixml", "^pugixml", {"generators/svg/svg_document.cpp", "core/drawing.cpp"}},
        {"librsvg", "^librsvg/", {"core/drawing_raster.cpp"}},
        {"OpenVDB", "^openvdb/", {"formats/write_vdb.cpp", "tests/unit/texture_test.cpp"}},
        {"lib3mf",
         "^(Model|Common)/.*NMR_",
         {"formats/write_3mf.cpp", "tests/unit/fabrication_test.cpp"}},
        {"Lua", "^(lua|lauxlib|lualib)\\.h(pp)?$", {"scenes/reader/"}},
        {"tinyobjloader", "^tiny_obj_loader", {"formats/read_obj.cpp"}},
        {"tinygltf", "^tiny_gltf", {"formats/read_gltf.cpp"}},
        {"nlohmann-json", "^nlohmann/", {"formats/", "scenes/reader/", "app/", "tests/"}},
        {"CLI11", "^CLI/", {"app/"}},
        {"oneTBB", "^(tbb|oneapi)/", {"core/parallel.h"}},
        {"Highway",
         "^hwy/",
         {"procedurals/solid/lattice_vector.cpp", "procedurals/solid/levels_vector.cpp",
          "procedurals/solid/marble_vector.cpp", "procedurals/solid/path_vector.cpp",
          "procedurals/solid/quads_vector.cpp", "procedurals/solid/stripes_vector.cpp"}},
        {"Random123", "^Random123/", {"core/random.h", "tests/unit/core_test.cpp"}},
    };
    return table;
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

TEST(Architecture, HeadersShowNoLibraryButImath) {
    const std::set<std::string> exceptions{"core/parallel.h", "core/random.h"};
    for (const Include& include : all_includes()) {
        if (!include.file.ends_with(".h") || exceptions.contains(include.file))
            continue;
        if (include.file.starts_with("tests/") || include.file.starts_with("bench/"))
            continue;
        for (const Door& door : doors()) {
            const bool inner = include.file.find("_internal") != std::string::npos ||
                               include.file.starts_with("render/embree");
            EXPECT_TRUE(inner || !std::regex_search(include.target, std::regex(door.includes)))
                << include.file << " is a header and includes " << include.target;
        }
    }
}

} // namespace
