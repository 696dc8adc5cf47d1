// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace scree {

/// The ways in which this machine can evaluate solid textures in batches, fastest first and
/// "scalar", the reference, last. All vector paths give the same bits.
std::vector<std::string> vector_paths();

/// While it lives, only the path of that name is used; for tests and benches, one at a time and
/// while nothing is evaluated.
class UseVectorPath {
  public:
    explicit UseVectorPath(const std::string& name);
    ~UseVectorPath();
    UseVectorPath(const UseVectorPath&) = delete;
    UseVectorPath& operator=(const UseVectorPath&) = delete;
};

/// Whether "scalar" is in use, as where there is nothing else; otherwise the best of vector_paths()
/// is, unless another is named.
bool scalar_path_in_use();

} // namespace scree
