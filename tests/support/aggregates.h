// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <stdexcept>
#include <string>

namespace scree::tests {

/// The aggregate's fact of this name.
inline double fact(const Aggregate& aggregate, const std::string& name) {
    for (const auto& [key, value] : aggregate.facts)
        if (key == name)
            return value;
    throw std::logic_error("there is no fact " + name);
}

} // namespace scree::tests
