// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/table.h"

#include "procedurals/checker.h"
#include "procedurals/image.h"
#include "procedurals/ramp.h"
#include "procedurals/solid/bark/bark.h"
#include "procedurals/solid/breccia/breccia.h"
#include "procedurals/solid/granite/granite.h"
#include "procedurals/solid/leather/leather.h"
#include "procedurals/solid/marble/marble.h"
#include "procedurals/solid/stone/stone.h"
#include "procedurals/solid/wood/wood.h"
#include "procedurals/weathered.h"

namespace scree {

Registry<MakeProcedural> procedural_table() {
    Registry<MakeProcedural> table("procedural");
    table.add(checker_plugin());
    table.add(image_plugin());
    table.add(ramp_plugin());
    table.add(bark_plugin());
    table.add(breccia_plugin());
    table.add(granite_plugin());
    table.add(solid_leather_plugin());
    table.add(marble_plugin());
    table.add(stone_plugin());
    table.add(wood_plugin());
    table.add(weathered_plugin());
    return table;
}

} // namespace scree
