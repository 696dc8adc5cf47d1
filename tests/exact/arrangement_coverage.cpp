// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/box_grid.h"
#include "tests/exact/coverage.h"

#include <CGAL/Exact_rational.h>

#include <cstdint>

namespace scree::tests {

namespace {

using Exact = CGAL::Exact_rational;

/// A vertex of the arrangement. All have the form (x + u sqrt(s), y + v sqrt(s)) with rational x,
/// y, u, v, s.
struct Vertex {
    Exact x, u, y, v, s;
};

/// The sign of a + b sqrt(s).
int sign(const Exact& a, const Exact& b, const Exact& s) {
    const int of_a = CGAL::sign(a);
    const int of_b = CGAL::sign(s) == 0 ? 0 : static_cast<int>(CGAL::sign(b));
    if (of_a == of_b || of_b == 0)
        return of_a;
    if (of_a == 0)
        return of_b;
    return of_a * static_cast<int>(CGAL::sign(a * a - b * b * s));
}

bool strictly_inside(const Vertex& p, const Disk& disk) {
    const Exact x = p.x - Exact(disk.centre.x);
    const Exact y = p.y - Exact(disk.centre.y);
    const Exact r(disk.radius);
    return sign(x * x + y * y + (p.u * p.u + p.v * p.v) * p.s - r * r, 2 * (x * p.u + y * p.v),
                p.s) < 0;
}

/// Where circle `a` crosses circle `b`; `side` is 1 or -1.
Vertex crossing(const Disk& a, const Disk& b, int side) {
    const Exact x = Exact(b.centre.x) - Exact(a.centre.x);
    const Exact y = Exact(b.centre.y) - Exact(a.centre.y);
    const Exact squared = x * x + y * y;
    const Exact r2 = Exact(a.radius) * Exact(a.radius);
    const Exact along = (squared + r2 - Exact(b.radius) * Exact(b.radius)) / (2 * squared);
    return {Exact(a.centre.x) + along * x, -y * side, Exact(a.centre.y) + along * y, x * side,
            r2 / squared - along * along};
}

/// Where the line through two points crosses a circle.
Vertex crossing(const Disk& disk, const Vec2& from, const Vec2& to, int side) {
    const Exact x = Exact(to.x) - Exact(from.x);
    const Exact y = Exact(to.y) - Exact(from.y);
    const Exact fx = Exact(from.x) - Exact(disk.centre.x);
    const Exact fy = Exact(from.y) - Exact(disk.centre.y);
    const Exact length2 = x * x + y * y;
    const Exact half = x * fx + y * fy;
    const Exact r(disk.radius);
    return {Exact(from.x) - x * half / length2, x * side / length2,
            Exact(from.y) - y * half / length2, y * side / length2,
            half * half - length2 * (fx * fx + fy * fy - r * r)};
}

Vertex plain(const Vec2& p) { return {Exact(p.x), Exact(0), Exact(p.y), Exact(0), Exact(0)}; }

Vec2 nearby(const Vertex& p) {
    const double root = std::sqrt(CGAL::to_double(p.s));
    return {CGAL::to_double(p.x) + CGAL::to_double(p.u) * root,
            CGAL::to_double(p.y) + CGAL::to_double(p.v) * root};
}

class Arrangement {
  public:
    Arrangement(const std::vector<Disk>& disks, const Region& domain, bool torus)
        : disks_(disks), domain_(domain), box_(bounds(domain)), torus_(torus),
          grid_(boxes_of(disks), frame_of(disks, box_), false) {}

    std::size_t bare_vertices() {
        for (std::uint32_t i = 0; i < disks_.size(); ++i) {
            test_point(disks_[i].centre + Vec2(disks_[i].radius, 0));
            test_crossings(i);
        }
        for (const Ring& ring : torus_ ? std::vector<Ring>{} : domain_.rings)
            for (std::size_t k = 0; k < ring.size(); ++k) {
                test_point(ring[k]);
                test_border(ring[k], ring[(k + 1) % ring.size()]);
            }
        return bare_;
    }

  private:
    // Error bound of double precision. The crossings of two nearly tangent circles are known only
    // to the square root of the rounding error.
    static constexpr double doubt = 1e-6;

    static std::vector<Box2> boxes_of(const std::vector<Disk>& disks) {
        std::vector<Box2> boxes;
        for (const Disk& disk : disks)
            boxes.emplace_back(disk.centre - Vec2(disk.radius), disk.centre + Vec2(disk.radius));
        return boxes;
    }
    static Box2 frame_of(const std::vector<Disk>& disks, Box2 box) {
        for (const Box2& each : boxes_of(disks))
            box.extendBy(each);
        return box;
    }

    bool in_domain(const Vec2& p) const {
        return torus_ ? box_.intersects(p) : signed_distance(domain_, p) <= 1e-12;
    }

    bool surely_covered(const Vec2& p) const {
        bool covered = false;
        grid_.visit_at(p, [&](std::uint32_t i, const Vec2&) {
            const double inner = disks_[i].radius * (1 - doubt);
            covered = covered || (p - disks_[i].centre).length2() < inner * inner;
        });
        return covered;
    }

    bool covered(const Vertex& vertex, const Vec2& near) const {
        bool covered = false;
        const Vec2 margin(box_.size() * doubt);
        grid_.visit_box({near - margin, near + margin}, [&](std::uint32_t i, const Vec2&) {
            covered = covered || strictly_inside(vertex, disks_[i]);
        });
        return covered;
    }

    void test(const Vertex& vertex) {
        const Vec2 near = nearby(vertex);
        if (in_domain(near) && !covered(vertex, near))
            ++bare_;
    }

    void test_point(const Vec2& point) {
        if (in_domain(point) && !surely_covered(point))
            test(plain(point));
    }

    void test_crossings(std::uint32_t i) {
        const Disk& a = disks_[i];
        grid_.visit_box(boxes_of({a})[0], [&](std::uint32_t j, const Vec2&) {
            if (j <= i)
                return;
            const Disk& b = disks_[j];
            const Vec2 offset = b.centre - a.centre;
            const double squared = offset.length2();
            const double along =
                (squared + a.radius * a.radius - b.radius * b.radius) / (2 * squared);
            const double across2 = a.radius * a.radius / squared - along * along;
            if (across2 < -doubt)
                return;
            const Vec2 foot = a.centre + offset * along;
            const Vec2 away = Vec2(-offset.y, offset.x) * std::sqrt(std::max(0.0, across2));
            for (const int side : {-1, 1}) {
                const Vec2 near = foot + away * side;
                // Only for nearly tangent circles can rounding exceed the domain's tolerance.
                const bool nearly_touch = across2 < doubt;
                if (!nearly_touch && (!in_domain(near) || surely_covered(near)))
                    continue;
                const Vertex vertex = crossing(a, b, side);
                if (CGAL::sign(vertex.s) >= 0)
                    test(vertex);
            }
        });
    }

    void test_border(const Vec2& from, const Vec2& to) {
        Box2 box;
        box.extendBy(from);
        box.extendBy(to);
        grid_.visit_box(box, [&](std::uint32_t i, const Vec2&) {
            for (const int side : {-1, 1}) {
                const Vertex vertex = crossing(disks_[i], from, to, side);
                if (CGAL::sign(vertex.s) < 0)
                    return;
                const Vec2 near = nearby(vertex);
                const double share = (near - from).dot(to - from) / (to - from).length2();
                // Ends outside [0, 1] are beyond the edge's corners.
                if (share >= 0 && share <= 1 && !surely_covered(near) && !covered(vertex, near))
                    ++bare_;
            }
        });
    }

    const std::vector<Disk>& disks_;
    const Region& domain_;
    Box2 box_;
    bool torus_;
    BoxGrid grid_;
    std::size_t bare_ = 0;
};

std::vector<Disk> with_images(const std::vector<Disk>& disks, const Box2& box) {
    std::vector<Disk> all;
    for (const Disk& disk : disks)
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y) {
                const Vec2 centre = disk.centre + Vec2(x * box.size().x, y * box.size().y);
                const Box2 wide(box.min - Vec2(disk.radius * 1.001),
                                box.max + Vec2(disk.radius * 1.001));
                if (wide.intersects(centre))
                    all.push_back({centre, disk.radius});
            }
    return all;
}

} // namespace

std::size_t bare_vertices(const std::vector<Disk>& disks, const Region& domain, bool torus) {
    const std::vector<Disk> all = torus ? with_images(disks, bounds(domain)) : disks;
    return Arrangement(all, domain, torus).bare_vertices();
}

} // namespace scree::tests
