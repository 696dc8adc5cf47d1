// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/surface_disks.h"

#include "core/error.h"
#include "core/random.h"
#include "geometry/sampling/local_clock.h"
#include "geometry/sampling/poisson_disk.h"
#include "geometry/sampling/surface_cells.h"
#include "geometry/sampling/timed_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace scree {

namespace {

// As the cells of elliptic_disks, on pieces of triangles: a ball around a sample intersects the
// plane of a triangle in a disk.
class Cells {
  public:
    explicit Cells(const SurfaceDiskProblem& problem);

    std::uint32_t count() const { return surface_.count(); }
    float time(std::uint32_t c) const { return time_[c]; }
    std::uint32_t earliest_near(std::uint32_t c) const;
    void happen(std::uint32_t c);

    SurfaceDiskSet result() const;

  private:
    struct Part {
        ConvexPiece piece;
        double area = 0;
        std::uint32_t triangle = 0;
        std::uint32_t disk_class = 0;
    };
    using Parts = TimedParts<Part>;

    double limit2(std::uint32_t a, std::uint32_t b) const {
        const double distance = distances_[a * classes_ + b];
        return distance * distance;
    }
    double rate(const Part& part) const {
        return part.area / limit2(part.disk_class, part.disk_class);
    }
    bool is_free(std::uint32_t c, const SurfaceSample& sample) const;
    bool is_covered(std::uint32_t c, const Part& part) const;
    bool cut(std::uint32_t c, Part& part) const;
    void keep_uncovered(std::uint32_t c, const Part& part, Random& random);
    void throw_dart(std::uint32_t c, const Part& part);
    void add_part(std::uint32_t c, const Part& part, double exponential);
    void update_time(std::uint32_t c);

    SurfaceCells surface_;
    std::size_t classes_;
    std::vector<double> distances_; // of class_distances
    double doubt_;                  // bound of the rounding error of a distance [m]
    std::uint64_t seed_;
    float now_ = 0; // the time of the current event; 0 before the first
    std::vector<float> time_;
    std::vector<Parts::Root> part_of_;
    Parts parts_;
    std::vector<std::vector<SurfaceSample>> samples_;
    std::uint64_t trials_ = 0;
    std::uint64_t unresolved_ = 0;
};

double longest(const std::vector<double>& distances) {
    return *std::max_element(distances.begin(), distances.end());
}

Cells::Cells(const SurfaceDiskProblem& problem)
    : surface_(*problem.mesh, longest(problem.distances)), classes_(problem.distances.size()),
      distances_(class_distances(problem.distances)), seed_(problem.seed) {
    const Box3 box = bounds(*problem.mesh);
    double largest = longest(problem.distances);
    for (const float v : {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z})
        largest = std::max(largest, std::abs(double(v)));
    doubt_ = 0x1p-46 * largest;
    time_.assign(count(), never);
    part_of_.assign(count(), Parts::none);
    samples_.resize(count());
    parts_.reserve(surface_.piece_count() * classes_);
    for (std::uint32_t c = 0; c < count(); ++c) {
        Random random(seed_, Purpose::disk_start, c);
        surface_.each_piece(c, [&](const SurfacePiece& piece) {
            for (std::uint32_t k = 0; k < classes_; ++k)
                add_part(c, {piece.piece, area(piece.piece), piece.triangle, k},
                         random.exponential());
        });
        update_time(c);
    }
}

void Cells::add_part(std::uint32_t c, const Part& part, double exponential) {
    if (part.area > 0)
        parts_.add(part_of_[c], part, after(now_, exponential / rate(part)));
}

void Cells::update_time(std::uint32_t c) {
    time_[c] = part_of_[c] == Parts::none ? never : parts_.time(part_of_[c]);
}

std::uint32_t Cells::earliest_near(std::uint32_t c) const {
    std::uint32_t earliest = c;
    for (const std::uint32_t other : surface_.near(c))
        if (time_[other] < time_[earliest])
            earliest = other;
    return earliest;
}

bool Cells::is_free(std::uint32_t c, const SurfaceSample& sample) const {
    for (const std::uint32_t cell : surface_.near(c))
        for (const SurfaceSample& other : samples_[cell]) {
            const double distance =
                distances_[sample.disk_class * classes_ + other.disk_class] + doubt_;
            if ((other.position - sample.position).length2() < distance * distance)
                return false;
        }
    return true;
}

// Whether one sample near covers all of the part, as is the case for most parts of a fine mesh.
bool Cells::is_covered(std::uint32_t c, const Part& part) const {
    const BoundingCircle circle = bounding_circle(part.piece);
    const Imath::V3d middle = surface_.plane(part.triangle).at(circle.centre);
    for (const std::uint32_t cell : surface_.near(c))
        for (const SurfaceSample& other : samples_[cell]) {
            const double within =
                distances_[part.disk_class * classes_ + other.disk_class] - doubt_ - circle.radius;
            if (within > 0 && (other.position - middle).length2() < within * within)
                return true;
        }
    return false;
}

// Takes from the part what the samples near cover. Whether anything is left.
bool Cells::cut(std::uint32_t c, Part& part) const {
    const TrianglePlane& plane = surface_.plane(part.triangle);
    const BoundingCircle circle = bounding_circle(part.piece);
    const Imath::V3d middle = plane.at(circle.centre);
    for (const std::uint32_t cell : surface_.near(c))
        for (const SurfaceSample& other : samples_[cell]) {
            const double distance =
                distances_[part.disk_class * classes_ + other.disk_class] - doubt_;
            const double far = distance + circle.radius;
            const double away2 = (other.position - middle).length2();
            if (away2 > far * far)
                continue;
            const double within = distance - circle.radius;
            if (within > 0 && away2 < within * within)
                return false;
            const double height = plane.height(other.position);
            const double limit = distance * distance - height * height;
            if (limit <= 0)
                continue;
            cut_away(part.piece, plane.project(other.position), RoundForm{}, limit);
            if (part.piece.count < 3)
                return false;
        }
    part.area = area(part.piece);
    return true;
}

void Cells::keep_uncovered(std::uint32_t c, const Part& part, Random& random) {
    Part left = part;
    if (!cut(c, left))
        return;
    const double least = 1e-9 * std::sqrt(limit2(part.disk_class, part.disk_class));
    const Vec2 size = bounds(left.piece).size();
    if (std::max(size.x, size.y) < least || left.area < least * least) {
        ++unresolved_;
    } else if (left.area < part.area / 2) {
        add_part(c, left, random.exponential());
    } else {
        for (const ConvexPiece& piece : halves(left.piece)) {
            Part half = left;
            half.piece = piece;
            if (piece.count >= 3 && cut(c, half))
                add_part(c, half, random.exponential());
        }
    }
}

void Cells::happen(std::uint32_t c) {
    ++trials_;
    now_ = time_[c];
    const Part part = parts_.take(part_of_[c]);
    if (!is_covered(c, part)) // otherwise no dart could succeed
        throw_dart(c, part);
    update_time(c);
}

void Cells::throw_dart(std::uint32_t c, const Part& part) {
    Random random(seed_, Purpose::disk_dart,
                  std::uint64_t{c} << 32 | std::bit_cast<std::uint32_t>(now_));
    const double u = random.bits() * 0x1p-32;
    const double v = random.bits() * 0x1p-32;
    const TrianglePlane& plane = surface_.plane(part.triangle);
    const SurfaceSample sample{plane.at(point_in(part.piece, part.area, u, v)), Vec3(plane.normal),
                               part.triangle, part.disk_class};
    if (is_free(c, sample)) {
        samples_[c].push_back(sample);
        // The sample covers most of the cell's parts. The time to the next dart grows as the area
        // of a part shrinks.
        parts_.filter(part_of_[c], [&](Part& other, float& time) {
            const double before = other.area;
            if (!cut(c, other) || !(other.area > 0))
                return false;
            time = after(now_, (double(time) - double(now_)) * before / other.area);
            return true;
        });
    }
    keep_uncovered(c, part, random);
}

SurfaceDiskSet Cells::result() const {
    SurfaceDiskSet set{.samples = {}, .trials = trials_, .unresolved = unresolved_};
    for (const std::vector<SurfaceSample>& samples : samples_)
        set.samples.insert(set.samples.end(), samples.begin(), samples.end());
    return set;
}

} // namespace

SurfaceDiskSet sample_surface_disks(const SurfaceDiskProblem& problem, const Context& context) {
    constexpr double most = 0x1p27;
    const double surface = area(*problem.mesh);
    if (!std::all_of(problem.mesh->positions.begin(), problem.mesh->positions.end(), is_finite))
        throw Error("the mesh has numbers that are not finite");
    if (!(surface > 0))
        throw Error("the mesh has no area");
    const std::vector<double> distances = class_distances(problem.distances);
    const double least = *std::min_element(distances.begin(), distances.end());
    if (!(0.7 * surface / (least * least) < most))
        throw Error(fmt::format("the mesh has {:.4g} m2, too much for a distance of {:.4g} m: "
                                "there would be over {:.1g} samples",
                                surface, least, most));
    Cells cells(problem);
    play(cells, context, "disks");
    return cells.result();
}

} // namespace scree
