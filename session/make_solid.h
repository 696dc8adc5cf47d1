// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fabrication/fabricate.h"
#include "session/session.h"

namespace scree {

/// How `make_solid` makes one closed surface of a scene.
struct SolidOptions {
    FabricationOptions fabrication;
    bool skip_open = false; // leave out what is not closed; otherwise it is an error
};

/// The union of the aggregates' components, or the Error that names what stands in its way. Tells
/// the watcher what was made of it and what was left out.
Fabrication make_solid(std::span<const Aggregate> aggregates, const SolidOptions& options,
                       Session& session);

} // namespace scree
