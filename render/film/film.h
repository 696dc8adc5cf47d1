// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "render/film/matte_samples.h"
#include "render/film/path_sample.h"

#include <cstddef>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

namespace scree {

/// What a film keeps only where it is asked for.
struct FilmExtras {
    std::vector<std::string> light_groups{}; // their names: a picture of each
    bool mattes = false;                     // which instances and materials are seen, and how much
};

/// Running mean and variance per pixel (Welford 1962), and pictures of what the first hits were.
/// Different pixels may be written by different threads.
class Film {
  public:
    /// `origin` is added to the samples' positions (see World).
    Film(int width, int height, const WideVec3& origin = WideVec3(0), FilmExtras extras = {});

    int width() const { return width_; }
    int height() const { return height_; }

    /// Adds one sample to a pixel; `depth` is that of sample.position, `groups` are the light
    /// groups' shares of its radiance. Drops it and answers false when a value is not finite or
    /// negative.
    bool add(int x, int y, const PathSample& sample, float depth,
             std::span<const Color> groups = {});

    /// Writes everything that was added, for films of the same size and extras, program and
    /// machine.
    void save(std::ostream& out) const;

    /// Reads it; the stream has failed when it does not hold all of it.
    void restore(std::istream& in);

    std::size_t light_groups() const { return extras_.light_groups.size(); }
    bool has_mattes() const { return extras_.mattes; }

    /// What a pixel's samples met first; only with mattes.
    std::span<const Seen> seen(int x, int y) const { return mattes_.at(index(x, y)); }

    std::uint32_t samples(int x, int y) const { return at(x, y).count; }

    double luminance_at(int x, int y) const; // mean

    /// The variance of the mean, were the samples independent and of one hue.
    double luminance_variance(int x, int y) const;

    /// The squared difference of the mean luminance of a pixel's two halves (see Halves), times
    /// what makes it the variance of the whole mean if the halves are independent: 1/4 for halves
    /// of the same size. The same for the halves of the first half; 0 if it has one sample.
    struct Differences {
        double halves = 0;
        double quarters = 0;
    };
    Differences differences(int x, int y) const;

    /// Means over some of a pixel's samples; zeros without any.
    struct Means {
        std::uint32_t samples = 0;
        Color radiance{0.0F, 0.0F, 0.0F};
        Color albedo{0.0F, 0.0F, 0.0F}; // of the first surface; 1 for the background
        Vec3 normal{0.0F, 0.0F, 0.0F};
    };
    /// A pixel's samples, and the two halves that they are divided into: as many as the largest
    /// power of two below their number, and those after. Both halves are well stratified.
    struct Halves {
        Means all, first, rest;
        Color variance{0.0F, 0.0F, 0.0F}; // of the mean radiance, were the samples independent
    };
    Halves halves(int x, int y) const;

    Image beauty() const; // R, G, B, A; black where there is no sample

    /// The beauty first, then albedo and N (means over the samples), Z, P and instance (of the
    /// first sample, so that edges do not mix; instance counts from 1, 0 is the background),
    /// variance (of the beauty's mean; too high by what stratification gains), and light_NAME for
    /// every light group, which together are the beauty.
    std::vector<ImagePart> parts() const;

  private:
    struct Pixel {
        double mean[3] = {};
        double square[3] = {};          // sum of squared deviations
        Color albedo{0.0F, 0.0F, 0.0F}; // sums
        Vec3 normal{0.0F, 0.0F, 0.0F};
        Vec3 position{0.0F, 0.0F, 0.0F};
        float depth = 0;
        float covered = 0;
        // Sums over the first samples, as many as the largest power of two below the count: that
        // many and the rest are both evenly spread.
        Color first_radiance{0.0F, 0.0F, 0.0F};
        Color first_albedo{0.0F, 0.0F, 0.0F}; // as in Means
        Vec3 first_normal{0.0F, 0.0F, 0.0F};
        float quarter_luminance = 0; // the sum over the first half of these
        std::uint32_t instance = 0;
        std::uint32_t count = 0;
    };
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }
    const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }
    Image light_group(std::size_t group) const;
    template <class Value>
    Image picture(std::vector<std::string> channels, const Value& value) const;

    int width_;
    int height_;
    WideVec3 origin_;
    FilmExtras extras_;
    std::vector<Pixel> pixels_;
    std::vector<Color> group_sums_; // by pixel and group
    MatteSamples mattes_;
};

} // namespace scree
