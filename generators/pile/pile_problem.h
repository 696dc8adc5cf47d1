// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "generators/pile/pile_sites.h"

namespace scree {

/// The components of generator.pile, drafted: `complete(k)` is to be called for every kind before
/// any is placed, in any order, on any thread. Throws Error, located, for a mesh that cannot be
/// piled (see `draft_component`) and a thickness of what is no sheet.
struct PileKinds {
    explicit PileKinds(const Params& params);

    void complete(std::size_t kind) { completions[kind](kinds[kind].component); }

    std::vector<PileKind> kinds;
    std::vector<std::function<void(PileComponent&)>> completions;
};

} // namespace scree
