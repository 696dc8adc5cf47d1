// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <cmath>
#include <span>
#include <string>

namespace scree {

/// The provenance of a baked file.
struct BakeSource {
    std::string scene; // file name of the script
    std::uint64_t seed = 0;
};

/// Whether a fact is an integer, such as a count, which JSON shows without a decimal point.
inline bool is_whole(double fact) { return fact == std::floor(fact) && std::abs(fact) < 0x1p53; }

/// The aggregates as JSON, in metres and degrees, as specified in docs/formats.md. Numbers are
/// written with enough digits to read back the same value.
std::string bake_json(std::span<const Aggregate> aggregates, const BakeSource& source);

} // namespace scree
