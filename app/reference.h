// SPDX-License-Identifier: GPL-3.0-or-later
// Reference documentation generated from the declarations of parameters.
#pragma once

#include "session/catalog.h"

#include <span>
#include <string>

namespace scree {

/// "mesh.banana", or only the name for a row without family, such as "scene".
std::string full_name(const CatalogRow& row);

/// Every plug-in with its description, one line each, by family.
std::string plugin_overview(std::span<const CatalogRow> rows);

/// One plug-in with all its parameters.
std::string plugin_details(const CatalogRow& row);

/// The content of docs/reference.md.
std::string reference_markdown(std::span<const CatalogRow> rows);

} // namespace scree
