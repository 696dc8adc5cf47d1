// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"
#include "generators/layout/method.h"
#include "generators/layout/saturation_search.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace scree {

namespace {

/// The domain's box in tiles so wide that elements of two tiles of the same color never meet: they
/// are filled at the same time, and still the same whatever the number of threads.
struct Tiles {
    Vec2 origin, size;
    int columns, rows;

    Tiles(const DomainTest& domain, double reach, double wanted) : origin(domain.box().min) {
        const Vec2 whole = domain.box().size();
        const auto count = [&](double length) {
            const int n = std::max(1, static_cast<int>(length / std::max(reach, wanted)));
            return domain.is_torus() && n > 1 ? n / 2 * 2 : n; // colors alternate across the seam
        };
        columns = count(whole.x);
        rows = count(whole.y);
        size = whole / Vec2(columns, rows);
    }

    Box2 box(std::size_t tile) const {
        const auto width = static_cast<std::size_t>(columns);
        const Vec2 low = origin + size * Vec2(double(tile % width), double(tile / width));
        return {low, low + size};
    }

    std::vector<std::size_t> of_color(int color) const {
        std::vector<std::size_t> result;
        for (int y = color / 2; y < rows; y += 2)
            for (int x = color % 2; x < columns; x += 2)
                result.push_back(std::size_t(y) * std::size_t(columns) + std::size_t(x));
        return result;
    }
};

class Filling {
  public:
    Filling(const SearchProblem& problem, const Tiles& tiles, Placements& placements,
            const Context& context)
        : problem_(problem), tiles_(tiles), placements_(placements), context_(context) {}

    /// Calls work(search, tile) for every tile, color by color, and places what the searches found.
    template <class Work>
    void for_all_tiles(std::uint64_t pass, std::string_view what, const Work& work) {
        const std::size_t count = std::size_t(tiles_.columns) * std::size_t(tiles_.rows);
        std::size_t done = 0;
        for (int color = 0; color < 4; ++color) {
            const std::vector<std::size_t> tiles = tiles_.of_color(color);
            constexpr std::size_t batch = 64; // between reports of progress
            for (std::size_t first = 0; first < tiles.size(); first += batch) {
                context_.report(what, double(done) / double(count));
                const std::size_t size = std::min(batch, tiles.size() - first);
                std::vector<std::optional<SaturationSearch>> searches(size);
                parallel_for(size, 1, [&](std::size_t i) {
                    context_.check_cancel();
                    const std::size_t tile = tiles[first + i];
                    searches[i].emplace(problem_, placements_,
                                        Random(problem_.layout.seed, Purpose::layout_saturate,
                                               pass * count + tile));
                    work(*searches[i], tile);
                });
                place_in_turn(searches);
                done += size;
            }
        }
    }

    SearchCounts counts;

  private:
    /// One element of each search after the other, so that a limit to their number leaves no tile
    /// empty.
    void place_in_turn(const std::vector<std::optional<SaturationSearch>>& searches) {
        bool any = true;
        for (std::size_t k = 0; any; ++k) {
            any = false;
            for (const auto& search : searches) {
                if (k >= search->placed().size() || placements_.full())
                    continue;
                placements_.place(search->placed()[k]);
                any = true;
            }
        }
        for (const auto& search : searches)
            counts.add(search->counts());
    }

    const SearchProblem& problem_;
    const Tiles& tiles_;
    Placements& placements_;
    const Context& context_;
};

/// The boxes and components of a tile, in random order.
struct Root {
    Box2 box;
    std::uint32_t component;
};

std::vector<Root> roots_of(const LayoutProblem& problem, const Box2& tile, Random& random) {
    std::vector<Root> roots;
    for (std::uint32_t c = 0; c < problem.shapes.size(); ++c) {
        if (problem.weights[c] <= 0)
            continue;
        // Wider boxes have fewer neighbours for their area, narrower ones shorter lists of them.
        // Measured: U, star, L, square need 1.2 to 1.7 times the work at 0.7, 1.0 to 1.1 at 2.8.
        const double wanted =
            1.6 * problem.shapes[c].radius() * problem.scale.low * problem.scale_over(tile).low;
        const Vec2 size = tile.size();
        const int columns = std::max(1, static_cast<int>(std::ceil(size.x / wanted)));
        const int rows = std::max(1, static_cast<int>(std::ceil(size.y / wanted)));
        const Vec2 step = size / Vec2(columns, rows);
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x)
                roots.push_back(
                    {{tile.min + step * Vec2(x, y), tile.min + step * Vec2(x + 1, y + 1)}, c});
    }
    for (std::size_t i = roots.size(); i > 1; --i)
        std::swap(roots[i - 1], roots[random.below(static_cast<std::uint32_t>(i))]);
    return roots;
}

} // namespace

MethodCounts fill_saturated(const LayoutProblem& problem, const SaturatedSettings& settings,
                            Placements& placements, Certificate& certificate,
                            const Context& context) {
    const SearchProblem search_problem(problem, settings.epsilon);
    const double radius = problem.largest_radius() + problem.largest_margin();
    const Box2 whole = problem.domain.box();
    double element = 0; // mean area [m^2]
    for (std::size_t c = 0; c < problem.shapes.size(); ++c)
        element += problem.shapes[c].area() / double(problem.shapes.size());
    const double scale = (problem.scale.low + problem.scale.high) / 2 *
                         (problem.scale_over(whole).low + problem.scale_over(whole).high) / 2;
    element *= scale * scale;
    // About fifty elements each, so that there are enough of them for all threads.
    const Tiles tiles(problem.domain, 2 * radius + 2 * search_problem.clearance,
                      std::sqrt(50 * element));
    Filling filling(search_problem, tiles, placements, context);
    const double tile_elements = tiles.size.x * tiles.size.y / element;

    std::uint64_t pass = 0;
    double thrown = 0;
    for (double each = 1; thrown < settings.darts && !placements.full(); each *= 2, ++pass) {
        const double round = std::min(each, settings.darts - thrown);
        thrown += round;
        const auto darts = static_cast<std::uint64_t>(std::ceil(round * tile_elements));
        filling.for_all_tiles(pass, "placing elements",
                              [&](SaturationSearch& search, std::size_t tile) {
                                  for (std::uint64_t i = 0; i < darts; ++i)
                                      search.try_dart(tiles.box(tile), tile + i);
                              });
    }
    const auto start = std::chrono::steady_clock::now();
    if (!placements.full())
        filling.for_all_tiles(
            pass, "filling gaps", [&](SaturationSearch& search, std::size_t tile) {
                Random random(problem.seed, Purpose::layout_order, tile);
                for (const Root& root : roots_of(problem, tiles.box(tile), random)) {
                    context.check_cancel();
                    search.saturate(root.box, root.component);
                }
            });
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    certificate = {settings.epsilon, filling.counts.cells, filling.counts.undecided,
                   !placements.full(), seconds.count()};
    MethodCounts counts;
    counts.trials = filling.counts.darts;
    counts.cancellations = filling.counts.darts - placements.size();
    counts.queries = filling.counts.queries;
    return counts;
}

} // namespace scree
