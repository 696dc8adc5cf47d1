// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/generator.h"

namespace scree {

Registry<Generator> generator_table(); // generator.layout, ...

} // namespace scree
