// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/catalog.h"

#include "formats/table.h"
#include "generators/table.h"
#include "model/table.h"
#include "procedurals/table.h"
#include "shapes/table.h"

namespace scree {

Catalog standard_catalog() {
    Catalog catalog;
    catalog.add(object_table());
    catalog.add(camera_table());
    catalog.add(light_table());
    catalog.add(material_table());
    catalog.add(component_table());
    catalog.add(mesh_file_table());
    catalog.add(curve_table());
    catalog.add(curve_file_table());
    catalog.add(region_table());
    catalog.add(field_table());
    catalog.add(generator_items(generator_table()));
    catalog.add(procedural_table());
    return catalog;
}

std::vector<CatalogRow> catalog_rows(const Catalog& catalog) {
    std::vector<ParamSpec> scene = scene_params();
    scene.front().fields.clear(); // film is listed in a separate row
    std::vector<CatalogRow> rows{{"", "scene", "What a script returns.", std::move(scene)}};
    for (const Registry<MakeObject>& family : catalog.families())
        for (const Plugin<MakeObject>& plugin : family.plugins()) {
            const bool alone = plugin.name == family.family();
            rows.push_back({alone ? "" : family.family(), plugin.name, plugin.doc, plugin.params});
            if (alone) // film follows the other row without a family
                rows.push_back(
                    {"", "film", "The picture: its size and how it is sampled.", film_params()});
        }
    return rows;
}

} // namespace scree
