// SPDX-License-Identifier: GPL-3.0-or-later
// Angles in degrees, equal when they differ by full turns, and ranges of them.
#pragma once

#include "geometry/plane/field.h"

#include <algorithm>

namespace scree {

/// The number of full turns nearest to an angle.
inline double full_turns(double angle) { return std::round(angle / 360); }

/// The same angle in [-180, 180].
inline double shorter_turn(double angle) { return angle - 360 * full_turns(angle); }

/// The same angle in [0, 360).
inline double positive_angle(double angle) {
    const double positive = angle - 360 * std::floor(angle / 360);
    return positive < 360 ? positive : 0;
}

/// The smallest range that contains several; for angles, a range that contains them modulo full
/// turns.
class RangeUnion {
  public:
    explicit RangeUnion(bool angle) : angle_(angle) {}

    void add(Range range) {
        if (empty_) {
            all_ = range;
            empty_ = false;
            return;
        }
        if (angle_) {
            const double turn =
                360 * full_turns((all_.low + all_.high - range.low - range.high) / 2);
            range = {range.low + turn, range.high + turn};
        }
        all_ = {std::min(all_.low, range.low), std::max(all_.high, range.high)};
    }

    /// For angles the lower end lies in [0, 360) and the length is at most 360.
    Range range() const {
        if (!angle_)
            return all_;
        if (all_.high - all_.low >= 360)
            return {0, 360};
        const double low = positive_angle(all_.low);
        return {low, low + (all_.high - all_.low)};
    }

  private:
    bool angle_;
    bool empty_ = true;
    Range all_;
};

} // namespace scree
