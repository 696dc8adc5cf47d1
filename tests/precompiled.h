// SPDX-License-Identifier: GPL-3.0-or-later
// What most tests include, parsed once; every file still includes what it uses.
#pragma once

#include "cmake/precompiled.h"

#include <gtest/gtest.h>

#include <filesystem>
