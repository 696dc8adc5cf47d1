// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/report.h"

#include <string>
#include <vector>

namespace scree {

/// A report with its generator and the name that the script gives it.
struct NamedReport {
    std::string generator;
    std::string name;
    AnalysisReport report;
};

/// The JSON output of `scree analyse` (docs/formats.md).
std::string analysis_json(const std::vector<NamedReport>& reports, const std::string& source);

} // namespace scree
