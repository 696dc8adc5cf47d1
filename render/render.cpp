// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/render.h"

#include "core/error.h"
#include "core/parallel.h"
#include "render/film/filter.h"
#include "render/world/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <mutex>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace scree {

namespace {

constexpr int tile_side = 16;           // pixels; 256 pixels keep a thread busy for milliseconds
constexpr int longest_pass = 64;        // samples; short enough to keep limits of time and noise
constexpr int min_samples_noise = 16;   // fewer say too little about the error
constexpr std::size_t batch_size = 6;   // paths traced together: measured, 4 and 16 are slower
constexpr std::size_t timed_batch = 13; // every 13th is timed; prime: no pattern with tiles

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

struct Tile {
    int x0, y0, x1, y1;
    int done = 0;          // samples that each of its pixels has
    bool finished = false; // all that were asked for, or enough to be free of noise
};

std::vector<Tile> cut(int width, int height) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += tile_side)
        for (int x = 0; x < width; x += tile_side)
            tiles.push_back(
                {x, y, std::min(x + tile_side, width), std::min(y + tile_side, height)});
    return tiles;
}

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

// The width that one of a pixel's samples stands for, as a share of the pixel's: textures are
// filtered by it, and the mean of the samples filters them over the rest of the pixel. N samples
// share the pixel's area, so it is 1 / sqrt(N), by the number asked for: the same for every tile
// and thread. Runs that a time limit or the noise may end sooner use the fewest samples after which
// such a run may end. Below an eighth there is nothing to gain: a box so wide adds 1% to the
// variance of the film's default filter.
float sample_width(int samples, const RenderOptions& options) {
    if (options.time_limit > 0 || options.noise > 0)
        samples = std::min(samples, min_samples_noise);
    return std::max(0.125F, 1 / std::sqrt(static_cast<float>(samples)));
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// One call of render().
class Job {
  public:
    Job(const World& world, const Camera& camera, const FilmSettings& settings,
        const RenderOptions& options, const Context& context)
        : options_(options), context_(context), crop_(checked_crop(settings, options.crop)),
          rays_(camera, settings.width, settings.height, world.origin()),
          filter_(settings.filter, settings.radius),
          integrator_(world, settings.depth, settings.clamp, options.mis),
          samples_(options.samples > 0 ? options.samples : settings.samples),
          share_(sample_width(samples_, options)), spread_(rays_.pixel_spread() * share_),
          film_(crop_.width, crop_.height, world.origin()), tiles_(cut(crop_.width, crop_.height)) {
    }

    RenderResult run();

  private:
    class Batch;

    bool cancelled() const { return context_.cancel != nullptr && context_.cancel->requested(); }
    bool must_stop(const Tile& tile) const {
        return cancelled() || (options_.time_limit > 0 && tile.done > 0 &&
                               seconds_since(start_) > options_.time_limit);
    }
    void pass(int samples);
    void render_tile(Tile& tile, int samples);
    /// Of the samples per pixel that passes have asked for, those that all unfinished tiles have.
    int least_done(int asked) const;
    void report();

    const RenderOptions& options_;
    const Context& context_;
    Crop crop_;
    CameraRays rays_;
    FilterSampler filter_;
    Integrator integrator_;
    int samples_;
    float share_;  // width of a sample among those of its pixel
    float spread_; // of one sample's filter, per metre of way
    Film film_;
    std::vector<Tile> tiles_;
    Clock::time_point start_ = Clock::now();
    std::atomic<std::uint64_t> ray_count_ = 0;
    std::atomic<std::uint64_t> invalid_ = 0;
    std::atomic<std::uint64_t> embree_ticks_ = 0;
    std::atomic<std::uint64_t> timed_ticks_ = 0;
    std::atomic<std::uint64_t> pixel_samples_ = 0;
    std::mutex progress_mutex_;
};

// The paths of a few samples, of one or more pixels, traced together.
class Job::Batch {
  public:
    Batch(Job& job, std::size_t first_number) : job_(job), number_(first_number) {
        paths_.reserve(batch_size);
        pixels_.reserve(batch_size);
    }

    void add(int x, int y, int sample) {
        if (paths_.empty())
            begin();
        const int px = x + job_.crop_.x;
        const int py = y + job_.crop_.y;
        const Sampler sampler(job_.options_.seed, px, py, static_cast<std::uint32_t>(sample));
        const Vec2f offset = job_.filter_.offset(sampler.pair(dimension::film));
        paths_.emplace_back(job_.rays_.ray(static_cast<float>(px) + 0.5F + offset.x,
                                           static_cast<float>(py) + 0.5F + offset.y,
                                           sampler.pair(dimension::lens)),
                            job_.spread_, sampler);
        pixels_.push_back({x, y});
        if (paths_.size() == batch_size)
            flush();
    }

    void flush() {
        job_.integrator_.trace(paths_, job_.share_, count_);
        for (std::size_t i = 0; i < paths_.size(); ++i) {
            const PathSample& sample = paths_[i].sample();
            if (!job_.film_.add(pixels_[i].x, pixels_[i].y, sample,
                                job_.rays_.depth(sample.position)))
                ++invalid_;
        }
        done_ += paths_.size();
        if (count_.clock != nullptr)
            whole_ += ticks() - start_;
        paths_.clear();
        pixels_.clear();
        ++number_;
    }

    /// Adds what was counted to the job's sums.
    void report() const {
        job_.ray_count_ += count_.rays;
        job_.invalid_ += invalid_;
        job_.embree_ticks_ += embree_;
        job_.timed_ticks_ += whole_;
        job_.pixel_samples_ += done_;
    }

  private:
    struct Pixel {
        int x, y;
    };

    void begin() {
        count_.clock = number_ % timed_batch == 0 ? &embree_ : nullptr;
        if (count_.clock != nullptr)
            start_ = ticks();
    }

    Job& job_;
    std::size_t number_;
    std::vector<Path> paths_;
    std::vector<Pixel> pixels_;
    RayCount count_;
    std::uint64_t start_ = 0;
    std::uint64_t embree_ = 0;
    std::uint64_t whole_ = 0;
    std::uint64_t invalid_ = 0;
    std::uint64_t done_ = 0;
};

void Job::render_tile(Tile& tile, int samples) {
    const FlushDenormals flush;
    const int end = std::min(tile.done + samples, samples_);
    Batch batch(*this, static_cast<std::size_t>(tile.x0 / tile_side + tile.y0 + tile.done));
    int y = tile.y0;
    for (; y < tile.y1 && !cancelled(); ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
            for (int s = tile.done; s < end; ++s)
                batch.add(x, y, s);
    batch.flush();
    batch.report();
    if (y < tile.y1)
        return; // cancelled: the rows below still have the samples of the last pass
    tile.done = end;
    tile.finished = end >= samples_ ||
                    (options_.noise > 0 && end >= min_samples_noise &&
                     film_.relative_error(tile.x0, tile.y0, tile.x1, tile.y1) < options_.noise);
}

void Job::report() {
    if (!context_.progress)
        return;
    const std::unique_lock lock(progress_mutex_, std::try_to_lock);
    if (!lock.owns_lock())
        return;
    const double done =
        double(pixel_samples_.load()) / (double(crop_.width) * double(crop_.height));
    context_.report(fmt::format("{:.1f} of {} samples, {:.2f} Mray/s", done, samples_,
                                double(ray_count_.load()) / seconds_since(start_) * 1e-6),
                    std::min(1.0, done / samples_));
}

int Job::least_done(int asked) const {
    int least = asked;
    for (const Tile& tile : tiles_)
        if (!tile.finished)
            least = std::min(least, tile.done);
    return least;
}

void Job::pass(int samples) {
    parallel_for(tiles_.size(), 1, [&](std::size_t i) {
        Tile& tile = tiles_[i];
        if (tile.finished || must_stop(tile))
            return;
        render_tile(tile, samples);
        report();
    });
}

RenderResult Job::run() {
    const std::clock_t cpu = std::clock();
    int done = 0;
    bool stop = false;
    while (!stop) {
        const int samples = std::clamp(done, 1, longest_pass);
        pass(samples);
        done += samples;
        if (options_.on_pass)
            options_.on_pass(film_, least_done(std::min(done, samples_)));
        stop = std::all_of(tiles_.begin(), tiles_.end(),
                           [&](const Tile& tile) { return tile.finished || must_stop(tile); });
    }
    RenderStats stats;
    stats.rays = ray_count_;
    stats.seconds = seconds_since(start_);
    stats.cpu_seconds = double(std::clock() - cpu) / CLOCKS_PER_SEC;
    stats.embree_share =
        timed_ticks_ > 0 ? double(embree_ticks_.load()) / double(timed_ticks_.load()) : 0;
    stats.invalid_samples = invalid_;
    stats.samples_per_pixel =
        double(pixel_samples_.load()) / (double(crop_.width) * double(crop_.height));
    const bool was_cancelled = cancelled();
    return {std::move(film_), stats, was_cancelled};
}

} // namespace

RenderResult render(const World& world, const Camera& camera, const FilmSettings& settings,
                    const RenderOptions& options, const Context& context) {
    std::optional<ThreadLimit> limit;
    if (options.threads > 0)
        limit.emplace(options.threads);
    return Job(world, camera, settings, options, context).run();
}

} // namespace scree
