// SPDX-License-Identifier: GPL-3.0-or-later
// mesh.lathe: the surface of revolution of a profile about the y axis.
#include "geometry/plane/region_tools.h"
#include "shapes/mesh/component.h"
#include "shapes/mesh/loft.h"
#include "shapes/mesh/spline.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace scree {

namespace {

// A pot: from the foot up its outside, over the lip and down its inside. The repeated point is a
// sharp edge.
const std::vector<Vec2> pot_profile = {
    {0, 0.004},     {0.030, 0.004}, {0.030, 0.004}, {0.032, 0},     {0.036, 0},
    {0.038, 0.006}, {0.056, 0.040}, {0.064, 0.078}, {0.052, 0.118}, {0.034, 0.140},
    {0.032, 0.152}, {0.042, 0.166}, {0.040, 0.169}, {0.029, 0.153}, {0.030, 0.139},
    {0.047, 0.116}, {0.059, 0.078}, {0.051, 0.042}, {0.030, 0.014}, {0, 0.010}};

constexpr std::size_t max_triangles = 10'000'000;

std::string text_of(const Vec2& p) { return fmt::format("({:.3g}, {:.3g})", p.x, p.y); }

void check_points(const Params& params, const std::vector<Vec2>& points, bool closed) {
    const auto different = [&] {
        std::vector<Vec2> kept = points;
        kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
        if (closed && kept.size() > 1 && kept.front() == kept.back())
            kept.pop_back();
        return kept.size();
    }();
    const std::size_t least = closed ? 3 : 2;
    if (different < least)
        throw params.error(
            "profile", fmt::format("needs at least {} different points, got {}", least, different));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool end = !closed && (points[i] == points.front() || points[i] == points.back());
        if (points[i].x < 0)
            throw params.error("profile", fmt::format("point {} has the radius {}; it must not be "
                                                      "below 0",
                                                      i + 1, points[i].x));
        if (points[i].x == 0 && !end)
            throw params.error("profile", fmt::format("point {} lies on the axis; {}", i + 1,
                                                      closed ? "a closed profile stays away from it"
                                                             : "only the ends may"));
    }
}

// Closes ends that are not on the axis by discs.
void add_discs(std::vector<CurvePiece>& pieces) {
    const Vec2 first = pieces.front().front().at;
    const Vec2 last = pieces.back().back().at;
    if (first.x > 0)
        pieces.insert(pieces.begin(), {{{0, first.y}, {1, 0}}, {first, {1, 0}}});
    if (last.x > 0)
        pieces.push_back({{last, {-1, 0}}, {{0, last.y}, {-1, 0}}});
}

// The whole curve as a polygon; an open curve is closed along the axis.
Ring outline_of(const std::vector<CurvePiece>& pieces) {
    Ring ring;
    for (const CurvePiece& piece : pieces)
        for (const CurvePoint& point : piece)
            if (ring.empty() || point.at != ring.back())
                ring.push_back(point.at);
    if (ring.front() == ring.back())
        ring.pop_back();
    return ring;
}

// Where two edges of a ring meet that should not; edges are called by their first points.
struct Contact {
    std::size_t first = 0;
    std::size_t second = 0;
    Vec2 at;
};

// Where the lines through two edges cross; a point of the second when they are parallel.
Vec2 crossing(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
    const double turn = cross(b - a, q - p);
    return turn == 0 ? p : a + (b - a) * (cross(p - a, q - p) / turn);
}

// Finds where a ring that is not a simple polygon meets itself, up to rounding.
std::optional<Contact> self_contact(const Ring& ring) {
    const std::size_t n = ring.size();
    const auto parts = [&](const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
        return cross(b - a, p - a) * cross(b - a, q - a) <= 0;
    };
    const auto box = [](const Vec2& a, const Vec2& b) {
        Box2 out(a);
        out.extendBy(b);
        return out;
    };
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 &a = ring[i], &b = ring[(i + 1) % n];
        const Vec2 next = ring[(i + 2) % n] - b;
        if (cross(b - a, next) == 0 && (b - a).dot(next) < 0)
            return Contact{i, (i + 1) % n, b};
        for (std::size_t j = i + 2; j < n && j < i + n - 1; ++j) {
            const Vec2 &p = ring[j], &q = ring[(j + 1) % n];
            if (parts(a, b, p, q) && parts(p, q, a, b) && box(a, b).intersects(box(p, q)))
                return Contact{i, j, crossing(a, b, p, q)};
        }
    }
    return {};
}

// Tells the edges of the outline by the points of the profile.
class Parts {
  public:
    Parts(const Ring& ring, const std::vector<Vec2>& points, bool closed)
        : numbers_(ring.size()), count_(points.size()), closed_(closed) {
        // The outline of a closed profile may begin at a later point, that of an open one on the
        // axis.
        const auto begin = std::ranges::find(points, ring.front());
        std::size_t at = closed && begin != points.end() ? std::size_t(begin - points.begin()) : 0;
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (ring[i] == points[at % count_]) {
                numbers_[i] = at % count_ + 1;
                while (at < 2 * count_ && points[at % count_] == ring[i])
                    ++at;
            }
    }

    // "from point 2 to 3"
    std::string text(std::size_t edge) const {
        const std::size_t n = numbers_.size();
        std::size_t from = edge;
        while (numbers_[from] == 0 && (from > 0 || closed_))
            from = (from + n - 1) % n;
        std::size_t to = edge + 1;
        while (to < (closed_ ? 2 * n : n) && numbers_[to % n] == 0)
            ++to;
        if (!closed_ && edge + 1 == n)
            return "on the axis";
        if (!closed_ && numbers_[from] == 0)
            return "in the disc at point 1";
        if (!closed_ && to == n)
            return fmt::format("in the disc at point {}", count_);
        return fmt::format("from point {} to {}", numbers_[from], numbers_[to % n]);
    }

  private:
    std::vector<std::size_t> numbers_; // of the profile's points in the ring; 0: between them
    std::size_t count_;
    bool closed_;
};

void check_curve(const Params& params, const Ring& ring, const std::vector<Vec2>& points) {
    const auto segments = static_cast<std::size_t>(params.integer("segments"));
    if (2 * ring.size() * segments > max_triangles)
        throw params.error("profile",
                           fmt::format("gives a mesh of {} triangles; at most {} are made",
                                       2 * ring.size() * segments, max_triangles),
                           "fewer steps or segments help");
    for (const Vec2& p : ring)
        if (p.x < 0)
            throw params.error("profile", "the curve swings over the axis near " + text_of(p),
                               "a point written twice is a corner, before which it swings less");
    try {
        triangulate({ring});
    } catch (const Error&) {
        std::string where;
        if (const auto contact = self_contact(ring)) {
            const Parts parts(ring, points, params.flag("closed"));
            where = fmt::format(" near {}: {} and {}", text_of(contact->at),
                                parts.text(contact->first), parts.text(contact->second));
        }
        throw params.error("profile", "the curve crosses or touches itself" + where);
    }
}

// Reverses the curve; called when the inside lies to its right, since triangles face outwards when
// the inside is to the left.
void reverse_curve(std::vector<CurvePiece>& pieces) {
    std::reverse(pieces.begin(), pieces.end());
    for (CurvePiece& piece : pieces) {
        std::reverse(piece.begin(), piece.end());
        for (CurvePoint& point : piece)
            point.tangent = -point.tangent;
    }
}

double length_of(const CurvePiece& piece) {
    double sum = 0;
    for (std::size_t i = 1; i < piece.size(); ++i)
        sum += (piece[i].at - piece[i - 1].at).length();
    return sum;
}

// The surface of revolution of a piece; v runs from `v_begin` to `v_end` by arc length.
Mesh revolve_piece(const CurvePiece& piece, int segments, double v_begin, double v_end) {
    Ring profile;
    for (const CurvePoint& point : piece)
        profile.push_back(point.at);
    Mesh mesh = revolve(profile, segments);
    const std::vector<double> angles = equal_angles(segments);
    for (const CurvePoint& point : piece) {
        const Vec2 out = Vec2(point.tangent.y, -point.tangent.x).normalized();
        for (int i = 0; i <= segments; ++i) {
            const double angle = angles[static_cast<std::size_t>(i % segments)];
            mesh.normals.emplace_back(static_cast<float>(out.x * std::cos(angle)),
                                      static_cast<float>(out.y),
                                      static_cast<float>(-out.x * std::sin(angle)));
        }
    }
    for (Vec2f& uv : mesh.uvs)
        uv.y = static_cast<float>(v_begin + (v_end - v_begin) * double(uv.y));
    return mesh;
}

Mesh lathe(const Params& params) {
    const std::vector<Vec2>& points =
        params.has("profile") ? params.points("profile") : pot_profile;
    const bool closed = params.flag("closed");
    check_points(params, points, closed);
    std::vector<CurvePiece> pieces = params.flag("spline")
                                         ? spline(points, closed, int(params.integer("steps")))
                                         : polyline(points, closed);
    if (!closed)
        add_discs(pieces);
    const auto segments = static_cast<int>(params.integer("segments"));
    const Ring ring = outline_of(pieces);
    check_curve(params, ring, points);
    if (signed_area(ring) < 0)
        reverse_curve(pieces);

    double whole = 0;
    for (const CurvePiece& piece : pieces)
        whole += length_of(piece);
    Mesh mesh;
    double way = 0;
    for (const CurvePiece& piece : pieces) {
        const double next = way + length_of(piece);
        append(mesh, revolve_piece(piece, segments, way / whole, next / whole));
        way = next;
    }
    if (params.has("height")) {
        const float factor = static_cast<float>(params.number("height")) / bounds(mesh).size().y;
        for (Vec3& p : mesh.positions)
            p *= factor;
    }
    return mesh;
}

} // namespace

Plugin<MakeMesh> lathe_component() {
    return component(
        "lathe", "A turned piece: what a profile sweeps about the y axis.",
        {{.name = "profile",
          .type = ParamType::points,
          .doc =
              "The outline; a point written twice is a corner. A pot when not given. Ends that are "
              "not on the axis are closed by discs.",
          .unit = "m",
          .optional = true,
          .pair = "{radius, height}",
          .min_items = 2},
         {.name = "closed",
          .type = ParamType::boolean,
          .doc = "Joins the last point to the first: a ring around the axis.",
          .fallback = false},
         {.name = "spline",
          .type = ParamType::boolean,
          .doc = "A smooth curve through the points (Catmull & Rom 1974); otherwise straight "
                 "lines with sharp edges.",
          .fallback = true},
         count("steps", "Steps of the curve from point to point.", 8, 1, 100),
         count("segments", "Segments around the axis.", 64, 12, 1024),
         optional_metres("height", "Height of the whole, to which it is scaled; as the profile "
                                   "says unless given.")},
        lathe);
}

} // namespace scree
