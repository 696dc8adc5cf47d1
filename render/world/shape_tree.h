// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/world/embree_adapter.h"
#include "render/world/support_function.h"

namespace scree {

/// The bounding volumes in which Embree finds a shape: what its instances share.
struct ShapeTree {
    embree::SceneHandle scene;
    Box3 bounds; // in the object's frame
    std::size_t instances = 0;
    SupportFunction support; // known where the boxes of many instances are to fit

    /// Whether so many instances share it that what speeds up its rays is worth more time to build.
    bool is_shared_by_many() const { return instances >= 32; }
};

} // namespace scree
