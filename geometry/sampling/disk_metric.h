// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/convex_piece.h"
#include "geometry/sampling/poisson_disk.h"

namespace scree {

/// The ellipses of a problem: what they are at a place, and what is certain of them over a box.
class DiskMetric {
  public:
    explicit DiskMetric(const PoissonDiskProblem& problem);

    std::size_t class_count() const { return classes_.size(); }

    /// The form of a sample: other samples of its class conflict where it is below 1.
    QuadraticForm form(std::uint32_t disk_class, double angle, double scale) const;

    /// Where the form of a class-`of` sample must be below this, a class-`other` one conflicts.
    double limit(std::uint32_t of, std::uint32_t other) const {
        return limits_[of * class_count() + other];
    }

    /// How many darts a class gets per area, relative to others: in proportion to the square of its
    /// ellipse's area. Wide distances are the first to find no more room, so that their classes
    /// would fall short of their share of samples; of three classes 2 : 1.5 : 1 with as many darts
    /// as samples expected the widest has 24% less than its share, and with these 1% more (the
    /// others -14% and +6%).
    double dart_density(std::uint32_t disk_class) const {
        const double ratio = classes_[disk_class].length * classes_[disk_class].width /
                             (least_distance_ * least_distance_);
        return ratio * ratio / (least_distance_ * least_distance_);
    }

    /// The root of `limit`: a distance in units of the semi-axes of the form's ellipse.
    double limit_root(std::uint32_t of, std::uint32_t other) const {
        return limit_roots_[of * class_count() + other];
    }

    double angle_at(const Vec2& p) const; // of the direction field [rad]
    double scale_at(const Vec2& p) const;

    /// What holds for all places of a box.
    struct Bounds {
        double angle = 0;      // [rad] the middle one
        double half_range = 0; // of the angles, pi at most
        Range scale{1, 1};
    };
    Bounds over(const Box2& box) const;
    Range scale_over(const Box2& box) const;

    /// A form whose ellipse lies in the ellipses of all samples of the class with a scale of
    /// `bounds.scale.low` or more and an angle within `bounds.half_range` of `bounds.angle`.
    QuadraticForm common_form(std::uint32_t disk_class, const Bounds& bounds) const;

    const DiskClass& at(std::uint32_t disk_class) const { return classes_[disk_class]; }
    bool is_round(std::uint32_t disk_class) const {
        return classes_[disk_class].length == classes_[disk_class].width;
    }
    double longest() const { return longest_; }               // of all axes, at scale 1 [m]
    double shortest() const { return shortest_; }             // of all axes [m]
    double least_distance() const { return least_distance_; } // of class_distances [m]

  private:
    std::vector<DiskClass> classes_;
    std::vector<double> limits_;
    std::vector<double> limit_roots_;
    std::shared_ptr<const Field> direction_;
    std::shared_ptr<const Field> scale_;
    double longest_ = 0;
    double shortest_ = 0;
    double least_distance_ = 0;
};

} // namespace scree
