// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/sampling/elliptic_disks.h"

#include "core/error.h"
#include "core/random.h"
#include "generators/sampling/disk_metric.h"
#include "generators/sampling/leaf_cells.h"
#include "generators/sampling/local_clock.h"

#include <bit>

namespace scree {

namespace {

// Each cell throws darts at times of a Poisson process whose rate is the measure of the places,
// classes and turns in which it may still succeed: parts, convex pieces of the domain for one class
// and a range of turns, which shrink with each miss to what the samples near may leave uncovered.
class Cells {
  public:
    Cells(const PoissonDiskProblem& problem);

    std::uint32_t count() const { return static_cast<std::uint32_t>(time_.size()); }
    float time(std::uint32_t c) const { return time_[c]; }
    std::uint32_t earliest_near(std::uint32_t c) const;
    void happen(std::uint32_t c);

    PoissonDiskSet result() const;

  private:
    static constexpr std::int32_t nothing = -1;

    struct Part {
        ConvexPiece piece;
        double area = 0;
        double measure = 0; // the rate of its darts
        std::uint32_t disk_class = 0;
        Range turn;
        std::int32_t next = nothing;
    };
    struct Placed {
        DiskSample sample;
        QuadraticForm form;
        double reach = 0; // longest semi-axis [m]
        std::int32_t next = nothing;
    };

    double rate(const Part& part) const;
    void add_kept(const DiskSample& sample);
    void place(std::uint32_t c, const DiskSample& sample);
    void gather_near(std::uint32_t c);
    bool is_free(const DiskSample& sample, const QuadraticForm& form) const;
    bool cut(Part& part) const;
    void keep_uncovered(std::uint32_t c, const Part& part);
    bool is_unresolved(const Part& part) const;
    std::array<Part, 2> split(const Part& part) const;
    void add_part(std::uint32_t c, const Part& part);
    Part take_part(std::uint32_t c, double chosen);
    double measure_left(std::uint32_t c) const;

    DiskMetric metric_;
    LeafCells leaves_;
    std::uint64_t seed_;
    double doubt_; // share by which limits are widened for conflicts and narrowed for covers
    double unit_;  // area of the least distance: rates are per that [m^2]
    std::vector<float> time_;
    std::vector<std::int32_t> part_of_;
    std::vector<Part> parts_; // of all cells, as lists
    std::int32_t unused_ = nothing;
    std::vector<std::int32_t> sample_of_;
    std::vector<Placed> placed_;
    std::size_t kept_ = 0;     // of placed_, the first
    std::vector<Placed> near_; // of the cell at hand, moved to the image beside it
    std::uint64_t trials_ = 0;
    std::uint64_t unresolved_ = 0;
};

Cells::Cells(const PoissonDiskProblem& problem)
    : metric_(problem), leaves_(problem, metric_), seed_(problem.seed) {
    const Box2 box = bounds(*problem.domain);
    const double largest = std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x),
                                     std::abs(box.max.y), metric_.longest()});
    doubt_ = 0x1p-46 * largest / metric_.shortest();
    unit_ = metric_.least_distance() * metric_.least_distance();
    const std::uint32_t n = leaves_.count();
    time_.assign(n, never);
    part_of_.assign(n, nothing);
    sample_of_.assign(n, nothing);
    for (const DiskSample& sample : problem.kept)
        add_kept(sample);
    kept_ = placed_.size();
    for (std::uint32_t c = 0; c < n; ++c) {
        for (const ConvexPiece& piece : leaves_.pieces(c))
            for (std::uint32_t k = 0; k < metric_.class_count(); ++k) {
                Part part;
                part.piece = piece;
                part.area = area(piece);
                part.disk_class = k;
                part.turn = metric_.at(k).turn;
                part.measure = rate(part);
                add_part(c, part);
            }
        if (const double measure = measure_left(c); measure > 0)
            time_[c] = after(0, Random(seed_, Purpose::disk_start, c).exponential() / measure);
    }
    leaves_.forget_pieces();
}

// Classes get darts in proportion to how many samples they should have.
double Cells::rate(const Part& part) const {
    const DiskClass& c = metric_.at(part.disk_class);
    const double whole = c.turn.high - c.turn.low;
    const double share = whole > 0 ? (part.turn.high - part.turn.low) / whole : 1;
    return part.area * share / (c.length * c.width);
}

void Cells::add_kept(const DiskSample& sample) {
    if (const auto c = leaves_.leaf_at(sample.position))
        place(*c, sample);
}

void Cells::place(std::uint32_t c, const DiskSample& sample) {
    const DiskClass& k = metric_.at(sample.disk_class);
    placed_.push_back({sample, metric_.form(sample.disk_class, sample.angle, sample.scale),
                       std::max(k.length, k.width) * sample.scale, sample_of_[c]});
    sample_of_[c] = static_cast<std::int32_t>(placed_.size()) - 1;
}

std::uint32_t Cells::earliest_near(std::uint32_t c) const {
    float least = time_[c];
    std::uint32_t earliest = c;
    leaves_.for_runs_near(c, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = first; i < last; ++i)
            if (time_[i] < least) {
                least = time_[i];
                earliest = i;
            }
    });
    return earliest;
}

void Cells::gather_near(std::uint32_t c) {
    near_.clear();
    const Vec2 middle = leaves_.box(c).center();
    const double half = (leaves_.box(c).max - middle).length();
    const double own_reach = leaves_.reach(c);
    leaves_.for_runs_near(c, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = first; i < last; ++i)
            for (std::int32_t s = sample_of_[i]; s != nothing; s = placed_[std::size_t(s)].next) {
                const Placed& placed = placed_[std::size_t(s)];
                const Vec2 offset = leaves_.nearest_image(placed.sample.position - middle);
                const double far = std::max(placed.reach, own_reach) + half;
                if (offset.length2() > far * far)
                    continue;
                near_.push_back(placed);
                near_.back().sample.position = middle + offset;
            }
    });
}

bool Cells::is_free(const DiskSample& sample, const QuadraticForm& form) const {
    const std::uint32_t k = sample.disk_class;
    for (const Placed& other : near_) {
        const Vec2 d = other.sample.position - sample.position;
        const std::uint32_t o = other.sample.disk_class;
        if (other.form.at(d) < metric_.limit(o, k) * (1 + doubt_) ||
            form.at(d) < metric_.limit(k, o) * (1 + doubt_))
            return false;
    }
    return true;
}

// Takes from the part what the samples near cover, and what would cover a sample near. Whether
// anything is left.
bool Cells::cut(Part& part) const {
    const std::uint32_t k = part.disk_class;
    DiskMetric::Bounds bounds_of = metric_.over(bounds(part.piece));
    if (!metric_.is_round(k)) {
        bounds_of.angle += (part.turn.low + part.turn.high) / 2;
        bounds_of.half_range += (part.turn.high - part.turn.low) / 2;
    }
    const QuadraticForm own = metric_.common_form(k, bounds_of);
    const DiskClass& own_class = metric_.at(k);
    const double own_reach = std::max(own_class.length, own_class.width) * bounds_of.scale.low;
    const BoundingCircle circle = bounding_circle(part.piece);
    for (const Placed& other : near_) {
        const double far = std::max(other.reach, own_reach) + circle.radius;
        if ((other.sample.position - circle.centre).length2() > far * far)
            continue;
        const std::uint32_t o = other.sample.disk_class;
        cut_away(part.piece, other.sample.position, other.form, metric_.limit(o, k) * (1 - doubt_));
        if (part.piece.count < 3)
            return false;
        cut_away(part.piece, other.sample.position, own, metric_.limit(k, o) * (1 - doubt_));
        if (part.piece.count < 3)
            return false;
    }
    part.area = area(part.piece);
    part.measure = rate(part);
    return true;
}

// Too small to say more; or so small that a jump of the fields in it will not go away.
bool Cells::is_unresolved(const Part& part) const {
    const Box2 box = bounds(part.piece);
    const double extent = std::max(box.size().x, box.size().y);
    const DiskMetric::Bounds all = metric_.over(box);
    const DiskClass& c = metric_.at(part.disk_class);
    const double width = std::min(c.length, c.width) * all.scale.low;
    const double turn = metric_.is_round(part.disk_class) ? 0 : part.turn.high - part.turn.low;
    if ((extent < 1e-9 * width && turn < 1e-9) || part.area < 1e-18 * width * width)
        return true;
    const bool jumps = (!metric_.is_round(part.disk_class) && all.half_range > 0.05) ||
                       all.scale.high > 1.05 * all.scale.low;
    return extent < 1e-3 * width && jumps;
}

// Across the turns where those move the ellipse's tip farther than the place does.
std::array<Cells::Part, 2> Cells::split(const Part& part) const {
    std::array<Part, 2> result{part, part};
    const DiskClass& c = metric_.at(part.disk_class);
    const double half_turn = (part.turn.high - part.turn.low) / 2;
    const double tip = std::max(c.length, c.width) * half_turn;
    if (!metric_.is_round(part.disk_class) && tip > bounding_circle(part.piece).radius) {
        result[0].turn.high = result[1].turn.low = part.turn.low + half_turn;
        return result;
    }
    const std::array<ConvexPiece, 2> pieces = halves(part.piece);
    result[0].piece = pieces[0];
    result[1].piece = pieces[1];
    return result;
}

void Cells::keep_uncovered(std::uint32_t c, const Part& part) {
    Part left = part;
    if (!cut(left))
        return;
    if (is_unresolved(left)) {
        ++unresolved_;
    } else if (left.measure < part.measure / 2) {
        add_part(c, left);
    } else {
        for (Part& half : split(left))
            if (half.piece.count >= 3 && cut(half))
                add_part(c, half);
    }
}

void Cells::add_part(std::uint32_t c, const Part& part) {
    std::int32_t slot = unused_;
    if (slot == nothing) {
        slot = static_cast<std::int32_t>(parts_.size());
        parts_.emplace_back();
    } else {
        unused_ = parts_[std::size_t(slot)].next;
    }
    parts_[std::size_t(slot)] = part;
    parts_[std::size_t(slot)].next = part_of_[c];
    part_of_[c] = slot;
}

// The part in which a number in [0, measure_left) falls, taken out of the cell's list.
Cells::Part Cells::take_part(std::uint32_t c, double chosen) {
    std::int32_t* link = &part_of_[c];
    while (parts_[std::size_t(*link)].next != nothing &&
           chosen >= parts_[std::size_t(*link)].measure) {
        chosen -= parts_[std::size_t(*link)].measure;
        link = &parts_[std::size_t(*link)].next;
    }
    const std::int32_t slot = *link;
    const Part taken = parts_[std::size_t(slot)];
    *link = taken.next;
    parts_[std::size_t(slot)].next = unused_;
    unused_ = slot;
    return taken;
}

double Cells::measure_left(std::uint32_t c) const {
    double sum = 0;
    for (std::int32_t i = part_of_[c]; i != nothing; i = parts_[std::size_t(i)].next)
        sum += parts_[std::size_t(i)].measure;
    return sum;
}

void Cells::happen(std::uint32_t c) {
    ++trials_;
    const float time = time_[c];
    Random random(seed_, Purpose::disk_dart,
                  std::uint64_t{c} << 32 | std::bit_cast<std::uint32_t>(time));
    const Part part = take_part(c, random.uniform() * measure_left(c));
    const double u = random.uniform();
    const double v = random.uniform();
    DiskSample sample;
    sample.position = point_in(part.piece, part.area, u, v);
    sample.disk_class = part.disk_class;
    sample.angle =
        metric_.angle_at(sample.position) + random.uniform(part.turn.low, part.turn.high);
    sample.scale = metric_.scale_at(sample.position);
    gather_near(c);
    const QuadraticForm form = metric_.form(sample.disk_class, sample.angle, sample.scale);
    if (is_free(sample, form)) {
        place(c, sample);
        near_.push_back(placed_.back());
        // The new sample covers most of what the cell has left.
        std::int32_t i = part_of_[c];
        part_of_[c] = nothing;
        while (i != nothing) {
            Part other = parts_[std::size_t(i)];
            parts_[std::size_t(i)].next = unused_;
            unused_ = i;
            i = other.next;
            if (cut(other))
                add_part(c, other);
        }
    }
    keep_uncovered(c, part);
    const double left = measure_left(c);
    time_[c] = left > 0 ? after(time, random.exponential() / left) : never;
}

PoissonDiskSet Cells::result() const {
    PoissonDiskSet set;
    set.trials = trials_;
    set.unresolved = unresolved_;
    set.samples.reserve(placed_.size() - kept_);
    for (std::uint32_t c = 0; c < count(); ++c) {
        const std::size_t first = set.samples.size();
        for (std::int32_t s = sample_of_[c]; s >= static_cast<std::int32_t>(kept_);
             s = placed_[std::size_t(s)].next)
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
