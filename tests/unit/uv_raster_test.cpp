// SPDX-License-Identifier: GPL-3.0-or-later
// Rasterisation of UVs against brute force: coverage, positions, filters, gutter and tangent
// frames.
#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "geometry/mesh/uv_frame.h"
#include "geometry/mesh/uv_gutter.h"
#include "geometry/mesh/uv_raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace scree {
namespace {

using Vec3d = Imath::V3d;
using Polygon = std::vector<Vec2>;

// Clips a polygon to value(p) >= 0 (Sutherland & Hodgman 1974).
template <class Value>
Polygon clipped(const Polygon& polygon, const Value& value) {
    Polygon out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& a = polygon[i];
        const Vec2& b = polygon[(i + 1) % polygon.size()];
        const double va = value(a), vb = value(b);
        if (va >= 0)
            out.push_back(a);
        if ((va >= 0) != (vb >= 0))
            out.push_back(a + (b - a) * (va / (va - vb)));
    }
    return out;
}

double area_in_square(Polygon polygon, double x, double y) {
    polygon = clipped(polygon, [&](const Vec2& p) { return p.x - x; });
    polygon = clipped(polygon, [&](const Vec2& p) { return x + 1 - p.x; });
    polygon = clipped(polygon, [&](const Vec2& p) { return p.y - y; });
    polygon = clipped(polygon, [&](const Vec2& p) { return y + 1 - p.y; });
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return std::abs(twice) / 2;
}

// The smallest signed distance to the lines of the edges, positive inside.
double depth_inside(const Polygon& t, const Vec2& p) {
    const double turn = cross(t[1] - t[0], t[2] - t[0]) > 0 ? 1 : -1;
    double least = 1e30;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 edge = t[(k + 1) % 3] - t[k];
        least = std::min(least, turn * cross(edge, p - t[k]) / edge.length());
    }
    return least;
}

// Triangles that are disjoint in space, so that a position identifies its triangle.
Mesh random_triangles(std::uint64_t seed, int count, float low, float high, float size) {
    Random random(seed, Purpose::test);
    const auto number = [&](float a, float b) { return a + (b - a) * random.uniform_float(); };
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec2f centre(number(low, high), number(low, high));
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int k = 0; k < 3; ++k) {
            mesh.positions.emplace_back(number(-1, 1), number(-1, 1), number(-1, 1));
            mesh.uvs.push_back(centre + Vec2f(number(-size, size), number(-size, size)));
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

Polygon in_texels(const Mesh& mesh, std::size_t triangle, int width, int height) {
    Polygon out;
    for (const std::uint32_t i : mesh.triangles[triangle])
        out.emplace_back(double(mesh.uvs[i].x) * width, (1 - double(mesh.uvs[i].y)) * height);
    return out;
}

void compare_to_brute_force(const Mesh& mesh, int width, int height) {
    const UvRaster raster(mesh, width, height);
    std::size_t covered = 0;
    std::size_t overlapped = 0;
    std::size_t unclear = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double most_area = 0;
            double deepest = -1e30;
            std::size_t first_holder = mesh.triangles.size();
            int holders = 0;
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
                for (int tile_y = -3; tile_y <= 3; ++tile_y)
                    for (int tile_x = -3; tile_x <= 3; ++tile_x) {
                        const double left = x + tile_x * width, top = y + tile_y * height;
                        const Polygon p = in_texels(mesh, t, width, height);
                        most_area = std::max(most_area, area_in_square(p, left, top));
                        const double depth = depth_inside(p, {left + 0.5, top + 0.5});
                        if (depth > 1e-3)
                            ++holders;
                        if (depth >= 0)
                            first_holder = std::min(first_holder, t);
                        deepest = std::max(deepest, depth);
                    }
            const std::size_t texel = std::size_t(y) * std::size_t(width) + std::size_t(x);
            if (most_area > 0 && most_area < 1e-9) {
                ++unclear; // depends on rounding
            } else {
                ASSERT_EQ(raster.covered(texel), most_area > 0) << x << ", " << y;
            }
            covered += raster.covered(texel) ? 1 : 0;
            overlapped += holders > 1 ? 1 : 0;
            if (deepest > 1e-6) {
                EXPECT_EQ(raster.place(texel).triangle, first_holder) << x << ", " << y;
            }
        }
    EXPECT_EQ(raster.covered_texels().size(), covered);
    EXPECT_EQ(raster.overlapped(), overlapped);
    EXPECT_LT(unclear, 3U);
}

TEST(UvRaster, CoversWhatMeetsATriangle) {
    compare_to_brute_force(random_triangles(1, 12, 0.2F, 0.8F, 0.2F), 37, 23);
    compare_to_brute_force(random_triangles(2, 60, 0.1F, 0.9F, 0.03F), 41, 64); // about a texel
    compare_to_brute_force(random_triangles(3, 8, 0.2F, 0.8F, 0.2F), 1, 5);
}

TEST(UvRaster, WrapsRoundBeyondTheUnitSquare) {
    const Mesh mesh = random_triangles(4, 10, -1.2F, 2.2F, 0.6F);
    compare_to_brute_force(mesh, 19, 33);
    const UvRaster raster(mesh, 19, 33);
    EXPECT_TRUE(raster.wraps());
    for (const std::uint32_t texel : raster.covered_texels()) { // the mesh's UVs, up to whole tiles
        const Vec2f uv = raster.place(texel).uv;
        const std::uint32_t row = texel / 19;
        const double x = uv.x * 19 - 0.5 - texel % 19, y = (1 - uv.y) * 33 - 0.5 - row;
        EXPECT_NEAR(x / 19, std::round(x / 19), 1e-5);
        EXPECT_NEAR(y / 33, std::round(y / 33), 1e-5);
    }
    EXPECT_FALSE(UvRaster(random_triangles(1, 5, 0.4F, 0.6F, 0.2F), 19, 33).wraps());
}

// A square in UV on a slanted and sheared surface: an affine map without seams.
struct Sheared {
    Vec3d origin{0.1, 0.2, -0.3}, along_u{0.5, 0.1, 0.2}, along_v{0.2, 0.3, -0.1};

    Vec3d at(const Vec2& uv) const { return origin + along_u * uv.x + along_v * uv.y; }

    Mesh mesh(float low, float high) const {
        Mesh out;
        for (const Vec2f& uv :
             {Vec2f(low, low), Vec2f(high, low), Vec2f(high, high), Vec2f(low, high)}) {
            out.uvs.push_back(uv);
            out.positions.emplace_back(at(Vec2(uv)));
        }
        out.triangles = {{0, 1, 2}, {0, 2, 3}};
        return out;
    }
};

TEST(UvRaster, PlacesAreThoseOfTexelCentresAlsoBeyondTheEdge) {
    const Sheared map;
    const Mesh mesh = map.mesh(0.21F, 0.83F);
    const UvRaster raster(mesh, 50, 31);
    for (const std::uint32_t texel : raster.covered_texels()) {
        const std::uint32_t row = texel / 50;
        const Vec2 centre((texel % 50 + 0.5) / 50, 1 - (row + 0.5) / 31);
        const TexelPlace place = raster.place(texel);
        EXPECT_NEAR(place.uv.x, centre.x, 1e-6);
        EXPECT_NEAR(place.uv.y, centre.y, 1e-6);
        EXPECT_LT((Vec3d(place.position) - map.at(centre)).length(), 1e-6);
        const Vec3& b = place.barycentric;
        EXPECT_GE(std::min({b.x, b.y, b.z}), -1e-6F) << "of a point of the triangle";
        EXPECT_NEAR(b.x + b.y + b.z, 1, 1e-6);
    }
    EXPECT_EQ(raster.overlapped(), 0U);
}

TEST(UvRaster, SliversGoNoFartherThanTheyAreLong) {
    Mesh mesh;
    mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.uvs = {Vec2f(0.5F, 0.1F), Vec2f(0.5F, 0.9F), Vec2f(0.5F + 1e-6F, 0.5F)};
    mesh.triangles = {{0, 1, 2}};
    const UvRaster raster(mesh, 8, 8);
    EXPECT_FALSE(raster.covered_texels().empty());
    for (const std::uint32_t texel : raster.covered_texels())
        EXPECT_LT(raster.place(texel).position.length(), 3);
}

// The filter's axes agree with finite differences of the positions: they give the covariance J J^T
// of the texel's image.
TEST(UvRaster, FiltersAreTheJacobian) {
    const Sheared map;
    const Mesh mesh = map.mesh(0, 1);
    const int width = 40, height = 17;
    const UvRaster raster(mesh, width, height);
    for (const std::uint32_t texel : {3U * 40 + 5, 12U * 40 + 30, 8U * 40 + 20}) {
        const TexelPlace here = raster.place(texel);
        const Vec3d right(raster.place(texel + 1).position - here.position);
        const Vec3d down(raster.place(texel + 40).position - here.position);
        const Vec3d across(here.across), along(here.along);
        EXPECT_NEAR(across.dot(along), 0, 1e-9);
        EXPECT_LE(across.length(), along.length());
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                EXPECT_NEAR(across[i] * across[j] + along[i] * along[j],
                            right[i] * right[j] + down[i] * down[j], 1e-7);
        EXPECT_NEAR(across.length() * along.length(),
                    map.along_u.cross(map.along_v).length() / (width * height), 1e-9);
    }
}

TEST(UvRaster, IsTheSameOnAnyThreads) {
    const Mesh mesh = random_triangles(5, 200, -0.2F, 1.2F, 0.1F);
    const auto places = [&](int threads) {
        const ThreadLimit limit(threads);
        const UvRaster raster(mesh, 200, 300);
        std::vector<std::pair<std::uint32_t, float>> out;
        for (const std::uint32_t texel : raster.covered_texels())
            out.emplace_back(texel, raster.place(texel).position.x);
        return out;
    };
    EXPECT_EQ(places(1), places(2));
}

TEST(UvRaster, RefusesUselessUvs) {
    const auto message = [](const Mesh& mesh) -> std::string {
        try {
            const UvRaster raster(mesh, 16, 16);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    Mesh mesh = random_triangles(6, 3, 0.2F, 0.8F, 0.1F);
    EXPECT_EQ(message(mesh), "no error");
    std::fill(mesh.uvs.begin(), mesh.uvs.end(), Vec2f(0.3F, 0.4F));
    EXPECT_EQ(message(mesh), "has UVs without any area, so a texture has no place on it");
    mesh.uvs[0] = Vec2f(2000, 0);
    EXPECT_EQ(message(mesh), "has UVs farther than 1000 from (0, 0)");
    EXPECT_EQ(message(Sheared().mesh(-20, 20)),
              "has UVs that cover the texture more than 1000 times over");
}

TEST(UvGutter, IsTheNearestCoveredTexelRoundTheTexture) {
    Random random(7, Purpose::test);
    for (const auto& [width, height, share] :
         {std::tuple(31, 20, 0.02F), std::tuple(16, 33, 0.3F), std::tuple(1, 9, 0.3F),
          std::tuple(40, 1, 0.1F), std::tuple(24, 24, 0.002F)}) {
        std::vector<bool> covered(std::size_t(width) * std::size_t(height));
        for (auto&& texel : covered)
            texel = random.uniform_float() < share;
        covered[covered.size() / 3] = true;
        const std::vector<std::uint32_t> nearest = nearest_covered(width, height, covered);
        const auto distance = [&, w = width, h = height](int a, int b) {
            const int x = std::abs(a % w - b % w), y = std::abs(a / w - b / w);
            const int dx = std::min(x, w - x), dy = std::min(y, h - y);
            return dx * dx + dy * dy;
        };
        for (int i = 0; i < width * height; ++i) {
            int least = 1 << 30;
            for (int j = 0; j < width * height; ++j)
                if (covered[std::size_t(j)])
                    least = std::min(least, distance(i, j));
            const std::uint32_t found = nearest[std::size_t(i)];
            ASSERT_TRUE(covered[found]);
            EXPECT_EQ(distance(i, static_cast<int>(found)), least) << i;
        }
    }
}

TEST(UvGutter, LeavesNoBackground) {
    Image image(8, 4, {"R", "G", "B"});
    std::vector<bool> covered(32);
    covered[9] = covered[22] = true;
    for (int c = 0; c < 3; ++c) {
        image.pixels[std::size_t(9 * 3 + c)] = 1.0F + float(c);
        image.pixels[std::size_t(22 * 3 + c)] = 10.0F + float(c);
    }
    fill_gutter(image, covered);
    for (int i = 0; i < 32; ++i) {
        const float* pixel = &image.pixels[std::size_t(3 * i)];
        EXPECT_TRUE(pixel[0] == 1 || pixel[0] == 10) << i;
        EXPECT_EQ(pixel[2], pixel[0] + 2);
    }
    EXPECT_EQ(image.at(0, 1)[0], 1);
    EXPECT_EQ(image.at(7, 2)[0], 10);
}

TEST(UvFrames, FollowTheUvsOnFlatAndMirroredFaces) {
    const Sheared map;
    Mesh mesh = map.mesh(0, 1);
    const auto check = [&](double handedness) {
        const UvAxes axes = UvFrames(mesh).at(0, Vec3(0.2F, 0.3F, 0.5F));
        const Vec3 normal(map.along_u.cross(map.along_v).normalized() * handedness);
        EXPECT_LT((axes.normal - normal).length(), 1e-5F);
        EXPECT_LT((axes.tangent - Vec3(map.along_u.normalized())).length(), 1e-5F);
        EXPECT_GT(axes.bitangent.dot(Vec3(map.along_v)), 0) << "to where v grows";
        EXPECT_NEAR(axes.bitangent.dot(axes.tangent), 0, 1e-6);
        EXPECT_NEAR(axes.bitangent.dot(axes.normal), 0, 1e-6);
        EXPECT_NEAR(axes.bitangent.length(), 1, 1e-6);
    };
    check(1);
    for (Mesh::Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]); // reverses the orientation
    check(-1);
}

TEST(UvFrames, GiveTheLengthOfAUnitOfUv) {
    Mesh mesh;
    for (const Vec2f& uv : {Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1), Vec2f(0, 1)}) {
        mesh.uvs.push_back(uv);
        mesh.positions.emplace_back(2 * uv.x, 0.0F, -0.5F * uv.y);
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    UvScale scale = uv_scale(mesh);
    EXPECT_NEAR(scale.size.x, 2, 1e-6);
    EXPECT_NEAR(scale.size.y, 0.5, 1e-6);
    EXPECT_NEAR(scale.spread, 0, 1e-6);
    mesh.uvs[2].x = 0.5F;
    scale = uv_scale(mesh);
    EXPECT_GT(scale.spread, 0.2);
}

} // namespace
} // namespace scree
