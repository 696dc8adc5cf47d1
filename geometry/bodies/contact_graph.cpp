// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/contact_graph.h"

#include "core/parallel.h"
#include "geometry/bodies/target_contact.h"
#include "geometry/plane/convex_hull.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

// Upward part of the normal of what holds up: the sine of 6 degrees, above what the interpolated
// gradient of an upright face has.
constexpr float least_upward = 0.1F;

Vec2 ground(const Vec3d& p) { return {p.x, p.z}; }

/// Two components that may touch, i the one with the lower number.
struct PairContact {
    std::uint32_t j = 0;
    bool touching = false;
    std::vector<Vec2> under_i, under_j; // (x, z) where one holds the other up
};

class ContactFinder {
  public:
    ContactFinder(const Pile& pile, double tolerance) : pile_(pile), tolerance_(tolerance) {
        for (const PileKind& kind : pile.kinds) {
            const PileComponent& component = kind.component;
            mass_centres_.push_back(mass_centre(*component.prototype.mesh(), component.skin == 0) -
                                    Vec3d(component.origin));
        }
    }

    Vec2 mass_centre_of(const Placed& placed) const {
        const Vec3 local(mass_centres_[placed.kind]);
        return ground(placed.pose.centre + Vec3d(local * placed.pose.world_from_component));
    }

    PairContact between(std::uint32_t i, std::uint32_t j) const {
        const Placed& a = pile_.all[i];
        const Placed& b = pile_.all[j];
        PairContact contact;
        contact.j = j;
        probe(a, b, contact, contact.under_i, contact.under_j);
        probe(b, a, contact, contact.under_j, contact.under_i);
        contact.under_i = convex_hull(std::move(contact.under_i));
        contact.under_j = convex_hull(std::move(contact.under_j));
        return contact;
    }

    std::vector<Vec2> on_floor(const Placed& placed, double floor) const {
        const PileComponent& component = pile_.component(placed);
        std::vector<Vec2> points;
        each_world_sample(placed, floor + component.skin + tolerance_ * component.radius,
                          [&](const Vec3d& p) { points.push_back(ground(p)); });
        return convex_hull(std::move(points));
    }

  private:
    // a's samples in b's distance, whose gradient is the way in which b pushes a.
    void probe(const Placed& a, const Placed& b, PairContact& contact, std::vector<Vec2>& under_a,
               std::vector<Vec2>& under_b) const {
        const PileComponent& own = pile_.component(a);
        const PileComponent& other = pile_.component(b);
        const RelativePose there = relative(a.pose, b.pose);
        const double gap = own.skin + tolerance_ * std::min(own.radius, other.radius);
        const auto distance = [&](const Vec3& p) { return other.distance.at(there(p)); };
        own.samples.each_within(distance, static_cast<float>(gap), [&](const Vec3& p) {
            Vec3 gradient;
            other.distance.at(there(p), gradient);
            contact.touching = true;
            const float up = (gradient.normalized() * b.pose.world_from_component).y;
            const Vec2 at = ground(a.pose.centre + Vec3d(p * a.pose.world_from_component));
            if (up > least_upward)
                under_a.push_back(at);
            else if (up < -least_upward)
                under_b.push_back(at);
        });
    }

    template <class Found>
    void each_world_sample(const Placed& placed, double below, const Found& found) const {
        const Imath::M33f& m = placed.pose.world_from_component;
        const auto height = [&](const Vec3& p) {
            return static_cast<float>(placed.pose.centre.y - below) + (p * m).y;
        };
        pile_.component(placed).samples.each_within(
            height, 0, [&](const Vec3& p) { found(placed.pose.centre + Vec3d(p * m)); });
    }

    const Pile& pile_;
    double tolerance_;
    std::vector<Vec3d> mass_centres_; // by kind, in its own frame
};

void centre_on(const Vec2& centre, std::vector<Vec2>& points) {
    for (Vec2& p : points)
        p -= centre;
}

} // namespace

ContactGraph contact_graph(const Pile& pile, const ContactSettings& settings) {
    const ContactFinder finder(pile, settings.tolerance);
    const std::size_t count = pile.all.size();
    std::vector<std::vector<PairContact>> pairs(count);
    ContactGraph graph;
    graph.contacts.resize(count);
    graph.floor.resize(count);
    graph.anchored = settings.adhesive != nullptr
                         ? touching_target(pile, *settings.adhesive, settings.tolerance)
                         : std::vector<char>(count, 0);
    parallel_for(count, 8, [&](std::size_t n) {
        const auto i = static_cast<std::uint32_t>(n);
        const Placed& placed = pile.all[i];
        const PileComponent& own = pile.component(placed);
        const double reach = own.reach + settings.tolerance * own.radius;
        std::vector<std::uint32_t> near;
        pile.hash.near(placed.pose.centre, reach, [&](std::uint32_t j) {
            if (j > i)
                near.push_back(j);
        });
        std::sort(near.begin(), near.end());
        for (const std::uint32_t j : near) {
            PairContact contact = finder.between(i, j);
            if (contact.touching)
                pairs[i].push_back(std::move(contact));
        }
        if (settings.floor) {
            graph.floor[i] = finder.on_floor(placed, *settings.floor);
            centre_on(finder.mass_centre_of(placed), graph.floor[i]);
        }
    });
    for (std::uint32_t i = 0; i < count; ++i) {
        for (PairContact& pair : pairs[i]) {
            centre_on(finder.mass_centre_of(pile.all[i]), pair.under_i);
            centre_on(finder.mass_centre_of(pile.all[pair.j]), pair.under_j);
            graph.contacts[i].push_back({pair.j, std::move(pair.under_i)});
            graph.contacts[pair.j].push_back({i, std::move(pair.under_j)});
        }
    }
    return graph;
}

double lowest_point(const Pile& pile) {
    double lowest = std::numeric_limits<double>::max();
    for (const Placed& placed : pile.all) {
        const PileComponent& component = pile.component(placed);
        const auto height = [&](const Vec3& p) { return (p * placed.pose.world_from_component).y; };
        const double below =
            double(component.samples.depth_where(height, -static_cast<float>(component.reach)));
        lowest = std::min(lowest, placed.pose.centre.y - below - component.skin);
    }
    return lowest;
}

Vec3d mass_centre(const Mesh& mesh, bool closed) {
    Vec3d sum(0);
    double mass = 0;
    const Vec3d middle(bounds(mesh).center());
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Vec3d a = Vec3d(mesh.positions[t[0]]) - middle;
        const Vec3d b = Vec3d(mesh.positions[t[1]]) - middle;
        const Vec3d c = Vec3d(mesh.positions[t[2]]) - middle;
        const Vec3d twice_area = (b - a).cross(c - a);
        // A tetrahedron with its tip at the middle, or a triangle.
        const double m = closed ? a.dot(b.cross(c)) : twice_area.length();
        sum += (a + b + c) * (m / (closed ? 4 : 3));
        mass += m;
    }
    return middle + sum / mass;
}

} // namespace scree
