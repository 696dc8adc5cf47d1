// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// Converts a position from metres with y up to millimetres with z up, as printers take it.
inline Vec3 printer_position(const Vec3& p) {
    return {float(double(p.x) * 1000), float(double(p.z) * -1000), float(double(p.y) * 1000)};
}

} // namespace scree
