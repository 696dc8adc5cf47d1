// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/table.h"

#include "procedurals/checker.h"

namespace scree {

Registry<MakeProcedural> procedural_table() {
    Registry<MakeProcedural> table("procedural");
    table.add(checker_plugin());
    return table;
}

} // namespace scree
