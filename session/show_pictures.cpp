// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/show_pictures.h"

#include "model/picture_texture.h"

#include <map>

namespace scree {

void show_pictures(std::span<Aggregate> aggregates) {
    std::map<const Picture*, std::shared_ptr<const Material>> made;
    for (Aggregate& aggregate : aggregates)
        for (Prototype& prototype : aggregate.prototypes) {
            if (!prototype.picture || !prototype.materials.empty())
                continue;
            std::shared_ptr<const Material>& material = made[prototype.picture.get()];
            if (!material)
                material = std::make_shared<const Material>(
                    Matte{{{Color(0.0F), picture_texture(prototype.picture->image)}, {}}});
            prototype.materials = {material};
        }
}

} // namespace scree
