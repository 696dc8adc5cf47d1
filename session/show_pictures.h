// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <span>

namespace scree {

/// Gives every prototype that is a picture and has no material a matte one that shows the picture.
void show_pictures(std::span<Aggregate> aggregates);

} // namespace scree
