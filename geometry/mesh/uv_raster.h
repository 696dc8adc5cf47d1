// SPDX-License-Identifier: GPL-3.0-or-later
// The place on a mesh that each texel of a texture over its UVs shows.
#pragma once

#include "geometry/mesh/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scree {

/// A texel's place on the mesh.
struct TexelPlace {
    std::uint32_t triangle = 0;
    Vec3 barycentric{0.0F, 0.0F,
                     0.0F};          // of the point of the triangle nearest to the texel's centre
    Vec3 position{0.0F, 0.0F, 0.0F}; // of its centre; beyond an edge in the triangle's plane
    Vec2f uv{0.0F, 0.0F};            // of its centre, in the mesh's own UVs
    // What the texel covers of the surface: its axes [m], at right angles, as in ShadingPoint.
    Vec3 across{0.0F, 0.0F, 0.0F};
    Vec3 along{0.0F, 0.0F, 0.0F};
};

/// The triangles of a mesh drawn into a texture over its UVs: (0, 0) is the lower left corner of
/// the texture, whose row 0 is at the top, and UVs beyond [0, 1] wrap round. Every texel whose area
/// meets a triangle is covered: by the one that holds its centre, otherwise by the nearest, and by
/// the first of several. The same on any number of threads.
class UvRaster {
  public:
    /// `mesh` has UVs and must outlive the raster; 1 to 2^15 texels a side. Throws Error (input)
    /// where the UVs are useless: without any area, or too far or too often over each other.
    UvRaster(const Mesh& mesh, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    bool covered(std::size_t texel) const { return owners_[texel].triangle != none; }
    const std::vector<std::uint32_t>& covered_texels() const { return covered_; }

    /// Of a covered texel.
    TexelPlace place(std::size_t texel) const;

    /// Texels whose centre lies in more than one triangle: the texture shows only the first.
    std::size_t overlapped() const { return overlapped_; }
    /// Whether some UVs lie beyond [0, 1].
    bool wraps() const { return wraps_; }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Owner { // which triangle, and which copy of the texture it is found in
        std::uint32_t triangle = none;
        std::int16_t tile_x = 0;
        std::int16_t tile_y = 0;
    };
    using Corners = std::array<Vec2, 3>; // in texels, y down, not wrapped

    Corners corners(std::uint32_t triangle) const;
    void check_uvs() const;
    std::size_t draw_band(int first_row, int last_row, std::span<const std::uint32_t> triangles);

    const Mesh& mesh_;
    int width_;
    int height_;
    std::vector<Owner> owners_;
    std::vector<std::uint32_t> covered_;
    std::size_t overlapped_ = 0;
    bool wraps_ = false;
};

} // namespace scree
