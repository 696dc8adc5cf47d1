// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/world/embree_adapter.h"

namespace scree {

/// The bounding volumes in which Embree finds a shape: what its instances share.
struct ShapeTree {
    embree::SceneHandle scene;
    Box3 bounds; // in the object's frame
};

} // namespace scree
