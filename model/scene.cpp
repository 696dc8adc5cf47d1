// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scene.h"

#include "core/version.h"

#include <fmt/format.h>

namespace scree {

Metadata provenance(const Scene& scene) {
    return {{"scree:version", SCREE_VERSION},
            {"scree:scene", scene.name},
            {"scree:hash", fmt::format("{:016x}", scene.hash)},
            {"scree:settings", scene.settings}};
}

} // namespace scree
