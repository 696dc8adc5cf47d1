// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/render_scene.h"

#include "session/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace scree {

namespace {

using Clock = std::chrono::steady_clock;

/// Something that is done again and again.
class Every {
  public:
    /// 0: never.
    explicit Every(double seconds) : seconds_(seconds) {}

    double left() const {
        const std::chrono::duration<double> since = Clock::now() - last_;
        return seconds_ > 0 ? std::max(0.0, seconds_ - since.count())
                            : std::numeric_limits<double>::infinity();
    }
    bool due() const { return left() <= 0; }
    void done() { last_ = Clock::now(); }

  private:
    double seconds_;
    Clock::time_point last_ = Clock::now();
};

// Renders a picture with care.
class Carer {
  public:
    Carer(Session& session, const Scene& scene, const RenderOptions& options,
          const RenderCare& care)
        : watcher_(session.watcher()), care_(care), time_limit_(options.time_limit),
          checkpoint_(care.checkpoint, scene, options),
          saving_(care.checkpoint.empty() ? 0 : care.checkpoint_every),
          showing_(care.preview ? care.preview_every : 0) {}

    void run(Rendering& rendering) {
        begin(rendering);
        if (rendering.samples() == 0) {
            rendering.pass(); // at least one sample per pixel
            show(rendering);
        }
        while (!rendering.finished() && !rendering.cancelled() && time_left(rendering) > 0) {
            rendering.step(std::min({time_left(rendering), saving_.left(), showing_.left()}));
            if (saving_.due())
                save(rendering);
            if (showing_.due())
                show(rendering);
        }
        end(rendering);
    }

  private:
    double time_left(const Rendering& rendering) const {
        return time_limit_ > 0 ? time_limit_ - rendering.seconds()
                               : std::numeric_limits<double>::infinity();
    }

    void begin(Rendering& rendering) {
        if (care_.checkpoint.empty())
            return;
        if (!checkpoint_.exists()) {
            if (care_.resume)
                watcher_.say(checkpoint_.path() + " is not there: the render begins anew");
        } else if (care_.resume) {
            checkpoint_.read(rendering);
            watcher_.say(fmt::format("resumes {} at {:.1f} samples per pixel", checkpoint_.path(),
                                     rendering.stats().samples_per_pixel));
        } else {
            watcher_.warn(fmt::format("{} of an interrupted render will be overwritten; "
                                      "--resume would continue it",
                                      checkpoint_.path()));
        }
    }

    // A full disk must not end a render of hours.
    void save(const Rendering& rendering) {
        try {
            checkpoint_.write(rendering);
        } catch (const Error& error) {
            watcher_.warn(std::string("no checkpoint: ") + error.what());
        }
        saving_.done();
    }

    void show(const Rendering& rendering) {
        if (care_.preview)
            care_.preview(rendering.film());
        showing_.done();
    }

    void end(const Rendering& rendering) {
        if (care_.checkpoint.empty())
            return;
        if (care_.resume || !rendering.finished() || rendering.cancelled())
            save(rendering);
    }

    Watcher& watcher_;
    const RenderCare& care_;
    double time_limit_;
    Checkpoint checkpoint_;
    Every saving_;
    Every showing_;
};

} // namespace

Rendered render_scene(Session& session, const Scene& scene, const RenderOptions& options,
                      const RenderCare& care) {
    session.stages().begin("build");
    const World world(scene.aggregates, scene.lights, session.context("build"),
                      world_origin(scene.camera.value()));
    session.stages().begin("render");
    const Context context = session.context("render");
    const KeepingWork keeping(context.cancel);
    Rendering rendering(world, scene.camera.value(), scene.film, options, context);
    Carer(session, scene, options, care).run(rendering);
    session.stages().end();
    const bool is_spent = rendering.finished() && !rendering.cancelled() && !care.resume;
    const RenderFigures figures{rendering.stats(), world.instance_count(), world.memory_bytes(),
                                world.strand_figures()};
    return {{rendering.take_film(), figures.stats, rendering.cancelled()},
            figures,
            {world.materials().begin(), world.materials().end()},
            is_spent ? care.checkpoint : std::string()};
}

} // namespace scree
