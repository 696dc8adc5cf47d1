// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/sampling/surface_disks.h"

#include "core/error.h"
#include "core/random.h"
#include "generators/sampling/local_clock.h"
#include "generators/sampling/poisson_disk.h"
#include "generators/sampling/surface_cells.h"

#include <fmt/format.h>

#include <bit>

namespace scree {

namespace {

// As the cells of elliptic_disks, on pieces of triangles: a ball around a sample meets a triangle's
// plane in a disk.
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

    double limit2(std::uint32_t a, std::uint32_t b) const {
        const double distance = distances_[a * classes_ + b];
        return distance * distance;
    }
    double rate(const Part& part) const {
        return part.area / limit2(part.disk_class, part.disk_class);
    }
    bool is_free(std::uint32_t c, const SurfaceSample& sample) const;
    bool cut(std::uint32_t c, Part& part) const;
    void keep_uncovered(std::uint32_t c, const Part& part);
    double measure_left(std::uint32_t c) const;

    SurfaceCells surface_;
    std::size_t classes_;
    std::vector<double> distances_; // of class_distances
    double doubt_;                  // [m] that rounding may add to or take from a distance
    std::uint64_t seed_;
    std::vector<float> time_;
    std::vector<std::vector<Part>> parts_; // of each cell
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
    parts_.resize(count());
    samples_.resize(count());
    for (std::uint32_t c = 0; c < count(); ++c) {
        for (const SurfacePiece& piece : surface_.pieces(c))
            for (std::uint32_t k = 0; k < classes_; ++k)
                parts_[c].push_back({piece.piece, area(piece.piece), piece.triangle, k});
        if (const double measure = measure_left(c); measure > 0)
            time_[c] = after(0, Random(seed_, Purpose::disk_start, c).exponential() / measure);
    }
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
            if ((other.position - middle).length2() > far * far)
                continue;
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

void Cells::keep_uncovered(std::uint32_t c, const Part& part) {
    Part left = part;
    if (!cut(c, left))
        return;
    const double least = 1e-9 * std::sqrt(limit2(part.disk_class, part.disk_class));
    const Vec2 size = bounds(left.piece).size();
    if (std::max(size.x, size.y) < least || left.area < least * least) {
        ++unresolved_;
    } else if (left.area < part.area / 2) {
        parts_[c].push_back(left);
    } else {
        for (const ConvexPiece& piece : halves(left.piece)) {
            Part half = left;
            half.piece = piece;
            if (piece.count >= 3 && cut(c, half))
                parts_[c].push_back(half);
        }
    }
}

double Cells::measure_left(std::uint32_t c) const {
    double sum = 0;
    for (const Part& part : parts_[c])
        sum += rate(part);
    return sum;
}

void Cells::happen(std::uint32_t c) {
    ++trials_;
    const float time = time_[c];
    Random random(seed_, Purpose::disk_dart,
                  std::uint64_t{c} << 32 | std::bit_cast<std::uint32_t>(time));
    std::vector<Part>& parts = parts_[c];
    double chosen = random.uniform() * measure_left(c);
    std::size_t i = 0;
    while (i + 1 < parts.size() && chosen >= rate(parts[i]))
        chosen -= rate(parts[i++]);
    const Part part = parts[i];
    parts[i] = parts.back();
    parts.pop_back();
    const double u = random.uniform();
    const double v = random.uniform();
    const TrianglePlane& plane = surface_.plane(part.triangle);
    const SurfaceSample sample{plane.at(point_in(part.piece, part.area, u, v)), Vec3(plane.normal),
                               part.triangle, part.disk_class};
    const bool is_new = is_free(c, sample);
    if (is_new)
        samples_[c].push_back(sample);
    keep_uncovered(c, part);
    if (is_new)
        std::erase_if(parts, [&](Part& other) { return !cut(c, other); });
    const double left = measure_left(c);
    time_[c] = left > 0 ? after(time, random.exponential() / left) : never;
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
    if (!inspect(*problem.mesh).finite)
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
