// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/report.h"
#include "core/image.h"

namespace scree {

/// One page with the layout from above and its largest empty circle, the distribution of gaps,
/// g(r), radial power, anisotropy, and the two-dimensional spectrum; 1680 x 1060 pixels,
/// display-encoded. `layout` is the first layout of the report.
Image plot_sheet(const AnalysisReport& report, const PlacedRegions& layout,
                 const std::string& title);

} // namespace scree
