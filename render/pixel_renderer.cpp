// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pixel_renderer.h"

#include "render/world/ticks.h"

#include <algorithm>

namespace scree {

namespace {

constexpr std::size_t batch_size = 6;   // paths traced together: measured, 4 and 16 are slower
constexpr std::size_t timed_batch = 13; // every 13th is timed; prime: no pattern with tiles

} // namespace

PixelRenderer::PixelRenderer(const World& world, const Camera& camera, const FilmSettings& settings,
                             const RenderOptions& options, const Crop& crop)
    : seed_(options.seed), crop_(crop),
      camera_(camera, settings.width, settings.height, world.origin()),
      filter_(settings.filter, settings.radius), integrator_(world, settings, options.mis) {
    set_share(1);
}

void PixelRenderer::set_share(float share) {
    share_ = share;
    spread_ = camera_.pixel_spread() * share;
}

Path PixelRenderer::path(int x, int y, int sample, Color* groups) const {
    const int px = x + crop_.x;
    const int py = y + crop_.y;
    const Sampler sampler(seed_, px, py, static_cast<std::uint32_t>(sample));
    const Vec2f offset = filter_.offset(sampler.pair(dimension::film));
    return {camera_.ray(static_cast<float>(px) + 0.5F + offset.x,
                        static_cast<float>(py) + 0.5F + offset.y, sampler.pair(dimension::lens)),
            spread_, sampler, groups};
}

Color PixelRenderer::radiance(int x, int y, int sample) const {
    Path one = path(x, y, sample);
    RayCount ignored;
    integrator_.trace({&one, 1}, share_, ignored);
    return one.sample().radiance;
}

double PixelRenderer::embree_share() const {
    return timed_ticks_ > 0 ? double(embree_ticks_.load()) / double(timed_ticks_.load()) : 0;
}

PixelRenderer::Batch::Batch(PixelRenderer& renderer, Film& film, std::size_t number)
    : renderer_(renderer), film_(film), number_(number) {
    paths_.reserve(batch_size);
    groups_.resize(batch_size * film.light_groups());
    pixels_.reserve(batch_size);
}

PixelRenderer::Batch::~Batch() {
    renderer_.rays_ += count_.rays;
    renderer_.invalid_ += invalid_;
    renderer_.embree_ticks_ += embree_;
    renderer_.timed_ticks_ += whole_;
}

void PixelRenderer::Batch::begin() {
    count_.clock = number_ % timed_batch == 0 ? &embree_ : nullptr;
    if (count_.clock != nullptr)
        start_ = ticks();
}

void PixelRenderer::Batch::add(int x, int y, int sample) {
    if (paths_.empty())
        begin();
    Color* const groups =
        groups_.empty() ? nullptr : &groups_[paths_.size() * film_.light_groups()];
    paths_.push_back(renderer_.path(x, y, sample, groups));
    pixels_.push_back({x, y});
    if (paths_.size() == batch_size)
        flush();
}

void PixelRenderer::Batch::flush() {
    std::fill(groups_.begin(), groups_.end(), Color(0.0F));
    renderer_.integrator_.trace(paths_, renderer_.share_, count_);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        const PathSample& sample = paths_[i].sample();
        if (!film_.add(pixels_[i].x, pixels_[i].y, sample, renderer_.camera_.depth(sample.position),
                       std::span(groups_).subspan(i * film_.light_groups(), film_.light_groups())))
            ++invalid_;
    }
    if (count_.clock != nullptr)
        whole_ += ticks() - start_;
    paths_.clear();
    pixels_.clear();
    ++number_;
}

} // namespace scree
