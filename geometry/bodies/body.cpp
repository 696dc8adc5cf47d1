// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/body.h"

#include "core/error.h"
#include "geometry/mesh/largest_ball.h"
#include "geometry/mesh/not_closed.h"
#include "geometry/sampling/surface_points.h"

#include <algorithm>

namespace scree {

namespace {

// All in shares of the largest inner ball's radius.
constexpr double grid_step = 0.08;       // interpolation is off by step^2 / 8 next to a ball
constexpr double probe_tolerance = 0.01; // by how much the probe's balls miss or pass the surface
constexpr double edge_spacing = 0.04;    // of points on sharp edges
constexpr double most_sample_spacing = 0.25;
constexpr double ball_tolerance = 0.1;

constexpr std::size_t most_grid_samples = std::size_t{1} << 22;
constexpr double sample_count = 2500;
constexpr double most_samples = 20000;
constexpr std::size_t most_balls = 30;
constexpr std::size_t most_probe_balls = 600;

std::vector<Ball> poles_of(const SurfacePoints& points, bool inside_out) {
    if (!inside_out)
        return inner_poles(points.positions, points.normals);
    std::vector<Vec3> turned;
    for (const Vec3& normal : points.normals)
        turned.push_back(-normal);
    return inner_poles(points.positions, turned);
}

Ball largest_ball(const Mesh& mesh, const std::vector<Ball>& poles) {
    const Ball start = largest_inside(mesh, poles);
    if (!(start.radius > 0))
        throw Error("the mesh encloses nothing");
    return climb_to_largest(mesh, start);
}

Mesh moved(const Mesh& mesh, const Vec3& origin) {
    Mesh out;
    out.triangles = mesh.triangles;
    for (const Vec3& p : mesh.positions)
        out.positions.push_back(p - origin);
    return out;
}

// The poles, made smaller by as much as the surface between the samples may reach into them. Those
// left with hardly any radius are dropped, and those that are not inside of the body: they come
// from where samples are too far apart.
std::vector<Ball> inscribed(std::vector<Ball> poles, const Body& body, double spacing) {
    const auto sag = [&](const Ball& ball) {
        return spacing * spacing / (8 * double(ball.radius));
    };
    std::erase_if(poles, [&](Ball& ball) {
        ball.centre -= body.origin;
        ball.radius = static_cast<float>(double(ball.radius) - sag(ball));
        // Interpolated across the medial axis, the distance is too small by up to half a cube's
        // diagonal.
        const double inside = -double(body.distance.at(ball.centre));
        return double(ball.radius) < 2 * probe_tolerance * body.radius ||
               double(ball.radius) > inside + 0.87 * body.distance.step();
    });
    return poles;
}

std::vector<Ball> points_as_balls(const std::vector<Vec3>& points, double radius = 0) {
    std::vector<Ball> balls;
    balls.reserve(points.size());
    for (const Vec3& p : points)
        balls.push_back({p, static_cast<float>(radius)});
    return balls;
}

void complete_sheet(Body& body) {
    const double thickness = 2 * body.skin;
    const Mesh own = moved(*body.mesh, body.origin);
    body.distance = SignedDistanceGrid(own, thickness / 2.5, thickness);
    std::vector<Vec3> points =
        surface_points(own, std::max(thickness / 2, spacing_for(own, most_samples))).positions;
    const std::vector<Vec3> border = edge_points(own, thickness / 2);
    points.insert(points.end(), border.begin(), border.end());
    body.balls = points_as_balls(points, thickness / 2);
    body.probe = BallTree(body.balls);
    body.samples = BallTree(points_as_balls(points));
}

BodyDraft draft_sheet(const std::shared_ptr<Body>& body, double thickness) {
    body->radius = thickness / 2;
    body->skin = thickness / 2;
    body->origin = bounds(*body->mesh).center();
    return {body, [body] { complete_sheet(*body); }};
}

/// Where the largest inner ball of a solid was found: samples of its surface and their poles.
struct InnerBalls {
    double spacing = 0; // of the samples [m]
    SurfacePoints points;
    std::vector<Ball> poles;
    Ball largest;
};

InnerBalls inner_balls(const Mesh& mesh) {
    const bool inside_out = volume(mesh) < 0;
    InnerBalls found;
    const auto look = [&](double spacing) {
        found.spacing = spacing;
        found.points = surface_points(mesh, spacing);
        found.poles = poles_of(found.points, inside_out);
        found.largest = largest_ball(mesh, found.poles);
    };
    look(spacing_for(mesh, sample_count));
    const double coarsest = most_sample_spacing * double(found.largest.radius);
    if (found.spacing > coarsest)
        look(std::max(coarsest, spacing_for(mesh, most_samples)));
    return found;
}

void complete_solid(Body& body, const InnerBalls& inner) {
    const Vec3 origin = body.origin;
    const Mesh own = moved(*body.mesh, origin);
    // The grid reaches one radius beyond the surface: as far as the centres of balls of touching
    // bodies of this size or smaller.
    body.distance =
        SignedDistanceGrid(own, grid_step * body.radius, 0, most_grid_samples, body.radius);
    std::vector<Ball> poles = inscribed(inner.poles, body, inner.spacing);
    poles.insert(poles.begin(), Ball{Vec3(0), inner.largest.radius});

    std::vector<Vec3> skin;
    for (const Vec3& p : inner.points.positions)
        skin.push_back(p - origin);
    std::vector<bool> reached;
    body.balls = covering_balls(poles, skin, ball_tolerance * body.radius, most_balls, reached);
    const std::vector<Vec3> edges =
        edge_points(own, std::max(edge_spacing * body.radius, spacing_for(own, most_samples)));
    skin.insert(skin.end(), edges.begin(), edges.end());
    std::vector<Ball> probe =
        covering_balls(poles, skin, probe_tolerance * body.radius, most_probe_balls, reached);
    for (std::size_t i = 0; i < skin.size(); ++i)
        if (!reached[i])
            probe.push_back({skin[i], 0});
    body.probe_fills = probe.empty() || probe.back().radius > 0;
    body.probe = BallTree(std::move(probe));
    for (const Ball& b : body.balls)
        skin.push_back(b.centre);
    body.samples = BallTree(points_as_balls(skin));
}

BodyDraft draft_solid(const std::shared_ptr<Body>& body) {
    InnerBalls inner = inner_balls(*body->mesh);
    body->radius = double(inner.largest.radius);
    body->origin = inner.largest.centre;
    return {body, [body, inner = std::move(inner)] { complete_solid(*body, inner); }};
}

} // namespace

void check_body(const Mesh& mesh, double thickness) {
    const MeshFacts facts = inspect(mesh);
    if (!facts.finite)
        throw Error("the mesh has numbers that are not finite");
    if (!(area(mesh) > 0))
        throw Error("the mesh has no area");
    if (thickness > 0 || facts.closed())
        return;
    throw Error({.where = {},
                 .path = {},
                 .message = not_closed(facts),
                 .hint = "expected a closed mesh, or sheet = true"});
}

BodyDraft draft_body(std::shared_ptr<const Mesh> mesh, double thickness) {
    check_body(*mesh, thickness);
    auto body = std::make_shared<Body>();
    body->mesh = std::move(mesh);
    BodyDraft draft = thickness > 0 ? draft_sheet(body, thickness) : draft_solid(body);
    for (const Vec3& p : body->mesh->positions)
        body->reach = std::max(body->reach, double((p - body->origin).length()));
    body->reach += thickness / 2;
    return draft;
}

std::shared_ptr<const Body> make_body(std::shared_ptr<const Mesh> mesh, double thickness) {
    const BodyDraft draft = draft_body(std::move(mesh), thickness);
    draft.complete();
    return draft.body;
}

} // namespace scree
