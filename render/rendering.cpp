// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/rendering.h"

#include "core/binary_stream.h"
#include "core/error.h"
#include "render/film/error_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace scree {

namespace {

constexpr int longest_pass = 64;      // samples; short enough to keep the limit of noise
constexpr int min_samples_noise = 16; // fewer say too little about the error
constexpr int noise_step = 8;         // samples between two looks at the error

// Denormals cost Embree and shading dearly and mean nothing in a picture.
class FlushDenormals {
  public:
#if defined(__SSE2__)
    FlushDenormals() { _mm_setcsr(before_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON); }
    ~FlushDenormals() { _mm_setcsr(before_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

  private:
    unsigned before_ = _mm_getcsr();
#endif
};

Crop checked_crop(const FilmSettings& film, const std::optional<Crop>& crop) {
    if (!crop)
        return {0, 0, film.width, film.height};
    if (crop->x < 0 || crop->y < 0 || crop->width < 1 || crop->height < 1 ||
        crop->width > film.width - crop->x || crop->height > film.height - crop->y)
        throw Error::usage("the crop " + std::to_string(crop->x) + "," + std::to_string(crop->y) +
                           "," + std::to_string(crop->width) + "," + std::to_string(crop->height) +
                           " is not inside of the picture of " + std::to_string(film.width) +
                           " x " + std::to_string(film.height) + " pixels");
    return *crop;
}

// N samples share the pixel's area, so a sample's width is 1 / sqrt(N), by the number asked for:
// the same for every tile and thread. Runs that a time limit or the noise may end sooner use the
// fewest samples after which such a run may end. Below an eighth there is nothing to gain: a box so
// wide adds 1% to the variance of the film's default filter.
float sample_width(int samples, const RenderOptions& options) {
    if (options.time_limit > 0 || options.noise > 0)
        samples = std::min(samples, min_samples_noise);
    return std::max(0.125F, 1 / std::sqrt(static_cast<float>(samples)));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int area(const Tile& tile) { return (tile.x1 - tile.x0) * (tile.y1 - tile.y0); }

} // namespace

Rendering::Rendering(const World& world, const Camera& camera, const FilmSettings& settings,
                     const RenderOptions& options, const Context& context)
    : options_(options), context_(context), crop_(checked_crop(settings, options.crop)),
      samples_(options.samples > 0 ? options.samples : settings.samples),
      share_(sample_width(samples_, options)), renderer_(world, camera, settings, options, crop_),
      film_(crop_.width, crop_.height, world.origin(),
            {light_groups(world.lights()).names, options.mattes}),
      tiles_(shard_tiles(crop_.width, crop_.height, options.shard)) {
    if (options.threads > 0)
        threads_.emplace(options.threads);
    for (const Tile& tile : tiles_)
        pixels_ += static_cast<std::uint64_t>(area(tile));
    renderer_.set_share(share_);
}

bool Rendering::is_finished(const Tile& tile) const {
    return tile.done >= samples_ || (options_.noise > 0 && tile.done >= min_samples_noise &&
                                     double(tile.error) < options_.noise);
}

// What a tile's halves differ by is uncertain. Stopped as soon as they happen to agree, it would
// have more noise than it says: so the noise is taken from all samples, and only what their even
// distribution gains from the halves, as the mean over all passes.
void Rendering::estimate_error(Tile& tile) const {
    ErrorEstimate estimate;
    estimate.add(film_, tile.x0, tile.y0, tile.x1, tile.y1);
    const double independent = estimate.independent();
    if (tile.done >= min_samples_noise && independent > 0) {
        const double gain = estimate.value() / independent;
        tile.gain_sum += static_cast<float>(gain * gain);
        ++tile.passes;
    }
    tile.error = static_cast<float>(
        tile.passes > 0 ? independent * std::sqrt(double(tile.gain_sum) / tile.passes)
                        : independent);
}

// With a limit of noise, no more than it is likely to take: the error falls with the root of the
// number of samples.
int Rendering::next_samples(const Tile& tile) const {
    int more = std::clamp(tile.done, 1, longest_pass);
    if (options_.noise > 0 && tile.done >= min_samples_noise) {
        const double ratio = double(tile.error) / options_.noise;
        const double lacking = tile.done * (ratio * ratio - 1);
        const int steps = static_cast<int>(std::min(lacking, 1e6)) / noise_step + 1;
        more = std::min(more, steps * noise_step);
    }
    return std::min(tile.done + more, samples_);
}

bool Rendering::finished() const {
    return std::ranges::all_of(tiles_, [](const Tile& tile) { return tile.finished; });
}

int Rendering::samples() const {
    int least = samples_;
    for (const Tile& tile : tiles_)
        if (!tile.finished)
            least = std::min(least, tile.done);
    return least;
}

void Rendering::render_tile(Tile& tile, Clock::time_point deadline) {
    const FlushDenormals flush;
    if (tile.row == 0)
        tile.end = next_samples(tile);
    const int number = tile.x0 + tile.y0 + tile.done;
    PixelRenderer::Batch batch(renderer_, film_, static_cast<std::size_t>(number));
    int y = tile.y0 + tile.row;
    for (; y < tile.y1 && !must_stop(deadline); ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
            for (int s = tile.done; s < tile.end; ++s)
                batch.add(x, y, s);
    batch.flush();
    const int rows = y - (tile.y0 + tile.row);
    progress_ += static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(tile.x1 - tile.x0) *
                 static_cast<std::uint64_t>(tile.end - tile.done);
    tile.row = y - tile.y0;
    if (y < tile.y1)
        return;
    tile.row = 0;
    tile.done = tile.end;
    if (options_.noise > 0)
        estimate_error(tile);
    tile.finished = is_finished(tile);
}

void Rendering::pass_until(Clock::time_point deadline) {
    pass_start_ = Clock::now();
    const std::clock_t cpu = std::clock();
    const int least = samples();
    const int goal = least + std::clamp(least, 1, longest_pass);
    parallel_for(tiles_.size(), 1, [&](std::size_t i) {
        Tile& tile = tiles_[i];
        if (tile.finished || tile.done >= goal || must_stop(deadline))
            return;
        render_tile(tile, deadline);
        report();
    });
    seconds_ += seconds_since(pass_start_);
    cpu_seconds_ += double(std::clock() - cpu) / CLOCKS_PER_SEC;
}

void Rendering::pass() { pass_until(Clock::time_point::max()); }

void Rendering::step(double seconds) {
    constexpr double longest = 1e9; // [s]; Clock cannot represent all doubles
    const auto deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(
                           std::chrono::duration<double>(std::min(seconds, longest)));
    while (!finished() && !must_stop(deadline))
        pass_until(deadline);
}

void Rendering::report() {
    if (!context_.progress)
        return;
    const std::unique_lock lock(progress_mutex_, std::try_to_lock);
    if (!lock.owns_lock())
        return;
    const double done = double(progress_.load()) / double(pixels_);
    const double seconds = seconds_ + seconds_since(pass_start_);
    context_.report(fmt::format("{:.1f} of {} samples, {:.2f} Mray/s", done, samples_,
                                double(renderer_.rays()) / seconds * 1e-6),
                    std::min(1.0, done / samples_));
}

std::uint64_t Rendering::samples_of_tiles() const {
    std::uint64_t sum = 0;
    for (const Tile& tile : tiles_)
        sum += static_cast<std::uint64_t>(tile.done * area(tile)) +
               static_cast<std::uint64_t>((tile.end - tile.done) * tile.row * (tile.x1 - tile.x0));
    return sum;
}

// Each tile by itself, so that it does not depend on how the picture is divided into shards.
double Rendering::error() const {
    ErrorEstimate error;
    for (const Tile& tile : tiles_)
        error.add(film_, tile.x0, tile.y0, tile.x1, tile.y1);
    return error.value();
}

RenderStats Rendering::stats() const {
    RenderStats stats;
    stats.rays = renderer_.rays();
    stats.seconds = seconds_;
    stats.cpu_seconds = cpu_seconds_;
    stats.embree_share = renderer_.embree_share();
    stats.invalid_samples = invalid_before_ + renderer_.invalid();
    stats.samples = samples_of_tiles();
    stats.error = error();
    stats.samples_per_pixel = pixels_ > 0 ? double(stats.samples) / double(pixels_) : 0;
    return stats;
}

// One pixel of each tile, its place by the tile's number: enough to notice another scene.
std::vector<std::array<float, 3>> Rendering::first_samples() const {
    std::vector<std::array<float, 3>> colors(tiles_.size());
    parallel_for(tiles_.size(), 16, [&](std::size_t i) {
        const FlushDenormals flush;
        const Tile& tile = tiles_[i];
        const int pixel = static_cast<int>(i * 37 % static_cast<std::size_t>(area(tile)));
        const int width = tile.x1 - tile.x0;
        const Color color = renderer_.radiance(tile.x0 + pixel % width, tile.y0 + pixel / width, 0);
        colors[i] = {color.x, color.y, color.z};
    });
    return colors;
}

void Rendering::save(std::ostream& out) const {
    write_value(out, share_);
    write_value(out, invalid_before_ + renderer_.invalid());
    for (const Tile& tile : tiles_)
        write_value(out, tile);
    for (const std::array<float, 3>& color : first_samples())
        write_value(out, color);
    film_.save(out);
}

void Rendering::restore(std::istream& in) {
    const auto share = read_value<float>(in);
    const auto invalid = read_value<std::uint64_t>(in);
    std::vector<Tile> tiles(tiles_.size());
    for (Tile& tile : tiles)
        tile = read_value<Tile>(in);
    std::vector<std::array<float, 3>> before(tiles_.size());
    for (std::array<float, 3>& color : before)
        color = read_value<std::array<float, 3>>(in);
    Film film = film_;
    film.restore(in);
    if (!in || in.peek() != std::istream::traits_type::eof())
        throw Error("is not the state of a picture of this size");
    renderer_.set_share(share);
    if (first_samples() != before) {
        renderer_.set_share(share_);
        throw Error("is of another scene: samples that it holds are no longer the same");
    }
    share_ = share;
    invalid_before_ = invalid;
    film_ = std::move(film);
    tiles_ = std::move(tiles);
    for (Tile& tile : tiles_) {
        if (options_.noise > 0 && tile.passes == 0 && tile.row == 0)
            estimate_error(tile); // the run before had no limit
        tile.finished = tile.row == 0 && is_finished(tile);
    }
    progress_ = samples_of_tiles();
}

} // namespace scree
