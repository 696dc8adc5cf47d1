// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "generators/pile/orientation_flow.h"

namespace scree {

/// The fields of a flow's record.
std::vector<ParamSpec> flow_specs();

/// The flow that the record describes. Throws Error unless it is exactly one kind of flow, and for
/// an axis or a direction of no length.
OrientationFlow orientation_flow(const Params& params);

} // namespace scree
