// SPDX-License-Identifier: GPL-3.0-or-later
// OpenVDB files: the only door to OpenVDB.
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <memory>

namespace scree {

/// A sparse volume with a float grid `density` (a fog volume) and a vector grid `color`, both 0
/// where nothing is set.
class VdbFile {
  public:
    /// The matrix takes the centre of voxel (i, j, k) from (i, j, k) to the world [m]; it must have
    /// an inverse.
    explicit VdbFile(const Imath::M44d& world_from_index);
    ~VdbFile();
    VdbFile(const VdbFile&) = delete;
    VdbFile& operator=(const VdbFile&) = delete;

    /// Cheap for neighbours one after the other; one thread at a time.
    void set(int i, int j, int k, float density, const Color& color);

    /// The highest density so far.
    float densest() const { return densest_; }

    /// Writes it atomically: the same voxels and metadata give the same bytes. Throws Error
    /// (resource) on an unwritable path or a full disk.
    void write(const std::string& path, const Metadata& metadata);

  private:
    struct Grids;
    std::unique_ptr<Grids> grids_;
    float densest_ = 0;
};

} // namespace scree
