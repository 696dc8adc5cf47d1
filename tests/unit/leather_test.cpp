// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"
#include "core/parallel.h"
#include "core/random.h"
#include "generators/leather/displaced_surface.h"
#include "generators/leather/groove_network.h"
#include "generators/leather/leather_generator.h"
#include "generators/leather/membrane.h"
#include "generators/leather/relief.h"
#include "generators/leather/tile_noise.h"
#include "shapes/table.h"
#include "tests/support/layout_params.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace scree {
namespace {

Params leather(const std::string& preset, int resolution = 256, double size = 0.04) {
    Params params = tests::defaults(leather_plugin().params, "generator.leather");
    params.set("preset", preset, {"scene.lua", 3});
    params.set("resolution", std::int64_t{resolution}, {"scene.lua", 4});
    params.set("size", size, {"scene.lua", 5});
    params.set("triangles", std::int64_t{20000}, {"scene.lua", 6});
    return params;
}

ReliefRequest request(const LeatherSettings& settings, int resolution, double size = 0.03) {
    ReliefRequest r;
    r.settings = settings;
    r.size = size;
    r.resolution = resolution;
    r.seed = 5;
    return r;
}

const LeatherSettings& preset(const std::string& name) {
    for (const LeatherSettings& settings : leather_presets())
        if (settings.name == name)
            return settings;
    throw std::logic_error(name);
}

CellLayout some_cells(double size = 1, std::uint64_t seed = 3) {
    return place_cells(size, {{0.11 * size, {0.4, 1.4}, 1.5, 0.3, 1.0, 0.9}}, seed, 0, {});
}

/// The outline of a cell where it lies, moved by whole tiles.
Ring placed(const CellLayout& layout, const Cell& cell, const Vec2& tiles) {
    Ring ring;
    for (const Vec2& p : layout.shapes[cell.shape].outline().rings.front())
        ring.push_back(cell.pose.apply(p) + tiles * layout.size);
    return ring;
}

bool cross_each_other(const Ring& a, const Ring& b) {
    const auto turn = [](const Vec2& p, const Vec2& q, const Vec2& r) {
        const auto x = static_cast<long double>(q.x) - p.x, y = static_cast<long double>(q.y) - p.y;
        const long double value =
            x * (static_cast<long double>(r.y) - p.y) - y * (static_cast<long double>(r.x) - p.x);
        return value > 0 ? 1 : value < 0 ? -1 : 0;
    };
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Vec2 &p = a[i], &q = a[(i + 1) % a.size()];
            const Vec2 &r = b[j], &s = b[(j + 1) % b.size()];
            if (turn(p, q, r) != turn(p, q, s) && turn(r, s, p) != turn(r, s, q))
                return true;
        }
    return false;
}

bool holds(const Ring& ring, const Vec2& point) {
    Region region;
    region.rings = {ring};
    return contains(region, point);
}

TEST(CellLayout, RegionsDoNotOverlapEvenAcrossTheBorder) {
    const CellLayout layout = some_cells();
    ASSERT_GT(layout.cells.size(), 60U);
    std::size_t neighbours = 0, across = 0;
    for (std::size_t i = 0; i < layout.cells.size(); ++i)
        for (std::size_t j = i; j < layout.cells.size(); ++j)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x) {
                    if (i == j && x == 0 && y == 0)
                        continue;
                    const Ring a = placed(layout, layout.cells[i], {0.0, 0.0});
                    const Ring b = placed(layout, layout.cells[j], Vec2(x, y));
                    if ((a.front() - b.front()).length() > 0.4)
                        continue;
                    ++neighbours;
                    across += x != 0 || y != 0 ? 1 : 0;
                    ASSERT_FALSE(cross_each_other(a, b)) << i << " " << j;
                    ASSERT_FALSE(holds(a, b.front())) << i << " " << j;
                    ASSERT_FALSE(holds(b, a.front())) << i << " " << j;
                }
    EXPECT_GT(neighbours, 1000U);
    EXPECT_GT(across, 100U) << "the border was looked at";
    EXPECT_GT(layout.fill(), 0.6);
}

TEST(CellLayout, OutlinesDifferAndHaveTheAreaOfADisk) {
    std::vector<std::size_t> corners;
    double length_by_width = 0;
    for (std::uint64_t i = 0; i < 24; ++i) {
        const Region outline = cell_outline(1.6, 0.8, 1, i);
        EXPECT_NEAR(area(outline), pi / 4, 1e-9);
        const Vec2 size = bounds(outline).size();
        length_by_width += size.x / size.y / 24;
        corners.push_back(outline.rings.front().size());
    }
    std::sort(corners.begin(), corners.end());
    EXPECT_EQ(corners.front(), 5U * 4);
    EXPECT_EQ(corners.back(), 8U * 4);
    EXPECT_NEAR(length_by_width, 1.6, 0.25);
}

TEST(GrooveNetwork, AgreesWithExactDistancesToAllRegions) {
    const CellLayout layout = some_cells(0.05);
    const GrooveNetwork network = groove_network(layout, 128, nullptr, {});
    Random random(2, Purpose::test);
    for (int k = 0; k < 400; ++k) {
        // The border's pixels as often as all others together.
        const int x = k % 2 == 0 ? int(random.below(128)) : k % 4 == 1 ? 0 : 127;
        const int y = int(random.below(128));
        const Vec2 p = Vec2(x + 0.5, y + 0.5) * (0.05 / 128);
        std::vector<std::pair<double, std::uint32_t>> nearest;
        for (std::uint32_t c = 0; c < layout.cells.size(); ++c) {
            double least = 1;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) {
                    Region region;
                    region.rings = {placed(layout, layout.cells[c], Vec2(i, j))};
                    least = std::min(least, signed_distance(region, p));
                }
            nearest.emplace_back(least, c);
        }
        std::sort(nearest.begin(), nearest.end());
        const std::size_t i = network.index(x, y);
        const double tolerance = 1e-5 * 0.05;
        EXPECT_NEAR(network.distance[i], (nearest[1].first - nearest[0].first) / 2, tolerance);
        EXPECT_NEAR(network.junction[i], (nearest[2].first - nearest[0].first) / 2, tolerance);
        if (nearest[1].first - nearest[0].first > 4 * tolerance) {
            EXPECT_EQ(network.owner[i], nearest[0].second);
        }
    }
}

TEST(Membrane, SolvesItsEquationBetweenStraightGrooves) {
    // Two cells as bands across x, their grooves off the pixels' centres and borders.
    const int n = 128;
    const double low = 20.3, high = 88.6; // of the grooves [pixels]
    GrooveNetwork network;
    network.resolution = n;
    network.pixel = 1;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double at = x + 0.5;
            const bool inner = at > low && at < high;
            network.owner.push_back(inner ? 1 : 0);
            const double to_low = std::abs(at - low), to_high = std::abs(at - high);
            network.distance.push_back(
                static_cast<float>(std::min({to_low, to_high, n - to_low, n - to_high})));
        }
    network.junction = network.along = network.distance;
    for (const double shoulder : {3.0, 12.0, 60.0}) {
        const std::vector<float> u = membrane(network, shoulder, {});
        for (int x = 21; x < 88; ++x) {
            const double from_middle = x + 0.5 - (low + high) / 2;
            const double expected =
                1 - std::cosh(from_middle / shoulder) / std::cosh((high - low) / 2 / shoulder);
            EXPECT_NEAR(u[network.index(x, 40)], expected, 0.006) << shoulder << " at " << x;
        }
    }
}

TEST(ReliefProfiles, AreWhatTheirDocumentsSay) {
    for (const float fullness : {0.0F, 0.5F, 1.0F}) {
        EXPECT_EQ(crista_profile(0, fullness), 0);
        EXPECT_EQ(crista_profile(1, fullness), 1);
        for (int i = 0; i < 100; ++i)
            EXPECT_LT(crista_profile(float(i) / 100, fullness),
                      crista_profile(float(i + 1) / 100, fullness));
    }
    EXPECT_FLOAT_EQ(crista_profile(0.5F, 0), 0.75F);            // parabola
    EXPECT_FLOAT_EQ(crista_profile(0.5F, 1), std::sqrt(0.75F)); // ellipse
    EXPECT_FLOAT_EQ(sulcus_profile(0, 2), 1);
    EXPECT_FLOAT_EQ(sulcus_profile(1, 2), std::exp(-1.0F)); // half the width from the middle
    EXPECT_LT(sulcus_profile(6, 2), 1e-12F);
}

TEST(TileNoise, RepeatsAndHasTheDeviationItSays) {
    const TileNoise noise(7, 5, 3, 1);
    double sum = 0, squares = 0;
    const int count = 200;
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x) {
            const Vec2 uv((x + 0.5) / count, (y + 0.5) / count);
            const double v = double(noise(uv));
            EXPECT_LE(std::abs(v), 1.5);
            EXPECT_NEAR(v, noise(uv + Vec2(2, -1)), 1e-5);
            sum += v;
            squares += v * v;
        }
    const double mean = sum / count / count;
    EXPECT_NEAR(mean, 0, 0.1);
    EXPECT_NEAR(std::sqrt(squares / count / count - mean * mean), 1.0 / 3, 0.07);
}

/// Two-sample test of the seam. For every border between two columns the Kolmogorov-Smirnov
/// distance between what is seen across it, row by row, and what is seen across all borders
/// together. If the seam is like the others its distance is as likely as theirs to have any rank:
/// the share of borders with a distance as large is its significance. Rows depend on each other,
/// and do so alike for every border, so the rank stays fair.
double seam_significance(const Image& map, bool of_slopes) {
    const int n = map.width;
    const auto at = [&](int x, int y) { return *map.at((x % n + n) % n, y); };
    const auto seen = [&](int x, int y) { // across the border on the left of column x
        const float jump = at(x, y) - at(x - 1, y);
        return of_slopes ? (at(x + 1, y) - at(x, y)) - (at(x - 1, y) - at(x - 2, y)) : jump;
    };
    std::vector<float> all;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < n; ++x)
            all.push_back(seen(x, y));
    std::sort(all.begin(), all.end());
    std::vector<double> distances;
    for (int x = 0; x < n; ++x) {
        std::vector<float> column;
        for (int y = 0; y < map.height; ++y)
            column.push_back(seen(x, y));
        std::sort(column.begin(), column.end());
        double distance = 0;
        for (std::size_t i = 0; i < column.size(); ++i) {
            const double share =
                double(std::lower_bound(all.begin(), all.end(), column[i]) - all.begin()) /
                double(all.size());
            distance = std::max({distance, std::abs(share - double(i) / double(column.size())),
                                 std::abs(share - double(i + 1) / double(column.size()))});
        }
        distances.push_back(distance);
    }
    const auto as_far = std::count_if(distances.begin(), distances.end(),
                                      [&](double d) { return d >= distances.front(); });
    return double(as_far) / double(n);
}

Image turned(const Image& map) {
    Image out(map.height, map.width, map.channels);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            *out.at(y, x) = *map.at(x, y);
    return out;
}

// The change of slope at a seam shows at three borders of 384 or more, so that less than 1 in 128
// could not be seen.
constexpr double significance = 0.01;

class Preset : public testing::TestWithParam<std::string> {};

TEST_P(Preset, HasNoSeam) {
    const HeightField field = leather_relief(request(preset(GetParam()), 512), {}).as_height();
    for (const bool of_slopes : {false, true}) {
        EXPECT_GT(seam_significance(field.image, of_slopes), significance);
        EXPECT_GT(seam_significance(turned(field.image), of_slopes), significance);
    }
    // The test sees a seam where there is one: the left three quarters do not tile.
    Image part(384, 512, {"Y"});
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 384; ++x)
            *part.at(x, y) = *field.image.at(x, y);
    EXPECT_LT(seam_significance(part, false), significance);
    EXPECT_LT(seam_significance(part, true), significance);
}

TEST_P(Preset, IsFiniteAndAsHighAsItSays) {
    const LeatherSettings& s = preset(GetParam());
    ReliefFacts facts;
    const HeightField field = leather_relief(request(s, 256), {}, &facts);
    for (const float v : field.image.pixels)
        ASSERT_TRUE(std::isfinite(v));
    EXPECT_GT(facts.cells, 30U);
    EXPECT_GT(facts.fill, 0.55);
    EXPECT_GT(facts.highest, 0.6 * s.depth);
    EXPECT_LT(facts.highest, (1 + s.height_variation) * (1 + s.tilt) * s.depth +
                                 3 * (s.undulation + s.roughness) + 0.2 * s.pore_depth);
    EXPECT_LT(facts.lowest, 0);
    EXPECT_GT(facts.lowest, -(s.groove_depth + s.minor_depth + s.wrinkle_depth + s.pore_depth +
                              3 * (s.undulation + s.roughness)));
}

TEST_P(Preset, IsTheSameOnAnyNumberOfThreads) {
    Aggregate made[2];
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        made[threads - 1] = leather_plugin().make(leather(GetParam()), {});
    }
    const auto same_bytes = [](const auto& a, const auto& b) {
        return a.size() == b.size() &&
               std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
    };
    EXPECT_TRUE(same_bytes(made[0].height->image.pixels, made[1].height->image.pixels));
    const Mesh &a = *made[0].prototypes[0].mesh(), &b = *made[1].prototypes[0].mesh();
    EXPECT_TRUE(same_bytes(a.positions, b.positions));
    EXPECT_TRUE(same_bytes(a.normals, b.normals));
    EXPECT_TRUE(same_bytes(a.triangles, b.triangles));
}

INSTANTIATE_TEST_SUITE_P(All, Preset,
                         testing::Values("fine_calf", "coarse_grain", "reptile", "pebbled"),
                         [](const auto& tested) { return tested.param; });

TEST(Leather, SeedsDifferAndParametersOverrideThePreset) {
    const LeatherSettings& s = preset("pebbled");
    ReliefRequest one = request(s, 64), other = one;
    other.seed = 6;
    EXPECT_NE(leather_relief(one, {}).image.pixels, leather_relief(other, {}).image.pixels);
    Params params = leather("pebbled");
    EXPECT_EQ(settings_from(params).depth, s.depth);
    params.set("depth", 1e-4);
    params.set("cell_range", Range{0.5, 0.7});
    EXPECT_EQ(settings_from(params).depth, 1e-4);
    EXPECT_EQ(settings_from(params).cell_range.high, 0.7);
    EXPECT_EQ(settings_from(params).cell, s.cell);
}

TEST(Leather, CristaeRiseAndSulciSinkAtTheSamePlaces) {
    ReliefRequest r = request(preset("coarse_grain"), 256);
    r.settings.minor_depth = 0;
    r.settings.groove_variation = 0;
    r.parts = ReliefParts::cristae;
    const HeightField cristae = leather_relief(r, {});
    r.parts = ReliefParts::sulci;
    const HeightField sulci = leather_relief(r, {});
    double product = 0, a2 = 0, b2 = 0, a1 = 0, b1 = 0;
    const auto count = double(cristae.image.pixels.size());
    for (std::size_t i = 0; i < cristae.image.pixels.size(); ++i) {
        const double a = cristae.image.pixels[i], b = sulci.image.pixels[i];
        EXPECT_GE(a, 0);
        EXPECT_LE(b, 0);
        product += a * b;
        a1 += a;
        b1 += b;
        a2 += a * a;
        b2 += b * b;
    }
    const double covariance = product / count - a1 / count * (b1 / count);
    const double correlation = covariance / std::sqrt((a2 / count - a1 * a1 / count / count) *
                                                      (b2 / count - b1 * b1 / count / count));
    EXPECT_GT(correlation, 0.5) << "low where the grooves are";
}

TEST(Leather, TheFileHoldsTheHeightsOfTheSwatchThatIsRendered) {
    Params params = leather("coarse_grain", 64);
    params.set("triangles", std::int64_t{2 * 128 * 128}); // every second vertex on a pixel's centre
    const Aggregate made = leather_plugin().make(params, {});
    const std::string path =
        (std::filesystem::temp_directory_path() / "scree-leather-swatch.exr").string();
    write_height(path, *made.height);
    const HeightField map = read_height(path);
    const Image raw = read_image(path);
    std::filesystem::remove(path);
    const Mesh& mesh = *made.prototypes[0].mesh();
    ASSERT_EQ(mesh.positions.size(), 129U * 129);
    std::size_t centres = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec2f& uv = mesh.uvs[i];
        const Vec3& p = mesh.positions[i];
        EXPECT_NEAR(p.y, map.height(Vec2(uv)), 2e-8); // 64 pixels * 2^-24 * the steepest slope
        EXPECT_NEAR(p.x, 0.04 * (uv.x - 0.5), 1e-8);
        EXPECT_NEAR(p.z, 0.04 * (0.5 - uv.y), 1e-8);
        const std::size_t x = i % 129, y = i / 129;
        if (x % 2 == 1 && y % 2 == 1) {
            EXPECT_NEAR(p.y, *raw.at(int(x / 2), int(y / 2)), 1e-9);
            ++centres;
        }
    }
    EXPECT_EQ(centres, 64U * 64);
}

TEST(Leather, TheSwatchHasCutEdgesWhenItIsThick) {
    Params params = leather("pebbled", 64);
    params.set("thickness", 0.002);
    params.set("triangles", std::int64_t{2 * 64 * 64});
    const Mesh mesh = *leather_plugin().make(params, {}).prototypes[0].mesh();
    EXPECT_EQ(mesh.triangles.size(), 2U * 64 * 64 + 4 * 2 * 64);
    const Box3 box = bounds(mesh);
    EXPECT_EQ(box.min.y, 0);
    EXPECT_GT(box.max.y, 0.002F);
    const MeshFacts facts = inspect(mesh);
    EXPECT_EQ(facts.boundary_edges, 4U * 64) << "open at the bottom only";
    EXPECT_EQ(facts.non_manifold_edges, 0U);
    for (const Mesh::Triangle& t : mesh.triangles) { // every face looks the way its normals do
        const Vec3 face = (mesh.positions[t[1]] - mesh.positions[t[0]])
                              .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
        ASSERT_GT(face.dot(mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]), 0);
    }
}

TEST(Leather, ASphereIsDisplacedAlongItsRadii) {
    const HeightField field = leather_relief(request(preset("coarse_grain"), 256), {});
    const Vec3 centre(0.1F, 0.2F, -0.3F);
    const Mesh mesh = displaced_sphere(field, centre, 0.02, {0.3F, 0.2F, 1.0F}, 60000);
    EXPECT_NEAR(double(mesh.triangles.size()), 60000, 1000);
    const auto [low, high] =
        std::minmax_element(field.image.pixels.begin(), field.image.pixels.end());
    const float slack = 0.1F * (*high - *low); // cubic interpolation overshoots a little

    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 from = mesh.positions[i] - centre;
        ASSERT_GT(from.length(), 0.02F + *low - slack);
        ASSERT_LT(from.length(), 0.02F + *high + slack);
        ASSERT_NEAR(mesh.normals[i].length(), 1, 1e-5);
        ASSERT_GT(mesh.normals[i].dot(from), 0);
    }
    Mesh closed = mesh;
    for (Vec3& p : closed.positions)
        p -= centre;
    const double enclosed = volume(closed);
    EXPECT_NEAR(enclosed / (4.0 / 3 * pi * std::pow(0.02, 3)), 1, 0.06);
    // Triangles have one size, for the map is laid on without changing areas.
    double smallest = 1, largest = 0;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += 2) {
        const Mesh::Triangle& t = mesh.triangles[k];
        const Vec3 a = (mesh.positions[t[0]] - centre).normalized();
        if (a.dot(Vec3(0.3F, 0.2F, 1.0F).normalized()) < 0)
            continue; // the side that is not seen
        const Vec3 b = (mesh.positions[t[1]] - centre).normalized();
        const Vec3 c = (mesh.positions[t[2]] - centre).normalized();
        const double size = (b - a).cross(c - a).length();
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
    }
    EXPECT_LT(largest / smallest, 1.6);
}

TEST(Leather, AClosedMeshStaysClosedAndTheTileKeepsItsSize) {
    const Registry<MakeMesh> table = component_table();
    for (const Plugin<MakeMesh>& plugin : table.plugins()) {
        if (plugin.name != "torus" && plugin.name != "cylinder" && plugin.name != "box")
            continue;
        const Mesh mesh = plugin.make(tests::defaults(plugin.params, "mesh." + plugin.name));
        ASSERT_FALSE(mesh.uvs.empty());
        HeightField field = leather_relief(request(preset("coarse_grain"), 128, 0.02), {});
        const Mesh displaced = displaced_mesh(field, mesh, 60000);
        EXPECT_GT(displaced.triangles.size(), 30000U) << plugin.name;
        EXPECT_LT(displaced.triangles.size(), 150000U) << plugin.name;
        const MeshFacts before = inspect(mesh), after = inspect(displaced);
        ASSERT_TRUE(before.closed()) << plugin.name;
        EXPECT_TRUE(after.closed())
            << plugin.name << ": " << after.boundary_edges << " " << after.non_manifold_edges;
        EXPECT_TRUE(after.finite);
        EXPECT_NEAR(volume(displaced) / volume(mesh), 1, 0.15) << plugin.name;
    }
}

TEST(Leather, AMeshWithoutUvsIsNamed) {
    Mesh bare;
    bare.name = "bare.obj";
    bare.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    bare.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    Params params = leather("pebbled", 64);
    params.set("shape", std::make_shared<const Mesh>(bare), {"scene.lua", 12});
    try {
        leather_plugin().make(params, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "scene.lua:12: generator.leather.shape: bare.obj has no UVs to "
                                   "lay the leather on");
    }
}

TEST(Leather, CanBeCancelled) {
    Cancel cancel;
    cancel.request();
    Context context;
    context.cancel = &cancel;
    EXPECT_THROW(leather_plugin().make(leather("reptile"), context), Cancelled);
}

} // namespace
} // namespace scree
