// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scree::fibres {

/// The indices of the places in the order of a curve through a grid of 1024^3 cells that keeps
/// neighbours together (Morton 1966): fibres in that order meet others that lie near them in
/// memory too.
std::vector<std::uint32_t> order_in_space(std::span<const Vec3> places);

} // namespace scree::fibres
