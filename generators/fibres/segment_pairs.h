// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/fibres/rods.h"

namespace scree::fibres {

/// Where two segments are nearest to each other.
struct ClosestPoints {
    float s = 0, t = 0; // shares of the way along the first and the second
    Vec3 between;       // from the point on the second to that on the first [m]
};

/// The points of the segments p + s d and q + t e, s and t in [0, 1], that are nearest to each
/// other (Ericson 2005, 5.1.9).
inline ClosestPoints closest_points(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e) {
    const Vec3 r = p - q;
    const float a = d.dot(d);
    const float b = d.dot(e);
    const float c = d.dot(r);
    const float f = e.dot(r);
    const float h = e.dot(e);
    const float determinant = a * h - b * b;
    const auto share = [](float x) { return x < 0 ? 0.0F : x > 1 ? 1.0F : x; };
    // Of parallel segments any point will do; the middle keeps them parallel.
    float s = determinant > 1e-6F * a * h ? share((b * f - c * h) / determinant) : 0.5F;
    float t = (b * s + f) / h;
    if (t < 0) {
        t = 0;
        s = share(-c / a);
    } else if (t > 1) {
        t = 1;
        s = share((b - c) / a);
    }
    return {s, t, r + d * s - e * t};
}

/// The pairs of segments near each other, listed for both.
class SegmentPairs {
  public:
    struct Pair {
        std::uint32_t own;   // segment of the fibre itself
        std::uint32_t other; // among all segments
    };

    /// Lists pairs for as long as no vertex moves farther than `slack` [m]. Pairs whose surfaces
    /// come nearer than `margin` times their radii are found. Segments of one fibre that are nearer
    /// than four radii along it are none.
    SegmentPairs(double margin, double slack)
        : margin_(static_cast<float>(margin)), slack_(static_cast<float>(slack)) {}

    /// Searches anew if a vertex moved too far since the last time.
    void update(const Rods& rods);

    /// Of a fibre, sorted by both segments.
    std::span<const Pair> of(std::size_t fibre) const { return pairs_[fibre]; }

    /// How far the touching points of each pair have slid on each other, the fibre's own against
    /// the other [m]; kept while a pair is listed, 0 before. Empty until `keep_slips`.
    std::vector<std::vector<Vec3>>& slips() { return slips_; }
    void keep_slips();

    std::size_t searches() const { return searches_; }

  private:
    /// A segment in the grid, by its middle.
    struct Entry {
        Vec3 middle;
        std::uint32_t segment;
    };
    bool is_valid(const Rods& rods) const;
    void fill_grid(const Rods& rods);
    void list_pairs(const Rods& rods, std::size_t fibre);
    void carry_slips(std::size_t fibre, std::span<const Pair> before);

    float margin_;
    float slack_;
    float reach_ = 0;    // of middles [m]
    float thickest_ = 0; // distance between axes of which pairs are listed [m]
    std::size_t searches_ = 0;
    std::vector<Vec3> searched_; // the vertices by then
    Vec3 corner_;
    float cell_ = 1;
    std::array<std::uint32_t, 3> size_{};
    std::vector<std::uint32_t> cell_of_; // of each segment
    std::vector<std::uint32_t> first_;   // of each cell's entries
    std::vector<Entry> entries_;
    std::vector<std::vector<Pair>> pairs_; // of each fibre
    std::vector<std::vector<Vec3>> slips_; // of its pairs
};

} // namespace scree::fibres
