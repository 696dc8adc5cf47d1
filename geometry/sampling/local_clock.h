// SPDX-License-Identifier: GPL-3.0-or-later
// Runs events of cells: in the order of their times where one may depend on the other, otherwise in
// the order of memory.
#pragma once

#include "core/context.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace scree {

/// The time of an event that never happens.
inline constexpr float never = std::numeric_limits<float>::infinity();

/// The time after a wait; always later, also where the wait is lost in rounding.
inline float after(float time, double wait) {
    const float sum = static_cast<float>(double(time) + wait);
    return sum > time ? sum : std::nextafter(time, never);
}

/// Runs the events of all cells. Each cell has a next event, at `cells.time(c)`. The event may only
/// depend on earlier events in cells near it, and sets the cell's time to that of its next event,
/// in the end to `never`; it may also set the times of cells near it to `never`. So an event can
/// run once no cell near has an earlier one, and events far apart run in any order: the cells are
/// visited in the order of memory, and before each event the earlier ones near it are run. The
/// outcome is that of strict order in time.
///
/// `cells` has count(), time(c), earliest_near(c), the cell near c whose time is the least (c
/// itself where no other is earlier), and happen(c), which runs the event.
template <class Cells>
void play(Cells& cells, const Context& context, std::string_view what) {
    std::vector<std::uint32_t> waiting;
    std::uint32_t steps = 0;
    for (std::uint32_t c = 0; c < cells.count(); ++c) {
        if ((c & 0xFFFU) == 0)
            context.report(what, double(c) / double(cells.count()));
        while (cells.time(c) < never) {
            waiting.push_back(c);
            while (!waiting.empty()) {
                if ((++steps & 0xFFFU) == 0)
                    context.check_cancel();
                const std::uint32_t top = waiting.back();
                if (cells.time(top) == never) { // what came first has ended it
                    waiting.pop_back();
                    continue;
                }
                const std::uint32_t first = cells.earliest_near(top);
                if (first != top) {
                    waiting.push_back(first);
                    continue;
                }
                cells.happen(top);
                waiting.pop_back();
            }
        }
    }
}

} // namespace scree
