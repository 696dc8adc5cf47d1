// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/file_mesh.h"

#include <array>
#include <cstdint>
#include <unordered_map>

namespace scree {

/// A hash of a few integers, for maps from combinations of them.
struct IntegersHash {
    template <class T, std::size_t n>
    std::size_t operator()(const std::array<T, n>& integers) const {
        std::uint64_t hash = 0;
        for (const T integer : integers) { // multiplied by 2^64 over the golden ratio
            hash = (hash ^ static_cast<std::uint64_t>(integer)) * 0x9e3779b97f4a7c15U;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

/// Makes one vertex of all corners at exactly the same position, for formats without indices.
class VertexMerger {
  public:
    /// `mesh` must outlive this.
    explicit VertexMerger(FileMesh& mesh) : mesh_(mesh) {}

    /// The index of the vertex at this position, which is appended when it is new.
    std::uint32_t add(const Imath::V3d& position);

  private:
    FileMesh& mesh_;
    std::unordered_map<std::array<std::uint64_t, 3>, std::uint32_t, IntegersHash> known_;
};

} // namespace scree
