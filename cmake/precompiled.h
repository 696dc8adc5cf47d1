// SPDX-License-Identifier: GPL-3.0-or-later
// Headers of libraries that most sources include, parsed once. Every file still includes what it
// uses: -D SCREE_FAST_BUILD=OFF builds without this.
#pragma once

#include <ImathBox.h>
#include <ImathColor.h>
#include <ImathMatrix.h>
#include <ImathVec.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>
