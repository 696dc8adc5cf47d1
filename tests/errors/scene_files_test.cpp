// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes that come with the project.
#include "scenes/reader/scene.h"
#include "scenes/reader/script.h"
#include "session/catalog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace scree {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(SCREE_SOURCE_DIR) / "scenes"))
        if (entry.path().extension() == ".lua")
            names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

class SceneFile : public testing::TestWithParam<std::string> {};

TEST_P(SceneFile, HasNoMistakesAndCanBeRendered) {
    const std::string path =
        (fs::path(SCREE_SOURCE_DIR) / "scenes" / (GetParam() + ".lua")).string();
    static const Catalog catalog = standard_catalog();
    const SceneDraft draft =
        resolve(read_description(path, {}, catalog.constructor_families()), path, catalog);
    EXPECT_TRUE(draft.scene.camera);
    EXPECT_FALSE(draft.scene.lights.empty());
    EXPECT_FALSE(draft.items.empty());
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneFile, testing::ValuesIn(scene_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace scree
