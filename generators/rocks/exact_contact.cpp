// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/exact_contact.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace scree::rocks {

namespace {

/// The height changes by less than this share of a metre for each metre; steeper triangles are
/// seen as lines from above.
constexpr double steepest = 1e4;

Imath::Box2f seen_from_above(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
    const auto [low_z, high_z] = std::minmax({a.z, b.z, c.z});
    return {Vec2f(low_x, low_z), Vec2f(high_x, high_z)};
}

bool is_upright(const WideVec3& normal) {
    return std::abs(normal.y) * steepest <= std::max(std::abs(normal.x), std::abs(normal.z));
}

} // namespace

ExactContact::Plan::Plan(const Vec3& a, const Vec3& b, const Vec3& c)
    : corners{WideVec3(a), WideVec3(b), WideVec3(c)}, low(std::min({a.y, b.y, c.y})),
      high(std::max({a.y, b.y, c.y})), box(seen_from_above(a, b, c)) {
    const WideVec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (normal.y != 0) {
        slope_x = -normal.x / normal.y;
        slope_z = -normal.z / normal.y;
    }
    if (normal.y > 0)
        std::swap(corners[1], corners[2]);
}

/// What two triangles have in common from above (Sutherland & Hodgman 1974), with what its corners
/// come from.
struct ExactContact::CommonArea {
    struct Corner {
        Vec2 place;
        int side = 0;  // that begins here: 0 to 2 of the first triangle, 3 to 5 of the second
        int other = 0; // that ends here
    };

    CommonArea(const Plan& a, const Plan& b) {
        for (int i = 0; i < 3; ++i) {
            const WideVec3& p = a.corners[std::size_t(i)];
            corners[std::size_t(i)] = {{p.x, p.z}, i, (i + 2) % 3};
        }
        count = 3;
        for (int i = 0; i < 3 && count > 0; ++i) {
            const WideVec3& p = b.corners[std::size_t(i)];
            const WideVec3& q = b.corners[std::size_t((i + 1) % 3)];
            clip({p.x, p.z}, {q.x, q.z}, 3 + i);
        }
    }

    void clip(const Vec2& from, const Vec2& to, int line) {
        const std::array<Corner, 9> before = corners;
        const std::size_t had = count;
        count = 0;
        const Vec2 along = to - from;
        double at_p = cross(along, before[0].place - from);
        for (std::size_t i = 0; i < had; ++i) {
            const Corner& p = before[i];
            const Corner& q = before[(i + 1) % had];
            const double at_q = cross(along, q.place - from);
            if (at_p >= 0)
                corners[count++] = p;
            if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
                const Vec2 place = p.place + (q.place - p.place) * (at_p / (at_p - at_q));
                corners[count++] =
                    at_p > 0 ? Corner{place, line, p.side} : Corner{place, p.side, line};
            }
            at_p = at_q;
        }
    }

    std::array<Corner, 9> corners;
    std::size_t count = 0;
};

template <class Visit>
void ExactContact::each_near(const HeldRock& rock, double cell, const Imath::Box2f& box,
                             const Visit& visit) const {
    if (!box.intersects(near_box_))
        return;
    const auto per_cell = static_cast<float>(1 / cell);
    const auto cell_of = [&](float x) { return nearest_cell(x * per_cell); };
    const Footprint& under = rock.under;
    const int first_x = std::max(cell_of(box.min.x) - under.first_x, 0);
    const int last_x = std::min(cell_of(box.max.x) - under.first_x, under.width - 1);
    const int last_z = std::min(cell_of(box.max.y) - under.first_z, under.depth - 1);
    for (int j = std::max(cell_of(box.min.y) - under.first_z, 0); j <= last_z; ++j)
        for (int i = first_x; i <= last_x; ++i)
            if (const auto k = std::size_t(j) * std::size_t(under.width) + std::size_t(i);
                near_[k] != 0)
                visit(k);
}

void ExactContact::mark(const HeldRock& rock, const Neighbourhood& around, double margin) {
    const Footprint& under = rock.under;
    const double cell = around.map.cell();
    near_.assign(under.heights.size(), 0);
    near_box_.makeEmpty();
    near_ground_ = false;
    others_.clear();
    around.map.each_under(
        under, rock.column, rock.row, rock.sink, [&](std::size_t k, int x, int z, float below) {
            if (rock.height + double(under.heights[k]) - double(below) > margin)
                return;
            near_[k] = 1;
            const Vec2 middle = Vec2(x - rock.column, z - rock.row) * cell;
            near_box_.extendBy(Vec2f(middle - Vec2(cell / 2)));
            near_box_.extendBy(Vec2f(middle + Vec2(cell / 2)));
            // A neighbouring cell may show a rock that is hidden in this one.
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) {
                    const std::uint32_t other = around.map.rock(x + i, z + j);
                    if (other != HeightMap::no_rock && (others_.empty() || others_.back() != other))
                        others_.push_back(other);
                }
            near_ground_ = true;
        });
    std::sort(others_.begin(), others_.end());
    others_.erase(std::unique(others_.begin(), others_.end()), others_.end());
    under_.clear();
    links_.clear();
    first_.assign(under.heights.size(), -1);
    for (const Mesh::Triangle& t : rock.triangles) {
        const Vec3& a = rock.vertices[t[0]];
        const Vec3& b = rock.vertices[t[1]];
        const Vec3& c = rock.vertices[t[2]];
        if ((b - a).cross(c - a).y >= 0)
            continue;
        const auto number = static_cast<std::uint32_t>(under_.size());
        bool is_near = false;
        each_near(rock, cell, seen_from_above(a, b, c), [&](std::size_t k) {
            is_near = true;
            links_.push_back({number, first_[k]});
            first_[k] = static_cast<std::int32_t>(links_.size()) - 1;
        });
        if (is_near)
            under_.emplace_back(a, b, c);
    }
    met_.assign(under_.size(), 0);
    tops_ = 0;
}

void ExactContact::add_gap(const Vec2& place, double under, double height, const WideVec3& normal) {
    least_ = std::min(least_, height);
    if (height > least_ + more_)
        return;
    const WideVec3 up = normal.y < 0 ? -normal : normal;
    const double steep = is_upright(up) ? 0 : under / up.y;
    const Vec2 at = place - offset_;
    gaps_.push_back({.x = at.x - steep * up.x,
                     .z = at.y - steep * up.z,
                     .height = height,
                     .arm = {at.x, under, at.y},
                     .normal = up.normalized()});
}

void ExactContact::add_top(const HeldRock& rock, double cell, const Vec3& a, const Vec3& b,
                           const Vec3& c) {
    ++tops_;
    std::optional<Plan> top; // made for the first triangle that it may meet
    each_near(rock, cell, seen_from_above(a, b, c), [&](std::size_t k) {
        for (std::int32_t link = first_[k]; link >= 0; link = links_[std::size_t(link)].next) {
            const std::uint32_t number = links_[std::size_t(link)].triangle;
            if (std::exchange(met_[number], tops_) == tops_)
                continue;
            if (!top)
                top.emplace(a, b, c);
            add_pair(under_[number], *top);
        }
    });
}

void ExactContact::add_pair(const Plan& under, const Plan& top) {
    if (double(under.low - top.high) > least_ + more_ || !under.box.intersects(top.box))
        return;
    const auto side = [](const Plan& plan, int i) {
        return plan.corners[std::size_t((i + 1) % 3)] - plan.corners[std::size_t(i)];
    };
    const CommonArea common(under, top);
    for (std::size_t i = 0; i < common.count; ++i) {
        const CommonArea::Corner& corner = common.corners[i];
        const Vec2& at = corner.place;
        const double height = under.height(at.x, at.y);
        // A corner of the underside touches a face, a face a corner of the top, or two edges.
        const bool of_under = corner.side < 3 && corner.other < 3;
        const bool of_top = corner.side >= 3 && corner.other >= 3;
        const WideVec3 normal =
            of_under ? WideVec3(-top.slope_x, 1, -top.slope_z)
            : of_top ? WideVec3(-under.slope_x, 1, -under.slope_z)
                     : side(under, std::min(corner.side, corner.other))
                           .cross(side(top, std::max(corner.side, corner.other) - 3));
        add_gap(at, height, height - top.height(at.x, at.y), normal);
    }
}

void ExactContact::add_rock(const HeldRock& rock, const Neighbourhood& around, std::uint32_t other,
                            const WideVec3& centre) {
    const PlacedRock& placed = around.rocks[other];
    const RockSurface& surface = around.surfaces[placed.surface];
    const double cell = around.map.cell();
    const Vec3 offset(placed.centre - centre);
    if (const TopGrid* grid = around.tops[other].get()) {
        const Vec2f shift(offset.x, offset.z);
        grid->each_in({near_box_.min - shift, near_box_.max - shift},
                      [&](const Vec3& a, const Vec3& b, const Vec3& c) {
                          add_top(rock, cell, a + offset, b + offset, c + offset);
                      });
        return;
    }
    pose_vertices(surface, placed.world_from_rock, placed.scale, posed_);
    for (Vec3& v : posed_)
        v += offset;
    for (const Mesh::Triangle& t : surface.triangles) {
        const Vec3& a = posed_[t[0]];
        const Vec3& b = posed_[t[1]];
        const Vec3& c = posed_[t[2]];
        if ((b - a).cross(c - a).y > 0)
            add_top(rock, cell, a, b, c);
    }
}

void ExactContact::add_ground(const HeldRock& rock, const Neighbourhood& around,
                              const Vec2& centre) {
    if (const TopGrid* grid = around.ground.mesh()) {
        const Vec3 offset(static_cast<float>(-centre.x),
                          static_cast<float>(-rock.height - rock.sink),
                          static_cast<float>(-centre.y));
        const Vec2f shift(offset.x, offset.z);
        grid->each_in({near_box_.min - shift, near_box_.max - shift},
                      [&](const Vec3& a, const Vec3& b, const Vec3& c) {
                          add_top(rock, around.map.cell(), a + offset, b + offset, c + offset);
                      });
        return;
    }
    const WideVec3 normal(0, 1, around.ground.rise());
    for (const Plan& under : under_)
        for (const WideVec3& p : under.corners) {
            const Vec2 at(p.x, p.z);
            const double ground = around.ground.height(centre + at) - rock.sink;
            add_gap(at, p.y, rock.height + p.y - ground, normal);
        }
}

const std::vector<Gap>& ExactContact::gaps(const HeldRock& rock, const Neighbourhood& around,
                                           double margin, double more) {
    mark(rock, around, margin);
    gaps_.clear();
    offset_ = rock.offset;
    least_ = margin;
    more_ = more;
    const Vec2 place = around.map.place(rock.column, rock.row);
    const WideVec3 centre(place.x, rock.height, place.y);
    for (const std::uint32_t other : others_)
        add_rock(rock, around, other, centre);
    if (near_ground_)
        add_ground(rock, around, place);
    return gaps_;
}

} // namespace scree::rocks
