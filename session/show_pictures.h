// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <span>

namespace scree {

/// Gives every prototype with a picture but no material a matte material that shows the picture.
void show_pictures(std::span<Aggregate> aggregates);

} // namespace scree
