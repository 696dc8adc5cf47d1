// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace scree {

/// The code paths with which this machine can evaluate solid textures in batches: the fastest
/// first, the reference "scalar" last. All vector paths give the same bits.
std::vector<std::string> vector_paths();

/// Selects a path by name during its lifetime; for tests and benches. Only one may exist, and it
/// must not be created or destroyed during evaluations.
class UseVectorPath {
  public:
    explicit UseVectorPath(const std::string& name);
    ~UseVectorPath();
    UseVectorPath(const UseVectorPath&) = delete;
    UseVectorPath& operator=(const UseVectorPath&) = delete;
};

/// Whether the path "scalar" is active, because it was selected or is the only one. The default is
/// the first of vector_paths().
bool scalar_path_in_use();

} // namespace scree
