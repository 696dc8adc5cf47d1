// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/catalog.h"

namespace scree {

/// The built-in plug-ins of all folders; more may be added before a script is read.
Catalog standard_catalog();

/// One constructor or record that a scene can contain.
struct CatalogRow {
    std::string family; // "mesh"; "" for scene, object and film
    std::string name;   // "banana"
    std::string doc;
    std::vector<ParamSpec> params;
};

/// All plug-ins of a catalog, and scene and film, for `scree list` and the reference page.
std::vector<CatalogRow> catalog_rows(const Catalog& catalog);

} // namespace scree
