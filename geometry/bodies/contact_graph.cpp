// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/contact_graph.h"

#include "core/parallel.h"
#include "geometry/bodies/mass_properties.h"
#include "geometry/bodies/target_contact.h"
#include "geometry/plane/convex_hull.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

// The upward part from which on a normal counts as pushing upwards: the sine of 6 degrees, more
// than the interpolated gradient has at an upright face.
constexpr float least_upward = 0.1F;

Vec2 ground(const Vec3d& p) { return {p.x, p.z}; }

/// Two bodies that may touch, i the one with the lower number.
struct PairContact {
    std::uint32_t j = 0;
    bool touching = false;
    std::vector<Vec2> under_i; // (x, z) where j holds i up [m]
    std::vector<Vec2> under_j; // and i holds j up
};

class ContactFinder {
  public:
    ContactFinder(const PlacedBodies& bodies, double tolerance)
        : bodies_(bodies), tolerance_(tolerance) {
        for (const auto& body : bodies.shapes)
            mass_centres_.push_back(mass_properties(*body).centre);
    }

    Vec2 mass_centre_of(const PlacedBody& placed) const {
        const Vec3& local = mass_centres_[placed.body];
        return ground(placed.pose.centre + Vec3d(local * placed.pose.world_from_body));
    }

    PairContact between(std::uint32_t i, std::uint32_t j) const {
        const PlacedBody& a = bodies_.all[i];
        const PlacedBody& b = bodies_.all[j];
        PairContact contact;
        contact.j = j;
        probe(a, b, contact, contact.under_i, contact.under_j);
        probe(b, a, contact, contact.under_j, contact.under_i);
        contact.under_i = convex_hull(std::move(contact.under_i));
        contact.under_j = convex_hull(std::move(contact.under_j));
        return contact;
    }

    std::vector<Vec2> on_floor(const PlacedBody& placed, double floor) const {
        const Body& body = bodies_.body(placed);
        std::vector<Vec2> points;
        each_world_sample(placed, floor + body.skin + tolerance_ * body.radius,
                          [&](const Vec3d& p) { points.push_back(ground(p)); });
        return convex_hull(std::move(points));
    }

  private:
    // Looks up a's samples in b's distance; b pushes a along the gradient.
    void probe(const PlacedBody& a, const PlacedBody& b, PairContact& contact,
               std::vector<Vec2>& under_a, std::vector<Vec2>& under_b) const {
        const Body& own = bodies_.body(a);
        const Body& other = bodies_.body(b);
        const RelativePose there = relative(a.pose, b.pose);
        const double gap = own.skin + tolerance_ * std::min(own.radius, other.radius);
        const auto distance = [&](const Vec3& p) { return other.distance.at(there(p)); };
        own.samples.each_within(distance, static_cast<float>(gap), [&](const Vec3& p) {
            Vec3 gradient;
            other.distance.at(there(p), gradient);
            contact.touching = true;
            const float up = (gradient.normalized() * b.pose.world_from_body).y;
            const Vec2 at = ground(a.pose.centre + Vec3d(p * a.pose.world_from_body));
            if (up > least_upward)
                under_a.push_back(at);
            else if (up < -least_upward)
                under_b.push_back(at);
        });
    }

    template <class Found>
    void each_world_sample(const PlacedBody& placed, double below, const Found& found) const {
        const Imath::M33f& m = placed.pose.world_from_body;
        const auto height = [&](const Vec3& p) {
            return static_cast<float>(placed.pose.centre.y - below) + (p * m).y;
        };
        bodies_.body(placed).samples.each_within(
            height, 0, [&](const Vec3& p) { found(placed.pose.centre + Vec3d(p * m)); });
    }

    const PlacedBodies& bodies_;
    double tolerance_;
    std::vector<Vec3> mass_centres_; // of each shape, in its own frame
};

void centre_on(const Vec2& centre, std::vector<Vec2>& points) {
    for (Vec2& p : points)
        p -= centre;
}

} // namespace

ContactGraph contact_graph(const PlacedBodies& bodies, const ContactSettings& settings) {
    const ContactFinder finder(bodies, settings.tolerance);
    const std::size_t count = bodies.all.size();
    std::vector<std::vector<PairContact>> pairs(count);
    ContactGraph graph;
    graph.contacts.resize(count);
    graph.floor.resize(count);
    graph.anchored = settings.adhesive != nullptr
                         ? touching_target(bodies, *settings.adhesive, settings.tolerance)
                         : std::vector<char>(count, 0);
    parallel_for(count, 8, [&](std::size_t n) {
        const auto i = static_cast<std::uint32_t>(n);
        const PlacedBody& placed = bodies.all[i];
        const Body& own = bodies.body(placed);
        const double reach = own.reach + settings.tolerance * own.radius;
        std::vector<std::uint32_t> near;
        bodies.hash.near(placed.pose.centre, reach, [&](std::uint32_t j) {
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
            centre_on(finder.mass_centre_of(bodies.all[i]), pair.under_i);
            centre_on(finder.mass_centre_of(bodies.all[pair.j]), pair.under_j);
            graph.contacts[i].push_back({pair.j, std::move(pair.under_i)});
            graph.contacts[pair.j].push_back({i, std::move(pair.under_j)});
        }
    }
    return graph;
}

double lowest_point(const PlacedBodies& bodies) {
    double lowest = std::numeric_limits<double>::max();
    for (const PlacedBody& placed : bodies.all) {
        const Body& body = bodies.body(placed);
        const auto height = [&](const Vec3& p) { return (p * placed.pose.world_from_body).y; };
        const double below =
            double(body.samples.depth_where(height, -static_cast<float>(body.reach)));
        lowest = std::min(lowest, placed.pose.centre.y - below - body.skin);
    }
    return lowest;
}

} // namespace scree
