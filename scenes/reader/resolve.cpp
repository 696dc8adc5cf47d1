// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"
#include "model/table.h"
#include "scenes/reader/maker.h"
#include "scenes/reader/scene.h"
#include "scenes/reader/words.h"

namespace scree {

SceneDraft resolve(const DescriptionNode& root, const std::string& path, const Catalog& catalog) {
    if (root->kind != "scene")
        throw Error(Diagnostic{root->where,
                               {},
                               "expected scene { ... }, got " + in_words(*root),
                               "a script ends with: return scene { ... }"});
    Mistakes mistakes;
    const Params params = Maker(catalog, mistakes).params(*root, "scene", scene_params());
    mistakes.throw_if_any();
    SceneDraft draft = scene_draft(params);
    draft.warnings = mistakes.warnings();
    draft.scene.name = file_name(path);
    draft.scene.settings = to_json(*root, {.locations = false, .indent = false});
    draft.scene.hash = hash_bytes(draft.scene.settings);
    return draft;
}

} // namespace scree
