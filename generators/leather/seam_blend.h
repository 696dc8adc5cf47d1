// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/height_field.h"

#include <array>

namespace scree {

/// Which places have several vertices, as those on seams and creases. `place`: as `weld` gives it.
std::vector<bool> split_places(const std::vector<std::uint32_t>& place);

/// Fades a map that repeats over a mesh's UVs from one side of a seam into the other. At a seam the
/// pieces of the UV map, which meet on the surface, show different places of the tile; within
/// `reach` [m] of it a vertex takes its offset partly from the map of the piece across, continued
/// over the seam as if the surface were unfolded there: both halves at the seam, none at `reach`.
class SeamBlend {
  public:
    /// UVs are in tiles: whole numbers apart is the same place. `place`: as `weld` gives it.
    SeamBlend(const Mesh& mesh, const std::vector<std::uint32_t>& place, double reach);

    /// The offset of vertex i [m], whose own side of the seam wants `own`, where `normal` is the
    /// surface's.
    Vec3 offset(const HeightField& field, std::uint32_t i, const Vec3& own,
                const Vec3& normal) const;

  private:
    /// One side of an edge of a seam: the map across it, as a linear function of the way along the
    /// edge and of the distance from it.
    struct Edge {
        Vec3 from;                           // one end
        Vec3 along;                          // to the other; unit
        Vec3 away;                           // from the edge, into the side that looks across; unit
        float length = 0;                    // [m]
        Vec2 uv;                             // across, of `from`
        Vec2 uv_along;                       // its growth per metre
        Vec2 uv_away;                        // likewise
        std::uint32_t seen = 0;              // the piece across
        std::array<std::uint32_t, 2> ends{}; // vertices on the side that looks
    };
    /// A seam near a vertex.
    struct Near {
        std::uint32_t edge = 0;
        float distance = 0; // [m]
    };
    static constexpr std::size_t most = 3; // pieces that a vertex sees: near a box's corner two
    struct Seen {
        std::array<Near, most> seams;
        std::uint32_t count = 0;
    };

    void find_edges(const Mesh& mesh, const std::vector<std::uint32_t>& place);
    void spread(const Mesh& mesh);
    bool sees(std::uint32_t vertex, std::uint32_t piece) const;

    float reach_;
    std::vector<Edge> edges_;
    std::vector<Vec3> positions_; // before displacement
    std::vector<Seen> seen_;      // by vertex; empty without seams
};

} // namespace scree
