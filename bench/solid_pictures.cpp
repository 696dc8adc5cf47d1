// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/solid_pictures.h"

#include "bench/measure.h"
#include "core/random.h"
#include "procedurals/table.h"
#include "render/render.h"
#include "session/session.h"
#include "tests/support/plugin_params.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

namespace scree::bench {

namespace {

using Overrides = std::map<std::string, std::string>;

/// A scene script of the project, ready to be rendered.
class Picture {
  public:
    Picture(const std::string& path, const Overrides& overrides) {
        const std::string full = std::string(SCREE_SOURCE_DIR) + "/" + path;
        Session session({.path = full, .overrides = overrides, .device = "none"});
        scene_ = session.bake(session.load());
        world_ = std::make_unique<World>(scene_.aggregates, scene_.lights);
    }

    FilmSettings& film() { return scene_.film; }

    RenderResult render(const RenderOptions& options) const {
        return scree::render(*world_, *scene_.camera, scene_.film, options);
    }

  private:
    Scene scene_;
    std::unique_ptr<World> world_;
};

/// The root mean square difference of the green channel.
double rms_difference(const Image& one, const Image& other) {
    double sum = 0;
    for (int y = 0; y < one.height; ++y)
        for (int x = 0; x < one.width; ++x)
            sum += std::pow(double(one.at(x, y)[1]) - double(other.at(x, y)[1]), 2);
    return std::sqrt(sum / (double(one.width) * double(one.height)));
}

} // namespace

void print_antialiasing() {
    // "Levels left out": without those of the lattice's six levels that a pixel does not resolve.
    constexpr double size = 0.1;
    constexpr int lattice_levels = 6, side = 24, pixels = 2000;
    const auto marble = [&](int levels, bool filtered) {
        return tests::make(procedural_table(), "marble",
                           {{"preset", std::string("banded")},
                            {"size", size},
                            {"levels", std::int64_t{levels}},
                            {"detail", std::int64_t{0}},
                            {"filtered", filtered}});
    };
    fmt::print("{:>13} {:>8} {:>15} {:>9}   (RMSE of marble against {} points)\n", "pixel [cells]",
               "point", "levels left out", "filtered", side * side);
    for (const int log2_cells : {0, 1, 2, 3, 4, 5}) {
        const std::array answers = {marble(lattice_levels, false),
                                    marble(lattice_levels - log2_cells, false),
                                    marble(lattice_levels, true)};
        const float width = static_cast<float>(size / 64 * (1 << log2_cells));
        Random random(1, Purpose::test);
        std::array<double, 3> squares{};
        std::vector<ShadingPoint> points(side * side);
        std::vector<ShadingSample> found(side * side);
        for (int pixel = 0; pixel < pixels; ++pixel) {
            ShadingPoint middle;
            for (int k = 0; k < 3; ++k)
                middle.position[k] = static_cast<float>(random.uniform(-size, size));
            for (int i = 0; i < side * side; ++i) {
                const auto place = [&](int step) {
                    return width * ((static_cast<float>(step) + 0.5F) / side - 0.5F);
                };
                points[std::size_t(i)] = middle;
                points[std::size_t(i)].position += Vec3(place(i % side), 0, place(i / side));
            }
            answers[0]->evaluate(points, found);
            double mean = 0;
            for (const ShadingSample& sample : found)
                mean += double(sample.value) / (side * side);
            middle.footprint = width;
            middle.across = Vec3(width, 0, 0);
            middle.along = Vec3(0, 0, width);
            for (std::size_t k = 0; k < answers.size(); ++k) {
                ShadingSample sample;
                answers[k]->evaluate({&middle, 1}, {&sample, 1});
                squares[k] += std::pow(double(sample.value) - mean, 2) / pixels;
            }
        }
        fmt::print("{:13} {:8.3f} {:15.3f} {:9.3f}\n", 1 << log2_cells, std::sqrt(squares[0]),
                   std::sqrt(squares[1]), std::sqrt(squares[2]));
    }
}

void print_floor() {
    Picture points("bench/scenes/solid_floor.lua", {{"filtered", "no"}});
    Picture filtered("bench/scenes/solid_floor.lua", {{"filtered", "yes"}});
    RenderOptions options;
    options.mis = Mis::bsdf_only; // under a uniform sky only the texture causes noise
    options.samples = 1;
    const Image first = points.render(options).film.beauty();
    int horizon = 0;
    while (first.at(first.width / 2, horizon)[3] < 1)
        ++horizon;
    for (const int rows : {6, 24, 96}) {
        options.crop = Crop{0, horizon, first.width, rows};
        options.samples = 1024;
        options.seed = 1;
        const Image truth = points.render(options).film.beauty();
        options.samples = 4;
        options.seed = 2;
        const Image one = points.render(options).film.beauty();
        const Image other = filtered.render(options).film.beauty();
        const double point_error = rms_difference(one, truth);
        const double filtered_error = rms_difference(other, truth);
        fmt::print("floor, {:2} rows under the horizon, RMSE of 4 samples against 1,024: point "
                   "{:.4f}, filtered {:.4f}, ratio {:.2f}\n",
                   rows, point_error, filtered_error, filtered_error / point_error);
    }
}

void print_shading() {
    constexpr int runs = 7;
    const std::vector<std::string> kinds = {"plain", "marble", "wood"};
    std::vector<Picture> pictures;
    for (const std::string& kind : kinds)
        pictures.emplace_back("bench/scenes/solid_ball.lua", Overrides{{"material", kind}});
    std::vector<std::vector<double>> seconds(kinds.size()), ratios(kinds.size());
    for (int run = 0; run < runs; ++run)
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            seconds[k].push_back(pictures[k].render({}).stats.cpu_seconds);
            ratios[k].push_back(seconds[k].back() / seconds[0].back());
        }
    for (std::size_t k = 0; k < kinds.size(); ++k)
        fmt::print("ball, {:7} {:.3f} CPU s, {:.3f} of plain\n", kinds[k], median(seconds[k]),
                   median(ratios[k]));
}

void print_table_1() {
    struct Figure {
        int number;
        std::string scene;
        double marble_1987, wood_1987; // [s]
    };
    const std::vector<Figure> figures = {
        {10, "cube", 14.6, 12.9},       {11, "slices", 30.6, 27.9}, {12, "k_series", 15.4, 13.5},
        {13, "cut_sphere", 22.7, 19.9}, {14, "pot", 34.0, 30.7},    {15, "letters", 84.6, 72.6}};
    fmt::print("{:20} {:>16} {:>16} {:>24}\n", "512 x 512", "1987: marble [s]", "wood [s]",
               "ours, 1 and 64 samples [CPU s]");
    for (const Figure& figure : figures) {
        double made = 0;
        std::array<double, 2> seconds{};
        // Marble and wood are in one picture; figure 12 has marble only.
        std::unique_ptr<Picture> picture;
        made = cpu_seconds_of([&] {
            picture =
                std::make_unique<Picture>("scenes/solid_" + figure.scene + ".lua", Overrides{});
        });
        picture->film().width = picture->film().height = 512;
        for (std::size_t i = 0; i < seconds.size(); ++i) {
            RenderOptions options;
            options.samples = i == 0 ? 1 : 64;
            seconds[i] = picture->render(options).stats.cpu_seconds;
        }
        fmt::print("{:2} {:17} {:16.1f} {:16.1f} {:14.2f} {:8.2f}, and {:.3f} before\n",
                   figure.number, figure.scene, figure.marble_1987, figure.wood_1987, seconds[0],
                   seconds[1], made);
    }
}

} // namespace scree::bench
