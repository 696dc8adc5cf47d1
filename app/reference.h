// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters' one declaration as text for people.
#pragma once

#include "session/catalog.h"

#include <span>
#include <string>

namespace scree {

/// "mesh.banana"; a family of one, such as scene, is its own name.
std::string full_name(const CatalogRow& row);

/// Every plug-in with its one sentence, a line each, by family.
std::string plugin_overview(std::span<const CatalogRow> rows);

/// One plug-in with all its parameters.
std::string plugin_details(const CatalogRow& row);

/// docs/reference.md.
std::string reference_markdown(std::span<const CatalogRow> rows);

} // namespace scree
