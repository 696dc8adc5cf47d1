// SPDX-License-Identifier: GPL-3.0-or-later
// OpenVDB files: the only place that uses OpenVDB.
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <memory>

namespace scree {

/// A sparse volume with a float grid `density` (a fog volume) and a vector grid `color`; both are 0
/// in voxels that are not set.
class VdbFile {
  public:
    /// The matrix transforms (i, j, k) to the world position of the centre of voxel (i, j, k) [m].
    /// It must be invertible.
    explicit VdbFile(const Imath::M44d& world_from_index);
    ~VdbFile();
    VdbFile(const VdbFile&) = delete;
    VdbFile& operator=(const VdbFile&) = delete;

    /// Fast when successive voxels are neighbours. Not thread-safe.
    void set(int i, int j, int k, float density, const Color& color);

    /// The highest density so far.
    float densest() const { return densest_; }

    /// Writes the file atomically. Equal voxels and metadata give equal bytes. Throws Error
    /// (resource) on an unwritable path or a full disk.
    void write(const std::string& path, const Metadata& metadata);

  private:
    struct Grids;
    std::unique_ptr<Grids> grids_;
    float densest_ = 0;
};

} // namespace scree
