// SPDX-License-Identifier: GPL-3.0-or-later
// What cmake/precompiled.h is compiled with.
