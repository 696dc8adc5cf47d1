// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// A place in a file for printers: millimetres, and z is up, which y is here.
inline Vec3 printer_position(const Vec3& p) {
    return {float(double(p.x) * 1000), float(double(p.z) * -1000), float(double(p.y) * 1000)};
}

} // namespace scree
