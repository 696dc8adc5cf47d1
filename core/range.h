// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace scree {

/// The minimum and maximum of a set of numbers.
struct Range {
    double low = 0;
    double high = 0;
};

} // namespace scree
