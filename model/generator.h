// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "core/registry.h"
#include "model/aggregate.h"

namespace scree {

/// A generator bakes an aggregate. Its parameters are already checked against its specs; it throws
/// `Params::error` for what only it can know (a region larger than the domain).
using Bake = Aggregate(const Params& params, const Context& context);

} // namespace scree
