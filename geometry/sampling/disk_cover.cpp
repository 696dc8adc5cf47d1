// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/disk_cover.h"

namespace scree {

DiskCover::DiskCover(const PoissonDiskProblem& problem, const DiskMetric& metric, double doubt)
    : metric_(metric), doubt_(doubt), symmetric_(!problem.scale) {
    for (std::uint32_t k = 0; k < metric_.class_count(); ++k) {
        const DiskClass& c = metric_.at(k);
        symmetric_ = symmetric_ && metric_.is_round(k);
        density_.push_back(metric_.dart_density(k));
        if (!problem.direction && !problem.scale && c.turn.low == c.turn.high)
            constant_.push_back(metric_.form(k, c.turn.low, 1));
    }
    if (constant_.size() < metric_.class_count())
        constant_.clear();
}

PlacedDisk DiskCover::placed(const DiskSample& sample) const {
    const DiskClass& c = metric_.at(sample.disk_class);
    return {sample,
            constant_.empty() ? metric_.form(sample.disk_class, sample.angle, sample.scale)
                              : constant_[sample.disk_class],
            std::max(c.length, c.width) * sample.scale,
            1 / (std::min(c.length, c.width) * sample.scale)};
}

DiskPart DiskCover::part_of(const ConvexPiece& piece, std::uint32_t disk_class) const {
    DiskPart part;
    part.piece = piece;
    part.area = area(piece);
    part.disk_class = disk_class;
    part.turn = metric_.at(disk_class).turn;
    if (constant_.empty())
        part.bounds = metric_.over(bounds(piece));
    part.measure = rate(part);
    return part;
}

void DiskCover::tighten_bounds(DiskPart& part) const {
    if (constant_.empty())
        part.bounds = metric_.over(bounds(part.piece));
}

double DiskCover::rate(const DiskPart& part) const {
    const Range& turn = metric_.at(part.disk_class).turn;
    const double whole = turn.high - turn.low;
    const double share = whole > 0 ? (part.turn.high - part.turn.low) / whole : 1;
    return part.area * share * density_[part.disk_class];
}

bool DiskCover::is_free(const PlacedDisk& disk, std::span<const NearDisk> near,
                        std::span<const PlacedDisk> placed) const {
    const std::uint32_t k = disk.sample.disk_class;
    for (const NearDisk& n : near) {
        const Vec2 d = n.position - disk.sample.position;
        const PlacedDisk& other = placed[n.placed];
        const std::uint32_t o = other.sample.disk_class;
        if (other.form.at(d) < metric_.limit(o, k) * (1 + doubt_) ||
            (!symmetric_ && disk.form.at(d) < metric_.limit(k, o) * (1 + doubt_)))
            return false;
    }
    return true;
}

// An ellipse within those of all samples that may lie in the part.
QuadraticForm DiskCover::form_of_all(const DiskPart& part) const {
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

bool DiskCover::cut(DiskPart& part, std::span<const NearDisk> near,
                    std::span<const PlacedDisk> placed) const {
    const std::uint32_t k = part.disk_class;
    const QuadraticForm form = form_of_all(part);
    const double steepest = symmetric_ ? 0 : form.steepest();
    const BoundingCircle circle = bounding_circle(part.piece);
    // The ellipses whose borders may cross the piece, cut away only if none covers all of it.
    struct Crossing {
        Vec2 centre;
        const QuadraticForm* form;
        double limit;
    };
    std::array<Crossing, 64> crossings;
    std::size_t count = 0;
    const auto covers = [&](const Vec2& centre, const QuadraticForm& ellipse, double slope,
                            double limit, double root) {
        // The form's root changes by no more than this from the circle's middle to its border.
        const double change = circle.radius * slope;
        const double here = ellipse.at(centre - circle.centre);
        if (here > (root + change) * (root + change))
            return false;
        const double within = root * (1 - doubt_) - change;
        if (within > 0 && here < within * within)
            return true;
        if (count < crossings.size())
            crossings[count++] = {centre, &ellipse, limit * (1 - doubt_)};
        return false;
    };
    for (const NearDisk& n : near) {
        const PlacedDisk& other = placed[n.placed];
        const std::uint32_t o = other.sample.disk_class;
        if (covers(n.position, other.form, other.steepest, metric_.limit(o, k),
                   metric_.limit_root(o, k)) ||
            (!symmetric_ &&
             covers(n.position, form, steepest, metric_.limit(k, o), metric_.limit_root(k, o))))
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

bool DiskCover::is_unresolved(const DiskPart& part) const {
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

std::array<DiskPart, 2> DiskCover::split(const DiskPart& part) const {
    std::array<DiskPart, 2> result{part, part};
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

} // namespace scree
