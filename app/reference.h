// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters' one declaration as text for people.
#pragma once

#include "scenes/reader/plugins.h"

#include <span>
#include <string>

namespace scree {

/// "mesh.banana"; a family of one, such as scene, is its own name.
std::string full_name(const PluginRow& row);

/// Every plug-in with its one sentence, a line each, by family.
std::string plugin_overview(std::span<const PluginRow> rows);

/// One plug-in with all its parameters.
std::string plugin_details(const PluginRow& row);

/// docs/reference.md.
std::string reference_markdown(std::span<const PluginRow> rows);

} // namespace scree
