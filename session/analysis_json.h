// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/report.h"

#include <string>
#include <vector>

namespace scree {

/// A report with the name of its generator.
struct NamedReport {
    std::string generator;
    AnalysisReport report;
};

/// The JSON output of `scree analyse` (docs/formats.md).
std::string analysis_json(const std::vector<NamedReport>& reports, const std::string& source);

} // namespace scree
