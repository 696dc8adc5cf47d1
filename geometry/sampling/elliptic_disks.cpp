// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/elliptic_disks.h"

#include "core/float4.h"
#include "core/random.h"
#include "geometry/sampling/disk_cover.h"
#include "geometry/sampling/leaf_cells.h"
#include "geometry/sampling/local_clock.h"
#include "geometry/sampling/timed_parts.h"

#include <bit>
#include <cstring>

namespace scree {

namespace {

// Each cell throws darts at the times of Poisson processes. The rate of each is the measure of the
// places, classes and turns at which its darts may still succeed. At first one process stands for
// the whole cell and all classes. After a miss there is one for each part: a convex piece, one
// class and a range of turns. With each further miss a part shrinks to what samples near it may
// leave uncovered.
class Cells {
  public:
    Cells(const PoissonDiskProblem& problem);

    std::uint32_t count() const { return static_cast<std::uint32_t>(time_.size()); }
    float time(std::uint32_t c) const { return time_[c]; }
    std::uint32_t earliest_near(std::uint32_t c) const;
    void happen(std::uint32_t c);

    PoissonDiskSet result() const;

  private:
    static constexpr std::int32_t nothing = -1; // no sample

    using Parts = TimedParts<DiskPart>;

    void start(std::uint32_t c);
    void add_kept(const DiskSample& sample);
    void place(std::uint32_t c, const PlacedDisk& disk);
    void end_covered(std::uint32_t c);
    void end_whole(std::uint32_t c, std::uint32_t ended);
    void gather_near(std::uint32_t c);
    void keep_uncovered(std::uint32_t c, const DiskPart& part, Random& random);
    void add_part(std::uint32_t c, const DiskPart& part, double exponential);
    DiskPart take_whole(std::uint32_t c, Random& random);
    void cut_parts(std::uint32_t c);
    double measure_whole(std::uint32_t c) const;
    void update_time(std::uint32_t c);

    DiskMetric metric_;
    LeafCells leaves_;
    std::uint64_t seed_;
    DiskCover cover_;
    float now_ = 0; // the time of the current event; 0 before the first
    std::vector<float>
        time_; // of the next dart: the earlier of that for the whole cell and of parts
    std::vector<std::uint32_t> whole_; // a bit for each class for which no dart has missed yet
    std::vector<float> whole_time_;
    std::vector<Parts::Root> part_of_;
    Parts parts_;
    std::vector<std::int32_t> sample_of_;
    std::vector<PlacedDisk> placed_;
    std::vector<std::int32_t> next_placed_; // in the same cell
    std::size_t kept_ = 0;                  // of placed_, the first
    std::vector<NearDisk> near_;            // to the current cell
    std::uint64_t trials_ = 0;
    std::uint64_t unresolved_ = 0;
};

// Coordinates are rounded to 2^-53 of the largest; differences and forms add a few more roundings.
double doubt_of(const PoissonDiskProblem& problem, const DiskMetric& metric) {
    const Box2 box = bounds(*problem.domain);
    const double largest = std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x),
                                     std::abs(box.max.y), metric.longest()});
    return 0x1p-46 * largest / metric.shortest();
}

Cells::Cells(const PoissonDiskProblem& problem)
    : metric_(problem), leaves_(problem, metric_), seed_(problem.seed),
      cover_(problem, metric_, doubt_of(problem, metric_)) {
    const std::uint32_t n = leaves_.count();
    time_.assign(n, never);
    whole_.assign(n, 0);
    whole_time_.assign(n, never);
    part_of_.assign(n, Parts::none);
    sample_of_.assign(n, nothing);
    for (std::uint32_t c = 0; c < n; ++c)
        start(c);
    leaves_.forget_pieces();
    for (const DiskSample& sample : problem.kept)
        add_kept(sample);
    kept_ = placed_.size();
}

void Cells::start(std::uint32_t c) {
    const auto classes = static_cast<std::uint32_t>(metric_.class_count());
    const bool is_whole = leaves_.is_whole(c);
    Random random(seed_, Purpose::disk_start, c);
    if (is_whole) {
        whole_[c] = classes < 32 ? (1U << classes) - 1 : ~0U;
        whole_time_[c] = after(0, random.exponential() / measure_whole(c));
    }
    for (std::uint32_t k = is_whole ? 32 : 0; k < classes; ++k) {
        if (is_whole)
            add_part(c, cover_.part_of(leaves_.square(c), k), random.exponential());
        for (const ConvexPiece& piece : leaves_.pieces(c))
            add_part(c, cover_.part_of(piece, k), random.exponential());
    }
    update_time(c);
}

void Cells::update_time(std::uint32_t c) {
    time_[c] = whole_time_[c];
    if (part_of_[c] != Parts::none)
        time_[c] = std::min(time_[c], parts_.time(part_of_[c]));
}

void Cells::add_kept(const DiskSample& sample) {
    if (const auto c = leaves_.leaf_at(sample.position)) {
        place(*c, cover_.placed(sample));
        end_covered(*c);
    }
}

void Cells::place(std::uint32_t c, const PlacedDisk& disk) {
    placed_.push_back(disk);
    next_placed_.push_back(sample_of_[c]);
    sample_of_[c] = static_cast<std::int32_t>(placed_.size()) - 1;
}

// In cells that the new sample covers wholly, ends the classes that it keeps away: most cells never
// throw a dart. The time to the next dart of the other classes grows as their measure shrinks, for
// waiting times are exponential and have no memory.
void Cells::end_covered(std::uint32_t c) {
    const PlacedDisk& placed = placed_.back();
    const std::uint32_t o = placed.sample.disk_class;
    leaves_.for_runs_near(c, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = first; i < last; ++i) {
            if (whole_[i] == 0)
                continue;
            const Box2 box = leaves_.box(i);
            const Vec2 half = box.size() / 2;
            const Vec2 to = leaves_.nearest_image(box.center() - placed.sample.position);
            if (to.length2() > placed.reach * placed.reach)
                continue;
            const double farthest =
                std::max(std::max(placed.form.at(to + half), placed.form.at(to - half)),
                         std::max(placed.form.at({to.x + half.x, to.y - half.y}),
                                  placed.form.at({to.x - half.x, to.y + half.y})));
            std::uint32_t ended = 0;
            for (std::uint32_t bits = whole_[i]; bits != 0; bits &= bits - 1) {
                const auto k = static_cast<std::uint32_t>(std::countr_zero(bits));
                if (farthest < metric_.limit(o, k) * (1 - cover_.doubt()))
                    ended |= 1U << k;
            }
            if (ended != 0)
                end_whole(i, ended);
        }
    });
}

void Cells::end_whole(std::uint32_t c, std::uint32_t ended) {
    const double before = measure_whole(c);
    whole_[c] &= ~ended;
    const double wait = double(whole_time_[c]) - double(now_);
    whole_time_[c] = whole_[c] == 0 ? never : after(now_, wait * before / measure_whole(c));
    update_time(c);
}

std::uint32_t Cells::earliest_near(std::uint32_t c) const {
    float least = time_[c];
    std::uint32_t run = c;
    leaves_.for_runs_near(c, [&](std::uint32_t first, std::uint32_t last) {
        Float4 four{never, never, never, never};
        std::uint32_t i = first;
        for (; i + 4 <= last; i += 4) {
            Float4 next;
            std::memcpy(&next, &time_[i], sizeof next);
            four = minimum(four, next);
        }
        float least_of = std::min(std::min(four[0], four[1]), std::min(four[2], four[3]));
        for (; i < last; ++i)
            least_of = std::min(least_of, time_[i]);
        if (least_of < least) {
            least = least_of;
            run = first;
        }
    });
    while (time_[run] != least)
        ++run;
    return run;
}

void Cells::gather_near(std::uint32_t c) {
    near_.clear();
    const Vec2 middle = leaves_.box(c).center();
    const double half = (leaves_.box(c).max - middle).length();
    const double cell_reach = leaves_.reach(c);
    leaves_.for_runs_near(c, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = first; i < last; ++i)
            for (std::int32_t s = sample_of_[i]; s != nothing; s = next_placed_[std::size_t(s)]) {
                const PlacedDisk& placed = placed_[std::size_t(s)];
                const Vec2 offset = leaves_.nearest_image(placed.sample.position - middle);
                const double far = std::max(placed.reach, cell_reach) + half;
                if (offset.length2() > far * far)
                    continue;
                near_.push_back({middle + offset, static_cast<std::uint32_t>(s)});
            }
    });
}

void Cells::keep_uncovered(std::uint32_t c, const DiskPart& part, Random& random) {
    DiskPart left = part;
    if (!cover_.cut(left, near_, placed_))
        return;
    if (cover_.is_unresolved(left)) {
        ++unresolved_;
    } else if (left.measure < part.measure / 2) {
        add_part(c, left, random.exponential());
    } else {
        for (DiskPart& half : cover_.split(left)) {
            if (half.piece.count < 3)
                continue;
            cover_.tighten_bounds(half);
            if (cover_.cut(half, near_, placed_))
                add_part(c, half, random.exponential());
        }
    }
}

void Cells::add_part(std::uint32_t c, const DiskPart& part, double exponential) {
    if (part.measure > 0)
        parts_.add(part_of_[c], part, after(now_, exponential / part.measure));
}

double Cells::measure_whole(std::uint32_t c) const {
    double density = 0;
    for (std::uint32_t bits = whole_[c]; bits != 0; bits &= bits - 1)
        density += cover_.density(static_cast<std::uint32_t>(std::countr_zero(bits)));
    const Vec2 size = leaves_.size(c);
    return size.x * size.y * density;
}

// The whole cell for one of its classes, chosen by their rates; the others draw a new time.
DiskPart Cells::take_whole(std::uint32_t c, Random& random) {
    const Vec2 size = leaves_.size(c);
    double chosen = random.bits() * 0x1p-32 * measure_whole(c);
    std::uint32_t k = 0;
    for (std::uint32_t bits = whole_[c]; bits != 0; bits &= bits - 1) {
        k = static_cast<std::uint32_t>(std::countr_zero(bits));
        const double measure = size.x * size.y * cover_.density(k);
        if (chosen < measure)
            break;
        chosen -= measure;
    }
    whole_[c] &= ~(1U << k);
    whole_time_[c] = whole_[c] == 0 ? never : after(now_, random.exponential() / measure_whole(c));
    return cover_.part_of(leaves_.square(c), k);
}

// Cuts from the cell's parts what a new sample covers.
void Cells::cut_parts(std::uint32_t c) {
    parts_.filter(part_of_[c], [&](DiskPart& part, float& time) {
        const double before = part.measure;
        if (!cover_.cut(part, near_, placed_) || !(part.measure > 0))
            return false;
        time = after(now_, (double(time) - double(now_)) * before / part.measure);
        return true;
    });
}

void Cells::happen(std::uint32_t c) {
    ++trials_;
    now_ = time_[c];
    Random random(seed_, Purpose::disk_dart,
                  std::uint64_t{c} << 32 | std::bit_cast<std::uint32_t>(now_));
    const DiskPart part = whole_time_[c] == now_ ? take_whole(c, random) : parts_.take(part_of_[c]);
    const double u = random.bits() * 0x1p-32;
    const double v = random.bits() * 0x1p-32;
    DiskSample sample;
    sample.position = point_in(part.piece, part.area, u, v);
    sample.disk_class = part.disk_class;
    sample.angle = metric_.angle_at(sample.position) + part.turn.low;
    if (part.turn.high > part.turn.low)
        sample.angle += (part.turn.high - part.turn.low) * (random.bits() * 0x1p-32);
    sample.scale = metric_.scale_at(sample.position);
    const PlacedDisk disk = cover_.placed(sample);
    gather_near(c);
    if (cover_.is_free(disk, near_, placed_)) {
        place(c, disk);
        end_covered(c);
        near_.push_back({sample.position, static_cast<std::uint32_t>(placed_.size()) - 1});
        cut_parts(c);
    }
    keep_uncovered(c, part, random);
    update_time(c);
}

PoissonDiskSet Cells::result() const {
    PoissonDiskSet set;
    set.trials = trials_;
    set.unresolved = unresolved_;
    set.samples.reserve(placed_.size() - kept_);
    for (std::uint32_t c = 0; c < count(); ++c) {
        const std::size_t first = set.samples.size();
        for (std::int32_t s = sample_of_[c]; s >= static_cast<std::int32_t>(kept_);
             s = next_placed_[std::size_t(s)])
            set.samples.push_back(placed_[std::size_t(s)].sample);
        std::reverse(set.samples.begin() + std::ptrdiff_t(first), set.samples.end());
    }
    return set;
}

} // namespace

PoissonDiskSet sample_elliptic_disks(const PoissonDiskProblem& problem, const Context& context) {
    Cells cells(problem);
    play(cells, context, "disks");
    return cells.result();
}

} // namespace scree
