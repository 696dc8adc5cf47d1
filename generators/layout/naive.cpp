// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/method.h"

#include <algorithm>

namespace scree {

MethodCounts fill_naive(const LayoutProblem& problem, std::uint64_t cancellations,
                        Placements& placements, const Context& context) {
    MethodCounts counts;
    std::uint64_t longest = 0;
    for (std::uint64_t in_a_row = 0; in_a_row < cancellations && !placements.full();) {
        const std::optional<Dart> dart = throw_dart(problem, counts.trials++);
        if (dart && placements.try_place(*dart)) {
            in_a_row = 0;
        } else {
            ++counts.cancellations;
            ++in_a_row;
        }
        if (counts.trials % 1024 == 0) { // often enough for a person, rarely enough to cost nothing
            longest = std::max(longest, in_a_row);
            context.check_cancel();
            context.report("placing elements", double(longest) / double(cancellations));
        }
    }
    return counts;
}

} // namespace scree
