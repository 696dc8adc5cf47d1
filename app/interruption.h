// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT (Ctrl-C), SIGTERM and SIGHUP end the program soon and in order.
#pragma once

#include "core/progress.h"

namespace scree {

/// To be called first in the program, before there are other threads. From then on one of these
/// signals requests `interruption`. If the program has not ended soon after, and no KeepingWork
/// exists, or on a second signal, outputs that are being written are abandoned and it ends at once.
/// Signals that the program was started to ignore, as by nohup, stay ignored. Also lets writes to
/// closed pipes and over the limit of a file's size fail as other writes do.
void heed_signals();

/// What long computations check.
const Cancel& interruption();

/// 128 and the number of the signal, as shells count.
int interrupted_exit_code();

} // namespace scree
