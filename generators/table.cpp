// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/table.h"

#include "generators/elements/elements_generator.h"
#include "generators/fibres/fibres_generator.h"
#include "generators/layout/layout_generator.h"
#include "generators/leather/leather_generator.h"
#include "generators/pile/pile_generator.h"
#include "generators/rocks/rocks_generator.h"

namespace scree {

Registry<Generator> generator_table() {
    Registry<Generator> table("generator");
    table.add(layout_plugin());
    table.add(elements_plugin());
    table.add(leather_plugin());
    table.add(pile_plugin());
    table.add(rocks_plugin());
    table.add(fibres_plugin());
    return table;
}

} // namespace scree
