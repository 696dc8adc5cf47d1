// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/sampling/poisson_disk.h"

namespace scree {

/// Moves the samples apart in `steps` steps: each is pushed away by those around it, by those of
/// its class over a longer distance than by others, as far as their ellipses say (gradient descent
/// of a Gaussian energy, Öztireli et al. 2010, section 5, with the distances of several classes).
/// The domain's border reflects. Angles and scales follow the fields. Samples that conflict then
/// are left out; the set is no longer maximal.
void relax_disks(const PoissonDiskProblem& problem, int steps, std::vector<DiskSample>& samples,
                 const Context& context);

} // namespace scree
