// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/subsurface.h"

#include "core/warps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace scree {

namespace {

// By simulation in a half space: of light in a white medium 2% takes so many steps (the mean is
// 160), in one of color 0.97 1%, half of which would be absorbed later, in one of 0.9 none.
constexpr int most_steps = 4096;

// Most walks are over by then.
constexpr int first_roulette = 16;

const Color white(1.0F, 1.0F, 1.0F);

float largest(const Color& c) { return std::max({c.x, c.y, c.z}); }

// The density with which each channel would have sampled the same walk. Only their ratios matter.
class ChannelDensities {
  public:
    ChannelDensities(const Color& mean_free_path, const Color& throughput, float choice) {
        const float sum = throughput.x + throughput.y + throughput.z;
        for (int c = 0; c < 3; ++c) {
            // A tenth is shared equally, so that weights are bounded in dark channels too.
            share_[c] = 0.9F * throughput[c] / sum + 0.1F / 3;
            extinction_[c] = 1 / mean_free_path[c];
        }
        chosen_ = choice < share_.x ? 0 : choice < share_.x + share_.y ? 1 : 2;
        grey_ = extinction_.x == extinction_.y && extinction_.y == extinction_.z;
    }

    /// Distance to the next scattering [m].
    float sample(Random& random) const {
        return static_cast<float>(random.exponential()) / extinction_[chosen_];
    }

    void pass(float distance) {
        if (grey_)
            return;
        const float least = std::min({extinction_.x, extinction_.y, extinction_.z});
        for (int c = 0; c < 3; ++c)
            density_[c] *= std::exp((least - extinction_[c]) * distance);
    }

    void scatter() {
        if (grey_)
            return;
        density_ *= extinction_;
        density_ /= largest(density_); // long walks would leave the range of floats
    }

    /// Each channel's density over that with which the walk was sampled.
    Color weight() const { return grey_ ? white : density_ / density_.dot(share_); }

  private:
    Color share_;      // chance of each channel to be the chosen one
    Color extinction_; // [1/m]
    Color density_ = white;
    int chosen_;
    bool grey_;
};

} // namespace

Walk walk_inside(const World& world, const Medium& medium, const Hit& entry, const Vec3& direction,
                 const Color& throughput, float choice, Random& random, std::uint64_t* clock) {
    ChannelDensities densities(medium.mean_free_path, throughput, choice);
    const bool from_outside = entry.normal.dot(direction) < 0;
    int parts = 1; // of the mesh that the light is in
    Walk walk;
    walk.weight = white;
    Ray ray = entry.leave(direction);
    Color left = white;
    for (int step = 0; step < most_steps; ++step) {
        ray.length = densities.sample(random);
        ++walk.rays;
        const std::optional<RawHit> met = world.find_within(entry.instance, ray, clock);
        if (!met) {
            walk.weight = medium.color;
            return walk;
        }
        if (met->found()) {
            densities.pass(met->distance);
            Hit hit;
            world.fill(ray, *met, hit);
            const bool goes_out = (hit.normal.dot(ray.direction) > 0) == from_outside;
            parts += goes_out ? -1 : 1;
            if (parts == 0) {
                walk.exit = *met;
                walk.exit.distance = (hit.position - entry.position).length();
                walk.direction = ray.direction;
                walk.origin = hit.position - ray.direction * walk.exit.distance;
                break;
            }
            ray = hit.leave(ray.direction);
            continue;
        }
        densities.pass(ray.length);
        densities.scatter();
        left *= medium.albedo;
        ray.origin += ray.direction * ray.length;
        const float u = random.uniform_float();
        ray.direction = warp::sphere(Vec2f(u, random.uniform_float()));
        if (step < first_roulette)
            continue;
        const float survival =
            std::min(1.0F, largest(throughput * left * densities.weight()) / largest(throughput));
        if (random.uniform_float() >= survival) {
            walk.weight = Color(0.0F, 0.0F, 0.0F);
            return walk;
        }
        left /= survival;
    }
    walk.weight = left * densities.weight();
    return walk;
}

} // namespace scree
