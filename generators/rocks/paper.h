// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/rocks_settings.h"
#include "model/generator.h"

namespace scree::rocks {

/// The method of Sakurai & Miyata, to the letter but for a base that closes each rock. Folds and
/// rocks that meet themselves are counted, not mended.
Aggregate bake_paper(const RocksSettings& settings, const Context& context);

} // namespace scree::rocks
