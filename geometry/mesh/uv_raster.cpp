// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/uv_raster.h"

#include "core/error.h"
#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>

namespace scree {

namespace {

using Vec3d = Imath::V3d;
using Corners = std::array<Vec2, 3>;

constexpr int band_rows = 16; // drawn by one thread at a time

// Beyond these a mesh's UVs are no map of a texture, and drawing them would take hours.
constexpr float farthest_uv = 1000;
constexpr double most_layers = 1000; // times the texture is covered

// Centres nearer than this to an edge lie in both of its triangles [texels].
constexpr double edge_width = 1e-3;

double doubled_area(const Corners& p) { return cross(p[1] - p[0], p[2] - p[0]); }

bool has_area(const Corners& p) { return doubled_area(p) != 0; }

int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

struct Rows {
    int first, last;
};

// Texel rows or columns whose inside meets [low, high].
Rows touched(double low, double high) {
    const int first = static_cast<int>(std::floor(low));
    return {first, std::max(first, static_cast<int>(std::ceil(high)) - 1)};
}

/// A triangle's edges as distances that are positive inside.
class Edges {
  public:
    explicit Edges(const Corners& p) {
        const double turn = doubled_area(p) > 0 ? 1 : -1;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 edge = p[(k + 1) % 3] - p[k];
            const double length = edge.length();
            normal_[k] = length > 0 ? Vec2(-edge.y, edge.x) * (turn / length) : Vec2(0.0);
            offset_[k] = -normal_[k].dot(p[k]);
            reach_[k] = 0.5 * (std::abs(normal_[k].x) + std::abs(normal_[k].y));
        }
    }

    /// Least distance of a texel's centre to the edges; -infinity when its square meets none of
    /// the triangle (separating axes; those of the square are the caller's).
    double inside(const Vec2& centre) const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < 3; ++k) {
            const double distance = normal_[k].dot(centre) + offset_[k];
            if (distance <= -reach_[k])
                return -std::numeric_limits<double>::infinity();
            least = std::min(least, distance);
        }
        return least;
    }

  private:
    std::array<Vec2, 3> normal_;
    std::array<double, 3> offset_{};
    std::array<double, 3> reach_{};
};

Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 edge = b - a;
    const double length2 = edge.length2();
    const double t = length2 > 0 ? std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
    return a + edge * t;
}

Vec2 nearest_on_border(const Vec2& p, const Corners& corners) {
    Vec2 best(0.0);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 point = nearest_on_segment(p, corners[k], corners[(k + 1) % 3]);
        const double distance = (point - p).length2();
        if (distance < least) {
            least = distance;
            best = point;
        }
    }
    return best;
}

bool holds(const Corners& p, const Vec2& point) { return Edges(p).inside(point) >= 0; }

Vec3d barycentric(const Corners& p, const Vec2& point) {
    const double area = doubled_area(p);
    const double b = cross(point - p[0], p[2] - p[0]) / area;
    const double c = cross(p[1] - p[0], point - p[0]) / area;
    return {1 - b - c, b, c};
}

} // namespace

UvRaster::Corners UvRaster::corners(std::uint32_t triangle) const {
    Corners out;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 uv(mesh_.uvs[mesh_.triangles[triangle][k]]);
        out[k] = {uv.x * width_, (1 - uv.y) * height_};
    }
    return out;
}

void UvRaster::check_uvs() const {
    for (const Vec2f& uv : mesh_.uvs)
        if (!(std::abs(uv.x) <= farthest_uv && std::abs(uv.y) <= farthest_uv))
            throw Error("has UVs farther than 1000 from (0, 0)");
    double layers = 0;
    bool useful = false;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        const Corners p = corners(t);
        if (!has_area(p))
            continue;
        useful = true;
        const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
        layers += (right - left) / width_ * ((bottom - top) / height_);
    }
    if (!useful)
        throw Error("has UVs without any area, so a texture has no place on it");
    if (layers > most_layers)
        throw Error("has UVs that cover the texture more than 1000 times over");
}

UvRaster::UvRaster(const Mesh& mesh, int width, int height)
    : mesh_(mesh), width_(width), height_(height) {
    assert(width > 0 && height > 0 && width <= 1 << 15 && height <= 1 << 15);
    assert(mesh.uvs.size() == mesh.positions.size());
    check_uvs();
    owners_.resize(std::size_t(width) * std::size_t(height));
    const int bands = (height + band_rows - 1) / band_rows;
    std::vector<std::vector<std::uint32_t>> triangles(static_cast<std::size_t>(bands));
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Corners p = corners(t);
        if (!has_area(p))
            continue;
        for (const std::uint32_t vertex : mesh.triangles[t]) {
            const Vec2f& uv = mesh.uvs[vertex];
            wraps_ = wraps_ || uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1;
        }
        const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
        const Rows rows = touched(top, bottom);
        const int last = std::min(rows.last, rows.first + height - 1);
        int drawn = -1;
        for (int row = rows.first; row <= last; ++row) {
            const int band = (row - floor_div(row, height) * height) / band_rows;
            // A triangle that comes round to the band that it began in is already there.
            std::vector<std::uint32_t>& list = triangles[std::size_t(band)];
            if (band != drawn && (list.empty() || list.back() != t))
                list.push_back(t);
            drawn = band;
        }
    }
    std::atomic<std::size_t> overlapped = 0;
    parallel_for(std::size_t(bands), 1, [&](std::size_t band) {
        const int first = static_cast<int>(band) * band_rows;
        overlapped += draw_band(first, std::min(first + band_rows, height) - 1, triangles[band]);
    });
    overlapped_ = overlapped;
    for (std::uint32_t i = 0; i < owners_.size(); ++i)
        if (covered(i))
            covered_.push_back(i);
}

std::size_t UvRaster::draw_band(int first_row, int last_row,
                                std::span<const std::uint32_t> triangles) {
    const std::size_t first_texel = std::size_t(first_row) * std::size_t(width_);
    const std::size_t count = std::size_t(last_row - first_row + 1) * std::size_t(width_);
    struct Found {
        float distance = std::numeric_limits<float>::infinity(); // squared, of the owner
        int holders = 0;                                         // triangles round the centre
    };
    std::vector<Found> band(count);
    const auto draw = [&](std::uint32_t t, const Corners& p, const Edges& edges, int x, int y) {
        const Vec2 centre(x + 0.5, y + 0.5);
        const double inside = edges.inside(centre);
        if (inside == -std::numeric_limits<double>::infinity())
            return;
        const int tile_x = floor_div(x, width_);
        const int tile_y = floor_div(y, height_);
        const std::size_t texel = std::size_t(y - tile_y * height_) * std::size_t(width_) +
                                  std::size_t(x - tile_x * width_);
        Found& found = band[texel - first_texel];
        if (inside > edge_width)
            ++found.holders;
        if (found.distance == 0)
            return;
        const float distance =
            inside >= 0 ? 0.0F
                        : static_cast<float>((nearest_on_border(centre, p) - centre).length2());
        if (distance < found.distance) {
            found.distance = distance;
            owners_[texel] = {t, static_cast<std::int16_t>(tile_x),
                              static_cast<std::int16_t>(tile_y)};
        }
    };
    for (const std::uint32_t t : triangles) {
        const Corners p = corners(t);
        const Edges edges(p);
        const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
        const Rows columns = touched(left, right);
        const Rows rows = touched(top, bottom);
        for (int tile = floor_div(rows.first, height_); tile <= floor_div(rows.last, height_);
             ++tile) {
            const int begin = std::max(rows.first, tile * height_ + first_row);
            const int end = std::min(rows.last, tile * height_ + last_row);
            for (int y = begin; y <= end; ++y)
                for (int x = columns.first; x <= columns.last; ++x)
                    draw(t, p, edges, x, y);
        }
    }
    return static_cast<std::size_t>(std::count_if(
        band.begin(), band.end(), [](const Found& found) { return found.holders > 1; }));
}

TexelPlace UvRaster::place(std::size_t texel) const {
    const Owner& owner = owners_[texel];
    assert(owner.triangle != none);
    const auto column = static_cast<int>(texel % std::size_t(width_));
    const auto row = static_cast<int>(texel / std::size_t(width_));
    const Vec2 centre(column + 0.5 + owner.tile_x * width_, row + 0.5 + owner.tile_y * height_);
    const Corners p = corners(owner.triangle);
    const Mesh::Triangle& t = mesh_.triangles[owner.triangle];
    const Vec3d a(mesh_.positions[t[0]]), b(mesh_.positions[t[1]]), c(mesh_.positions[t[2]]);

    // d position / d texel: the images of one texel to the right and one down.
    const Vec2 e = p[1] - p[0], f = p[2] - p[0];
    const double area = cross(e, f);
    const Vec3d right = ((b - a) * f.y - (c - a) * e.y) / area;
    const Vec3d down = ((c - a) * e.x - (b - a) * f.x) / area;

    TexelPlace out;
    out.triangle = owner.triangle;
    const Vec2 nearest = holds(p, centre) ? centre : nearest_on_border(centre, p);
    const Vec3d share = barycentric(p, nearest);
    out.barycentric = Vec3(share);
    // The triangle's plane is continued beyond its edges, so that a bilinear look-up at an edge
    // gives the value of the edge; but not farther than the triangle is long, as a sliver's would
    // be.
    const Vec2 beyond = centre - nearest;
    Vec3d shift = right * beyond.x + down * beyond.y;
    const double longest = std::max({(b - a).length(), (c - b).length(), (a - c).length()});
    if (shift.length() > longest)
        shift *= longest / shift.length();
    out.position = Vec3(a * share.x + b * share.y + c * share.z + shift);
    out.uv = Vec2f(Vec2(centre.x / width_, 1 - centre.y / height_));

    // The principal axes of what the texel's square becomes.
    const double angle = 0.5 * std::atan2(2 * right.dot(down), right.length2() - down.length2());
    out.along = Vec3(right * std::cos(angle) + down * std::sin(angle));
    out.across = Vec3(down * std::cos(angle) - right * std::sin(angle));
    return out;
}

} // namespace scree
