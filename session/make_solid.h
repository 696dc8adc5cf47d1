// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fabrication/fabricate.h"
#include "session/session.h"

namespace scree {

/// Options of `make_solid`.
struct SolidOptions {
    FabricationOptions fabrication;
    bool skip_open = false; // leave out open components, which are an error otherwise
};

/// The union of the aggregates' components as one closed surface. Reports to the watcher what was
/// made and what was left out. Throws Error naming components that prevent it.
Fabrication make_solid(std::span<const Aggregate> aggregates, const SolidOptions& options,
                       Session& session);

} // namespace scree
