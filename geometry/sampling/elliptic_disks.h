// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/sampling/poisson_disk.h"

namespace scree {

/// `sample_poisson_disks` for any problem; the domain's reach is already checked.
PoissonDiskSet sample_elliptic_disks(const PoissonDiskProblem& problem, const Context& context);

} // namespace scree
