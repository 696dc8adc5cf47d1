// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/table.h"

#include "procedurals/checker.h"
#include "procedurals/image.h"
#include "procedurals/solid/marble.h"
#include "procedurals/solid/wood.h"

namespace scree {

Registry<MakeProcedural> procedural_table() {
    Registry<MakeProcedural> table("procedural");
    table.add(checker_plugin());
    table.add(image_plugin());
    table.add(marble_plugin());
    table.add(wood_plugin());
    return table;
}

} // namespace scree
