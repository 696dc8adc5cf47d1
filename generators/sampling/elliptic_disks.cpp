// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/sampling/elliptic_disks.h"

#include "core/float4.h"
#include "core/random.h"
#include "generators/sampling/disk_metric.h"
#include "generators/sampling/leaf_cells.h"
#include "generators/sampling/local_clock.h"
#include "generators/sampling/timed_parts.h"

#include <bit>
#include <cstring>

namespace scree {

namespace {

// Each cell throws darts at times of Poisson processes whose rates are the measure of the places,
// classes and turns in which they may still succeed: at first one for the whole cell and all
// classes; after a miss one for each part, a convex piece for one class and a range of turns, which
// shrinks with each further miss to what the samples near may leave uncovered.
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

    struct Part {
        ConvexPiece piece;
        double area = 0;
        double measure = 0; // the rate of its darts
        std::uint32_t disk_class = 0;
        Range turn;
        DiskMetric::Bounds bounds; // over the piece or a box around it, without turn
    };
    using Parts = TimedParts<Part>;
    struct Placed {
        DiskSample sample;
        QuadraticForm form;
        double reach = 0;    // longest semi-axis [m]
        double steepest = 0; // inverse of the shortest [1/m]
        std::int32_t next = nothing;
    };
    struct Near {
        Vec2 position; // of the image beside the cell at hand
        std::uint32_t placed = 0;
    };

    void start(std::uint32_t c);
    Part part_of(const ConvexPiece& piece, std::uint32_t disk_class) const;
    double rate(const Part& part) const;
    void add_kept(const DiskSample& sample);
    void place(std::uint32_t c, const DiskSample& sample, const QuadraticForm& form);
    void end_covered(std::uint32_t c, float now);
    void end_whole(std::uint32_t c, std::uint32_t ended, float now);
    void gather_near(std::uint32_t c);
    bool is_free(const DiskSample& sample, const QuadraticForm& form) const;
    QuadraticForm own_form(const Part& part) const;
    bool cut(Part& part) const;
    void keep_uncovered(std::uint32_t c, const Part& part, Random& random);
    bool is_unresolved(const Part& part) const;
    std::array<Part, 2> split(const Part& part) const;
    void add_part(std::uint32_t c, const Part& part, double exponential);
    Part take_whole(std::uint32_t c, Random& random);
    void cut_parts(std::uint32_t c);
    double measure_whole(std::uint32_t c) const;
    void update_time(std::uint32_t c);

    DiskMetric metric_;
    LeafCells leaves_;
    std::uint64_t seed_;
    double doubt_;   // share by which limits are widened for conflicts and narrowed for covers
    bool symmetric_; // whether a conflicts with b just where b's ellipse holds a: all are disks
    std::vector<double> density_;         // rate per area of each class
    std::vector<QuadraticForm> constant_; // form of each class where it is the same everywhere
    float now_ = 0;                       // while an event happens, its time
    std::vector<float>
        time_; // of the next dart: the earlier of that for the whole cell and of parts
    std::vector<std::uint32_t> whole_; // a bit for each class of which nothing is known yet
    std::vector<float> whole_time_;
    std::vector<Parts::Root> part_of_;
    Parts parts_;
    std::vector<std::int32_t> sample_of_;
    std::vector<Placed> placed_;
    std::size_t kept_ = 0;   // of placed_, the first
    std::vector<Near> near_; // of the cell at hand
    std::uint64_t trials_ = 0;
    std::uint64_t unresolved_ = 0;
};

Cells::Cells(const PoissonDiskProblem& problem)
    : metric_(problem), leaves_(problem, metric_), seed_(problem.seed) {
    const Box2 box = bounds(*problem.domain);
    const double largest = std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x),
                                     std::abs(box.max.y), metric_.longest()});
    doubt_ = 0x1p-46 * largest / metric_.shortest();
    symmetric_ = !problem.scale;
    for (std::uint32_t k = 0; k < metric_.class_count(); ++k) {
        const DiskClass& c = metric_.at(k);
        symmetric_ = symmetric_ && metric_.is_round(k);
        density_.push_back(metric_.dart_density(k));
        if (!problem.direction && !problem.scale && c.turn.low == c.turn.high)
            constant_.push_back(metric_.form(k, c.turn.low, 1));
    }
    if (constant_.size() < metric_.class_count())
        constant_.clear();
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
            add_part(c, part_of(leaves_.square(c), k), random.exponential());
        for (const ConvexPiece& piece : leaves_.pieces(c))
            add_part(c, part_of(piece, k), random.exponential());
    }
    update_time(c);
}

void Cells::update_time(std::uint32_t c) {
    time_[c] = whole_time_[c];
    if (part_of_[c] != Parts::none)
        time_[c] = std::min(time_[c], parts_.time(part_of_[c]));
}

Cells::Part Cells::part_of(const ConvexPiece& piece, std::uint32_t disk_class) const {
    Part part;
    part.piece = piece;
    part.area = area(piece);
    part.disk_class = disk_class;
    part.turn = metric_.at(disk_class).turn;
    if (constant_.empty())
        part.bounds = metric_.over(bounds(piece));
    part.measure = rate(part);
    return part;
}

double Cells::rate(const Part& part) const {
    const Range& turn = metric_.at(part.disk_class).turn;
    const double whole = turn.high - turn.low;
    const double share = whole > 0 ? (part.turn.high - part.turn.low) / whole : 1;
    return part.area * share * density_[part.disk_class];
}

void Cells::add_kept(const DiskSample& sample) {
    if (const auto c = leaves_.leaf_at(sample.position)) {
        place(*c, sample, metric_.form(sample.disk_class, sample.angle, sample.scale));
        end_covered(*c, 0);
    }
}

void Cells::place(std::uint32_t c, const DiskSample& sample, const QuadraticForm& form) {
    const DiskClass& k = metric_.at(sample.disk_class);
    placed_.push_back({sample, form, std::max(k.length, k.width) * sample.scale,
                       1 / (std::min(k.length, k.width) * sample.scale), sample_of_[c]});
    sample_of_[c] = static_cast<std::int32_t>(placed_.size()) - 1;
}

// Ends classes in the cells near that the sample covers whole: most will never throw a dart.
// What is left waits as much longer as its measure is smaller: waits have no memory.
void Cells::end_covered(std::uint32_t c, float now) {
    const Placed& placed = placed_.back();
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
                if (farthest < metric_.limit(o, k) * (1 - doubt_))
                    ended |= 1U << k;
            }
            if (ended != 0)
                end_whole(i, ended, now);
        }
    });
}

void Cells::end_whole(std::uint32_t c, std::uint32_t ended, float now) {
    const double before = measure_whole(c);
    whole_[c] &= ~ended;
    const double wait = double(whole_time_[c]) - double(now);
    whole_time_[c] = whole_[c] == 0 ? never : after(now, wait * before / measure_whole(c));
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
    const double own_reach = leaves_.reach(c);
    leaves_.for_runs_near(c, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = first; i < last; ++i)
            for (std::int32_t s = sample_of_[i]; s != nothing; s = placed_[std::size_t(s)].next) {
                const Placed& placed = placed_[std::size_t(s)];
                const Vec2 offset = leaves_.nearest_image(placed.sample.position - middle);
                const double far = std::max(placed.reach, own_reach) + half;
                if (offset.length2() > far * far)
                    continue;
                near_.push_back({middle + offset, static_cast<std::uint32_t>(s)});
            }
    });
}

bool Cells::is_free(const DiskSample& sample, const QuadraticForm& form) const {
    const std::uint32_t k = sample.disk_class;
    for (const Near& near : near_) {
        const Vec2 d = near.position - sample.position;
        const Placed& other = placed_[near.placed];
        const std::uint32_t o = other.sample.disk_class;
        if (other.form.at(d) < metric_.limit(o, k) * (1 + doubt_) ||
            (!symmetric_ && form.at(d) < metric_.limit(k, o) * (1 + doubt_)))
            return false;
    }
    return true;
}

// Of what all samples in the part would keep away.
QuadraticForm Cells::own_form(const Part& part) const {
    if (!constant_.empty())
        return constant_[part.disk_class];
    DiskMetric::Bounds all = part.bounds;
    if (metric_.is_round(part.disk_class)) {
        all.half_range = 0;
    } else {
        all.angle += (part.turn.low + part.turn.high) / 2;
        all.half_range += (part.turn.high - part.turn.low) / 2;
    }
    return metric_.common_form(part.disk_class, all);
}

// Takes from the part what the samples near cover, and what would cover a sample near. Whether
// anything is left.
bool Cells::cut(Part& part) const {
    const std::uint32_t k = part.disk_class;
    const QuadraticForm own = own_form(part);
    const double own_steepest = symmetric_ ? 0 : own.steepest();
    const BoundingCircle circle = bounding_circle(part.piece);
    // The ellipses whose borders may cross the piece; first all are asked whether one covers it.
    struct Crossing {
        Vec2 centre;
        const QuadraticForm* form;
        double limit;
    };
    std::array<Crossing, 64> crossings;
    std::size_t count = 0;
    const auto covers = [&](const Vec2& centre, const QuadraticForm& form, double steepest,
                            double limit, double root) {
        // The form's root changes by no more than this from the circle's middle to its border.
        const double change = circle.radius * steepest;
        const double here = form.at(centre - circle.centre);
        if (here > (root + change) * (root + change))
            return false;
        const double within = root * (1 - doubt_) - change;
        if (within > 0 && here < within * within)
            return true;
        if (count < crossings.size())
            crossings[count++] = {centre, &form, limit * (1 - doubt_)};
        return false;
    };
    for (const Near& near : near_) {
        const Placed& other = placed_[near.placed];
        const std::uint32_t o = other.sample.disk_class;
        if (covers(near.position, other.form, other.steepest, metric_.limit(o, k),
                   metric_.limit_root(o, k)) ||
            (!symmetric_ && covers(near.position, own, own_steepest, metric_.limit(k, o),
                                   metric_.limit_root(k, o))))
            return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
        cut_away(part.piece, crossings[i].centre, *crossings[i].form, crossings[i].limit);
        if (part.piece.count < 3)
            return false;
    }
    part.area = area(part.piece);
    part.measure = rate(part);
    return true;
}

// Too small to say more; or so small that a jump of the fields in it will not go away.
bool Cells::is_unresolved(const Part& part) const {
    const Vec2 size = bounds(part.piece).size();
    const double extent = std::max(size.x, size.y);
    const DiskMetric::Bounds& all = part.bounds;
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

void Cells::keep_uncovered(std::uint32_t c, const Part& part, Random& random) {
    Part left = part;
    if (!cut(left))
        return;
    if (is_unresolved(left)) {
        ++unresolved_;
    } else if (left.measure < part.measure / 2) {
        add_part(c, left, random.exponential());
    } else {
        for (Part& half : split(left)) {
            if (half.piece.count < 3)
                continue;
            if (constant_.empty())
                half.bounds = metric_.over(bounds(half.piece));
            if (cut(half))
                add_part(c, half, random.exponential());
        }
    }
}

void Cells::add_part(std::uint32_t c, const Part& part, double exponential) {
    if (part.measure > 0)
        parts_.add(part_of_[c], part, after(now_, exponential / part.measure));
}

double Cells::measure_whole(std::uint32_t c) const {
    double density = 0;
    for (std::uint32_t bits = whole_[c]; bits != 0; bits &= bits - 1)
        density += density_[static_cast<std::size_t>(std::countr_zero(bits))];
    const Vec2 size = leaves_.size(c);
    return size.x * size.y * density;
}

// The whole cell for one of its classes, chosen by their rates; the others wait anew.
Cells::Part Cells::take_whole(std::uint32_t c, Random& random) {
    const Vec2 size = leaves_.size(c);
    double chosen = random.bits() * 0x1p-32 * measure_whole(c);
    std::uint32_t k = 0;
    for (std::uint32_t bits = whole_[c]; bits != 0; bits &= bits - 1) {
        k = static_cast<std::uint32_t>(std::countr_zero(bits));
        const double measure = size.x * size.y * density_[k];
        if (chosen < measure)
            break;
        chosen -= measure;
    }
    whole_[c] &= ~(1U << k);
    whole_time_[c] = whole_[c] == 0 ? never : after(now_, random.exponential() / measure_whole(c));
    return part_of(leaves_.square(c), k);
}

// What a new sample leaves of the cell's parts.
void Cells::cut_parts(std::uint32_t c) {
    parts_.filter(part_of_[c], [&](Part& part, float& time) {
        const double before = part.measure;
        if (!cut(part) || !(part.measure > 0))
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
    const Part part = whole_time_[c] == now_ ? take_whole(c, random) : parts_.take(part_of_[c]);
    const double u = random.bits() * 0x1p-32;
    const double v = random.bits() * 0x1p-32;
    DiskSample sample;
    sample.position = point_in(part.piece, part.area, u, v);
    sample.disk_class = part.disk_class;
    sample.angle = metric_.angle_at(sample.position) + part.turn.low;
    if (part.turn.high > part.turn.low)
        sample.angle += (part.turn.high - part.turn.low) * (random.bits() * 0x1p-32);
    sample.scale = metric_.scale_at(sample.position);
    const QuadraticForm form = constant_.empty()
                                   ? metric_.form(sample.disk_class, sample.angle, sample.scale)
                                   : constant_[sample.disk_class];
    gather_near(c);
    if (is_free(sample, form)) {
        place(c, sample, form);
        end_covered(c, now_);
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
