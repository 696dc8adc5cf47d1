// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/pile/component_settings.h"
#include "generators/pile/pile_kind.h"
#include "model/aggregate.h"

#include <functional>

namespace scree {

/// The kinds of a pile, with bodies that are known well enough to find sites for them but must be
/// completed before any is placed.
struct KindDrafts {
    /// Throws Error, located, for a mesh that makes no body (see `draft_body`) and for a variation
    /// by which it would fold over.
    KindDrafts(std::span<const ComponentSettings> components, std::uint64_t seed);

    /// Completes a kind's body: to be called once for each, in any order, on any thread.
    void complete(std::size_t kind) const { completions[kind](); }

    std::vector<PileKind> kinds;
    std::vector<Prototype> prototypes; // what the body of each kind looks like
    std::vector<std::function<void()>> completions;
};

} // namespace scree
