// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"

namespace scree {

/// The part with this name. Throws Error (input) when there is none.
const ImagePart& named_part(const ExrFile& file, const std::string& path, const std::string& name);

/// "beauty, albedo, N"; a part without a name is called by its number.
std::string part_names(const ExrFile& file);

} // namespace scree
