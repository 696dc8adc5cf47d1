// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "core/registry.h"
#include "model/aggregate.h"

#include <functional>

namespace scree {

/// Makes an aggregate; the same one every time.
using Bake = std::function<Aggregate(const Context& context)>;

/// What a generator does with its parameters, which were checked against its specs: it refuses by
/// `Params::error` what the specs cannot express, such as a component larger than the domain, and
/// leaves the work to the bake that it returns. So `scree check` is fast and finds what it can.
using Generator = Bake(const Params& params);

} // namespace scree
