// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture_materials.h"

#include "procedurals/image.h"

#include <map>

namespace scree {

void show_pictures(std::vector<Aggregate>& aggregates, Scene& scene) {
    std::map<const Picture*, MaterialId> made;
    for (Aggregate& aggregate : aggregates)
        for (Prototype& prototype : aggregate.prototypes) {
            if (!prototype.picture || prototype.material != MaterialId{})
                continue;
            const auto [entry, is_new] = made.try_emplace(prototype.picture.get());
            if (is_new) {
                entry->second.index = static_cast<std::uint32_t>(scene.materials.size());
                scene.materials.push_back(
                    Matte{{{Color(0.0F), picture_texture(*prototype.picture)}, {}}});
            }
            prototype.material = entry->second;
        }
}

} // namespace scree
