// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "core/registry.h"
#include "model/aggregate.h"

namespace scree {

/// A generator bakes an aggregate from parameters that were checked against its specs. It throws
/// `Params::error` for what the specs cannot express, such as a region larger than the domain.
using Bake = Aggregate(const Params& params, const Context& context);

} // namespace scree
