// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/saturation_search.h"

#include <algorithm>

namespace scree {

void SearchCounts::add(const SearchCounts& other) {
    cells += other.cells;
    darts += other.darts;
    queries += other.queries;
    undecided += other.undecided;
}

SaturationSearch::SaturationSearch(const SearchProblem& problem, const Placements& others,
                                   Random random)
    : problem_(problem), layout_(problem.layout), others_(others), random_(random) {}

void SaturationSearch::add_neighbour(const Dart& dart, const Vec2& offset) {
    neighbours_.push_back({dart, offset});
    const SearchShape& shape = problem_.shapes[dart.component];
    const FigurePose& pose = dart.pose;
    const std::size_t first = fine_.fixed.size();
    for (const NoFitPiece& piece : shape.pieces)
        fine_.fixed.add(piece, pose.cosine, pose.sine, pose.scale, offset);
    for (const NoFitPiece& piece : shape.coarse)
        coarse_.fixed.add(piece, pose.cosine, pose.sine, pose.scale, offset);
    pieces_of_.emplace_back(first, fine_.fixed.size());
}

/// On a torus, several images of one element may reach into a box.
void SaturationSearch::add_neighbours(const Dart& dart) {
    const Vec2 nearest = layout_.domain.nearest_image(dart.pose.position - centre_);
    const double reach =
        reach_ + layout_.shapes[dart.component].radius() * dart.pose.scale + dart.margin;
    const Vec2 period = layout_.domain.box().size();
    const int images = layout_.domain.is_torus() ? 1 : 0;
    for (int y = -images; y <= images; ++y)
        for (int x = -images; x <= images; ++x) {
            const Vec2 offset = images == 0 ? nearest : nearest + period * Vec2(x, y);
            if (offset.length2() <= reach * reach)
                add_neighbour(dart, offset);
        }
}

void SaturationSearch::gather(const Box2& box, double reach) {
    neighbours_.clear();
    pieces_of_.clear();
    fine_.fixed.clear();
    coarse_.fixed.clear();
    found_.clear();
    centre_ = box.center();
    reach_ = box.size().length() / 2 + reach;
    others_.gather(centre_, reach_, found_);
    for (const std::uint32_t i : found_)
        add_neighbours(others_.darts()[i]);
    for (const Dart& dart : placed_)
        add_neighbours(dart);
    const std::size_t first = fine_.fixed.size();
    for (const NoFitPiece& piece : problem_.outside) {
        if (!piece.is_near(centre_, reach_))
            continue;
        fine_.fixed.add(piece, 1, 0, 1, -centre_);
        coarse_.fixed.add(piece, 1, 0, 1, -centre_);
    }
    outside_ = {first, fine_.fixed.size()};
}

void SaturationSearch::add_pairs(std::pair<std::size_t, std::size_t> pieces, double margin) {
    for (std::size_t b = pieces.first; b < pieces.second; ++b)
        for (std::uint32_t a = 0; a < problem_.shapes[component_].pieces.size(); ++a)
            pairs_.push_back({a, static_cast<std::uint32_t>(b), static_cast<float>(margin)});
}

void SaturationSearch::saturate(const Box2& box, std::uint32_t component) {
    component_ = component;
    const SearchShape& shape = problem_.shapes[component];
    const Range scales = layout_.scale_over(box);
    const Range range = {layout_.scale.low,
                         shape.smaller_is_easier ? layout_.scale.low : layout_.scale.high};
    Cell cell{.low = scales.low * range.low, .high = scales.high * range.high};
    const double margin = layout_.margins.empty()
                              ? 0
                              : layout_.margins[component] * scales.high * layout_.scale.high *
                                    layout_.density_over(box).high;
    // Darts may be larger than the elements that the search looks for.
    gather(box, layout_.shapes[component].radius() * scales.high * layout_.scale.high + margin +
                    problem_.epsilon);
    const Range direction = layout_.direction_over(box);
    const double low = direction.low + layout_.rotation.low;
    const double high = direction.high + layout_.rotation.high;
    is_turned_freely_ = layout_.rotation.high - layout_.rotation.low >= 2 * pi - 1e-12;
    const double width = is_turned_freely_ ? shape.turn_period : std::min(high - low, 2 * pi);
    cell.angle = low + width / 2;
    cell.half_angle = width / 2;

    pairs_.clear();
    fragments_.clear();
    add_pairs(outside_, 0);
    for (std::size_t i = 0; i < neighbours_.size(); ++i)
        add_pairs(pieces_of_[i], neighbours_[i].dart.margin);
    cell.neighbours = neighbours_.size();
    const Vec2 half = box.size() / 2.0;
    const Fragment whole = box_fragment({Vec2f(-half), Vec2f(half)});
    if (layout_.domain.inside() == Inside::centre) {
        for (const NoFitPiece& piece : problem_.inside) {
            if (!piece.is_near(centre_, half.length()))
                continue;
            Fragment part = whole;
            for (std::size_t i = 0; i < piece.normals.size() && part.count >= 3; ++i) {
                const Vec2f normal(piece.normals[i]);
                part =
                    part_of(part, normal.x, normal.y,
                            static_cast<float>(piece.offsets[i] - piece.normals[i].dot(centre_)));
            }
            if (part.count >= 3)
                fragments_.push_back(part);
        }
    } else {
        fragments_.push_back(whole);
    }
    cell.fragments = fragments_.size();
    examine(cell, 0, 0);
}

void SaturationSearch::examine(Cell cell, std::size_t parent_pair, std::size_t parent_neighbours) {
    ++counts_.cells;
    const std::size_t first_fragment = fragments_.size() - cell.fragments;
    cell.box.makeEmpty();
    for (std::size_t i = first_fragment; i < fragments_.size(); ++i)
        cell.box.extendBy(fragments_[i].box());
    cell.first_pair = pairs_.size();
    if (cell.fragments > 0 && is_allowed(cell)) {
        turn_pieces(cell);
        take_pairs(cell, parent_pair, parent_neighbours);
        cell.neighbours = neighbours_.size();
        if (!is_covered(cell, first_fragment, cell.first_pair, parent_pair)) {
            const Extent wide = extent(cell);
            bool is_open = true;
            while (is_open && wide.turn < problem_.dart_extent && throw_into(first_fragment, cell))
                is_open = !cover_new(cell, first_fragment);
            if (is_open) {
                // The middle of a small cell is certainly free, up to rounding. A cell that is
                // still open when it is much smaller than that cannot be decided.
                const double motion = wide.turn + wide.scale + wide.fields;
                const bool is_last =
                    motion <= problem_.smallest_extent / 64 || cell.depth > deepest;
                const bool is_small = motion <= problem_.smallest_extent || is_last;
                if (!is_small || !finish(cell, first_fragment, is_last))
                    split(cell, first_fragment, wide);
            }
        }
    }
    pairs_.resize(cell.first_pair);
    fragments_.resize(first_fragment);
}

/// Whether some place in the cell's box has an angle and a scale of the cell; narrows the scales.
bool SaturationSearch::is_allowed(Cell& cell) const {
    const LayoutFields& fields = layout_.fields;
    if (!fields.direction && !fields.scale && !fields.classes)
        return true;
    const Box2 box = world(cell.box);
    if (fields.classes) {
        const Range classes = fields.classes->over(box);
        const auto wanted = static_cast<double>(layout_.classes[component_]);
        if (classes.low > wanted + 0.5 || classes.high < wanted - 0.5)
            return false;
    }
    if (fields.direction && !is_turned_freely_) {
        const Range direction = layout_.direction_over(box);
        const double low = direction.low + layout_.rotation.low;
        const double high = direction.high + layout_.rotation.high;
        if (std::abs(angle_between(cell.angle, (low + high) / 2)) >
            cell.half_angle + (high - low) / 2 + 1e-9)
            return false;
    }
    if (fields.scale) {
        const Range factor = layout_.scale_over(box);
        const double high =
            problem_.shapes[component_].smaller_is_easier ? layout_.scale.low : layout_.scale.high;
        cell.low = std::max(cell.low, factor.low * layout_.scale.low);
        cell.high = std::min(cell.high, factor.high * high);
    }
    return cell.low <= cell.high;
}

void SaturationSearch::turn_pieces(const Cell& cell) {
    fine_.moving.clear();
    coarse_.moving.clear();
    const double cosine = std::cos(cell.angle), sine = std::sin(cell.angle);
    for (const NoFitPiece& piece : problem_.shapes[component_].pieces)
        fine_.moving.add(piece, cosine, sine, 1, {0, 0});
    for (const NoFitPiece& piece : problem_.shapes[component_].coarse)
        coarse_.moving.add(piece, cosine, sine, 1, {0, 0});
}

/// Lists the pairs that may matter in the cell: those of its parent's pairs that still do, and
/// those of the elements placed since.
void SaturationSearch::take_pairs(const Cell& cell, std::size_t parent_pair,
                                  std::size_t parent_neighbours) {
    const auto high = static_cast<float>(cell.high), low = static_cast<float>(cell.low);
    const auto half_angle = static_cast<float>(std::min(cell.half_angle, pi));
    const auto kept_free = static_cast<float>(problem_.epsilon + problem_.largest_margin);
    const auto may_matter = [&](const Pair& pair) {
        const PiecePool::Piece& a = fine_.moving[pair.moving];
        const PiecePool::Piece& b = fine_.fixed[pair.fixed];
        const Vec2f target = b.centre - a.centre * ((low + high) / 2);
        const float slack = a.centre.length() * (high * half_angle + (high - low) / 2);
        const float reach = a.radius * high + b.radius + slack + kept_free + pair.margin;
        const float dx = std::max({cell.box.min.x - target.x, target.x - cell.box.max.x, 0.0F});
        const float dy = std::max({cell.box.min.y - target.y, target.y - cell.box.max.y, 0.0F});
        return dx * dx + dy * dy < reach * reach;
    };
    for (std::size_t i = parent_pair; i < cell.first_pair; ++i)
        if (may_matter(pairs_[i]))
            pairs_.push_back(Pair(pairs_[i]));
    for (std::size_t n = parent_neighbours; n < neighbours_.size(); ++n) {
        const std::size_t from = pairs_.size();
        add_pairs(pieces_of_[n], neighbours_[n].dart.margin);
        pairs_.erase(std::remove_if(pairs_.begin() + std::ptrdiff_t(from), pairs_.end(),
                                    [&](const Pair& pair) { return !may_matter(pair); }),
                     pairs_.end());
    }
}

/// Subtracts the no-fit polygons of the pairs from `first_pair` on from the cell's fragments.
/// Returns whether nothing is left.
bool SaturationSearch::is_covered(Cell& cell, std::size_t first_fragment, std::size_t first_pair,
                                  std::size_t parent_pair) {
    if (cell.half_angle > widest_half_angle)
        return false;
    const TurnInterval turn{static_cast<float>(std::cos(cell.half_angle)),
                            static_cast<float>(std::sin(cell.half_angle)),
                            static_cast<float>(cell.low), static_cast<float>(cell.high)};
    double margin = 0;
    if (!layout_.margins.empty())
        margin = layout_.margins[component_] * cell.low * layout_.density_over(world(cell.box)).low;
    const double bare = problem_.epsilon - problem_.safety;
    // Coarse pieces lie within fine ones, which may reach what the coarse ones are apart from.
    const Extent wide = extent(cell);
    const bool is_coarse = wide.turn + wide.scale > problem_.coarse_extent;
    const Pools& pools = is_coarse ? coarse_ : fine_;
    const auto largest = static_cast<float>(problem_.epsilon + problem_.largest_margin +
                                            (is_coarse ? problem_.coarse_loss : 0));
    std::size_t useful = first_pair;
    for (std::size_t p = first_pair; p < pairs_.size(); ++p) {
        const Pair pair = pairs_[p];
        const PiecePool::Piece& a = pools.moving[pair.moving];
        const PiecePool::Piece& b = pools.fixed[pair.fixed];
        // Neighbouring normals of the sum are no farther apart than those of either.
        const float blunt = std::max(a.corner_cosine, b.corner_cosine);
        const float clearance = blunt * (static_cast<float>(bare + margin) + pair.margin);
        const NoFit fit = no_fit(pools.moving, a, turn, pools.fixed, b, clearance,
                                 largest + pair.margin, cell.box, no_fit_);
        if (fit == NoFit::never) {
            pairs_[p--] = pairs_.back();
            pairs_.pop_back();
        }
        if (fit != NoFit::found)
            continue;
        rest_.clear();
        bool any = false;
        for (std::size_t i = first_fragment; i < fragments_.size();) {
            if (subtract(fragments_[i], no_fit_, problem_.sliver, rest_)) {
                any = true;
                fragments_[i] = fragments_.back();
                fragments_.pop_back();
            } else {
                ++i;
            }
        }
        if (!any)
            continue;
        fragments_.insert(fragments_.end(), rest_.begin(), rest_.end());
        if (fragments_.size() == first_fragment) {
            // The pair that covers this cell may well cover its siblings: they try it first.
            for (std::size_t i = parent_pair; i < cell.first_pair; ++i) {
                if (pairs_[i].moving == pair.moving && pairs_[i].fixed == pair.fixed) {
                    std::swap(pairs_[i], pairs_[parent_pair]);
                    break;
                }
            }
            cell.fragments = 0;
            return true;
        }
        std::swap(pairs_[p], pairs_[useful++]);
        cell.box.makeEmpty();
        for (std::size_t i = first_fragment; i < fragments_.size(); ++i)
            cell.box.extendBy(fragments_[i].box());
    }
    cell.fragments = fragments_.size() - first_fragment;
    return false;
}

/// Subtracts what the elements cover that were placed after the pairs were listed.
bool SaturationSearch::cover_new(Cell& cell, std::size_t first_fragment) {
    const std::size_t from = pairs_.size();
    for (std::size_t n = cell.neighbours; n < neighbours_.size(); ++n)
        add_pairs(pieces_of_[n], neighbours_[n].dart.margin);
    cell.neighbours = neighbours_.size();
    return is_covered(cell, first_fragment, from, cell.first_pair);
}

SaturationSearch::Extent SaturationSearch::extent(const Cell& cell) const {
    const double radius = problem_.shapes[component_].turn_radius;
    const Imath::V2f size = cell.box.size();
    Extent result{radius * cell.high * cell.half_angle, radius * (cell.high - cell.low) / 2,
                  0.5 * std::max(size.x, size.y), 0};
    const LayoutFields& fields = layout_.fields;
    if (fields.direction || fields.scale || fields.density || fields.classes) {
        const Box2 box = world(cell.box);
        const auto width = [](const Range& range) { return range.high - range.low; };
        if (!is_turned_freely_)
            result.fields += radius * cell.high * std::min(pi, width(layout_.direction_over(box)));
        const Range scales = layout_.scale_over(box);
        result.fields += radius * layout_.scale.high * width(scales);
        if (!layout_.margins.empty()) {
            const Range density = layout_.density_over(box);
            result.fields += layout_.margins[component_] * layout_.scale.high *
                             (scales.high * density.high - scales.low * density.low);
        }
        if (fields.classes && width(fields.classes->over(box)) > 0)
            result.fields += result.place;
    }
    return result;
}

Box2 SaturationSearch::world(const Imath::Box2f& box) const {
    return {centre_ + Vec2(box.min), centre_ + Vec2(box.max)};
}

void SaturationSearch::split(const Cell& cell, std::size_t first_fragment, const Extent& wide) {
    const std::size_t end = fragments_.size();
    const bool first_half = (random_.bits() & 1U) != 0;
    // No-fit polygons are exact in position, so that splitting an area only makes its neighbours
    // fewer: wide areas are split late. What fields change from place to place needs the split.
    const double place = std::max(wide.place / problem_.place_share,
                                  wide.fields > 0.5 * problem_.smallest_extent ? wide.fields : 0);
    const bool by_place = place > std::max(wide.turn, wide.scale);
    for (const bool low_half : {first_half, !first_half}) {
        Cell child = cell;
        ++child.depth;
        if (by_place) {
            const Vec2f size = cell.box.size(), middle = cell.box.center();
            const float side = low_half ? 1.0F : -1.0F;
            const bool along_x = size.x > size.y;
            const float nx = along_x ? side : 0, ny = along_x ? 0 : side;
            const float offset = nx * middle.x + ny * middle.y;
            for (std::size_t i = first_fragment; i < end; ++i) {
                const Fragment part = part_of(Fragment(fragments_[i]), nx, ny, offset);
                if (part.count >= 3)
                    fragments_.push_back(part);
            }
        } else {
            for (std::size_t i = first_fragment; i < end; ++i)
                fragments_.push_back(Fragment(fragments_[i]));
            if (wide.turn >= wide.scale) {
                child.half_angle /= 2;
                child.angle += low_half ? -child.half_angle : child.half_angle;
            } else {
                const double middle = (cell.low + cell.high) / 2;
                (low_half ? child.high : child.low) = middle;
            }
        }
        child.fragments = fragments_.size() - end;
        examine(child, cell.first_pair, cell.neighbours);
    }
}

} // namespace scree
