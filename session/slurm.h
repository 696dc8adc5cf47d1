// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/farm.h"
#include "session/watcher.h"

#include "core/progress.h"

namespace scree {

/// Submits what is missing of a plan to Slurm (sbatch), and waits (squeue) until all pictures are
/// there. What ended without its shard, as on a node that failed, is submitted again, up to `tries`
/// times in all. May be called again for the same plan at any time: what is queued or done is not
/// submitted twice. Throws Error (resource) when Slurm refuses, Error (input) with what the tasks
/// said when some fail, and Cancelled; the jobs go on then.
void run_on_slurm(const FarmPlan& plan, int tries, bool wait, Watcher& watcher,
                  const Cancel& cancel);

} // namespace scree
