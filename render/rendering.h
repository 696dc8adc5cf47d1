// SPDX-License-Identifier: GPL-3.0-or-later
// A picture in the making.
#pragma once

#include "core/context.h"
#include "core/parallel.h"
#include "render/pixel_renderer.h"
#include "render/tiles.h"

#include <array>
#include <chrono>
#include <iosfwd>
#include <mutex>

namespace scree {

/// A picture that is rendered step by step and can be saved in between. The pixels do not depend on
/// how the work is cut into steps, threads, shards and resumed runs.
class Rendering {
  public:
    /// `world` must outlive this. Throws Error (usage) on a crop outside of the picture.
    Rendering(const World& world, const Camera& camera, const FilmSettings& settings,
              const RenderOptions& options, const Context& context = {});

    /// Renders until about `seconds` have passed, until it is finished or cancelled. Reports to the
    /// context's progress.
    void step(double seconds);

    /// Renders one pass: the tiles with the fewest samples get as many again, at least one and at
    /// most 64.
    void pass();

    bool finished() const; // every pixel has all samples that were asked for, or little noise
    bool cancelled() const { return context_.cancel != nullptr && context_.cancel->requested(); }
    int samples() const; // of every pixel, but for those that are finished with fewer
    const Film& film() const { return film_; }
    Film take_film() { return std::move(film_); } // ends it: `stats` before
    double seconds() const { return seconds_; }   // that it has rendered
    RenderStats stats() const;

    /// Writes the state, from which `restore` goes on.
    void save(std::ostream& out) const;

    /// Continues from a saved state of the same picture (scene, size, crop, shard and seed), also
    /// for more samples or less noise. Some samples are rendered again to compare them: throws
    /// Error (input) when they differ, or when the state is not complete; this is as new then.
    void restore(std::istream& in);

  private:
    using Clock = std::chrono::steady_clock;

    bool must_stop(Clock::time_point deadline) const {
        return cancelled() || Clock::now() >= deadline;
    }
    void pass_until(Clock::time_point deadline);
    void render_tile(Tile& tile, Clock::time_point deadline);
    bool is_finished(const Tile& tile) const;
    void estimate_error(Tile& tile) const;
    int next_samples(const Tile& tile) const;
    std::uint64_t samples_of_tiles() const;
    double error() const;
    std::vector<std::array<float, 3>> first_samples() const;
    void report();

    RenderOptions options_;
    Context context_;
    std::optional<ThreadLimit> threads_;
    Crop crop_;
    int samples_; // per pixel
    float share_; // width of a sample among those of its pixel
    PixelRenderer renderer_;
    Film film_;
    std::vector<Tile> tiles_;
    std::uint64_t pixels_ = 0; // of the tiles
    Clock::time_point pass_start_{};
    double seconds_ = 0; // of the passes before
    double cpu_seconds_ = 0;
    std::uint64_t invalid_before_ = 0;        // of the runs that this one resumed
    std::atomic<std::uint64_t> progress_ = 0; // samples of all pixels
    std::mutex progress_mutex_;
};

} // namespace scree
