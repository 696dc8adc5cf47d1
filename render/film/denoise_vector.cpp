// SPDX-License-Identifier: GPL-3.0-or-later
// Weights of NL-means in windows around pixels, and means and linear fits with these weights, for
// vectors of neighbouring pixels. For a tile the weights of all its windows are found first, one
// place in the window after the other.
#include "render/film/denoise_vector.h"

#include <hwy/aligned_allocator.h>

#include <array>
#include <cfloat>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/film/denoise_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int most_lanes = 16;
using Reals = hn::CappedTag<float, most_lanes>;
using V = hn::Vec<Reals>;

constexpr int tile_width = Planes::tile_width;
constexpr int tile_height = Planes::tile_height;
constexpr int patch_radius = 1;
static_assert(tile_width % most_lanes == 0);

/// How the distance between two pixels of a layer is measured.
struct Measure {
    float noise_scale; // k^2: how many times the noise a difference must be to count
    float tolerance;   // squared differences that do not count even without noise
};

/// The pixels of a layer from one on.
struct LayerPixels {
    LayerPixels(const Planes& layer, int x, int y)
        : channel{layer.at(0, x, y), layer.at(1, x, y), layer.at(2, x, y)},
          variance(layer.at(layer_variance, x, y)) {}

    std::array<const float*, 3> channel;
    const float* variance;
};

/// Squared difference of pixels to those `offset` further on, less what noise adds to it, over what
/// noise may make of it (Rousselle, Knaus & Zwicker 2012, equation 3), in the mean over channels.
HWY_INLINE V distance(const LayerPixels& p, std::ptrdiff_t i, std::ptrdiff_t offset,
                      const Measure& measure) {
    const Reals d;
    V square = hn::Zero(d);
    for (const float* channel : p.channel) {
        const V difference = hn::Sub(hn::LoadU(d, channel + i), hn::LoadU(d, channel + i + offset));
        square = hn::MulAdd(difference, difference, square);
    }
    const V here = hn::LoadU(d, p.variance + i);
    const V there = hn::LoadU(d, p.variance + i + offset);
    const V expected = hn::Add(here, hn::Min(here, there));
    const V scale = hn::MulAdd(hn::Set(d, measure.noise_scale), hn::Add(here, there),
                               hn::Set(d, measure.tolerance));
    return hn::Div(hn::NegMulAdd(hn::Set(d, 3.0F), expected, square),
                   hn::Mul(hn::Set(d, 3.0F), scale));
}

/// About exp(-x) for x >= 0, but 0 from 16 on: (1 - x / 16)^16.
HWY_INLINE V falloff(V x) {
    const Reals d;
    V power = hn::Max(hn::Zero(d), hn::NegMulAdd(x, hn::Set(d, 1.0F / 16), hn::Set(d, 1.0F)));
    for (int i = 0; i < 4; ++i)
        power = hn::Mul(power, power);
    return power;
}

/// The weights of the windows of a tile's pixels.
class Weights {
  public:
    explicit Weights(int radius)
        : radius_(radius),
          values_(hwy::AllocateAligned<float>(places() * std::size_t(tile_width * tile_height))) {}

    int radius() const { return radius_; }
    int side() const { return 2 * radius_ + 1; }
    std::size_t places() const { return std::size_t(side()) * std::size_t(side()); }
    float* row(std::size_t place, int y) {
        return &values_[(place * tile_height + std::size_t(y)) * tile_width];
    }
    const float* row(std::size_t place, int y) const {
        return &values_[(place * tile_height + std::size_t(y)) * tile_width];
    }
    std::ptrdiff_t offset(std::size_t place, std::ptrdiff_t stride) const {
        const int dy = int(place) / side() - radius_;
        const int dx = int(place) % side() - radius_;
        return dy * stride + dx;
    }

  private:
    int radius_;
    hwy::AlignedFreeUniquePtr<float[]> values_;
};

/// Mean distance of the patches of 3 x 3 pixels around the tile's pixels at x, y and around those
/// `offset` further on.
class PatchDistance {
  public:
    void measure(const Planes& layer, int x, int y, std::ptrdiff_t offset, const Measure& by) {
        const Reals d;
        for (int row = 0; row < tile_height + 2 * patch_radius; ++row) {
            const LayerPixels p(layer, x - patch_radius, y - patch_radius + row);
            for (std::size_t i = 0; i < width; i += hn::Lanes(d))
                hn::Store(distance(p, std::ptrdiff_t(i), offset, by), d, &values_[row][i]);
        }
    }

    /// Sets up `mean` for a row.
    void begin_row(int y) {
        const Reals d;
        for (std::size_t i = 0; i < width; i += hn::Lanes(d))
            hn::Store(hn::Add(hn::Add(hn::Load(d, &values_[y][i]), hn::Load(d, &values_[y + 1][i])),
                              hn::Load(d, &values_[y + 2][i])),
                      d, &columns_[i]);
    }
    HWY_INLINE V mean(std::size_t x) const {
        const Reals d;
        const V sum = hn::Add(hn::Add(hn::LoadU(d, &columns_[x]), hn::LoadU(d, &columns_[x + 1])),
                              hn::LoadU(d, &columns_[x + 2]));
        return hn::Mul(sum, hn::Set(d, 1.0F / 9));
    }

  private:
    static constexpr std::size_t width = tile_width + most_lanes;
    HWY_ALIGN std::array<std::array<float, width>, tile_height + 2 * patch_radius> values_;
    HWY_ALIGN std::array<float, width> columns_;
};

/// Weights by the patches of one layer; `extra(i, y, offset)` adds to the distance of the tile's
/// pixels from i on in row y.
template <class Extra>
HWY_INLINE void find_weights(const Planes& layer, const Planes& trust, int x, int y,
                             const Measure& measure, const Extra& extra, Weights& weights) {
    const Reals d;
    PatchDistance patches;
    for (std::size_t place = 0; place < weights.places(); ++place) {
        const std::ptrdiff_t offset = weights.offset(place, layer.stride());
        patches.measure(layer, x, y, offset, measure);
        for (int row = 0; row < tile_height; ++row) {
            patches.begin_row(row);
            const float* trusted = trust.at(0, x, y + row) + offset;
            float* to = weights.row(place, row);
            for (std::size_t i = 0; i < tile_width; i += hn::Lanes(d)) {
                const V far = hn::Add(hn::Max(hn::Zero(d), patches.mean(i)), extra(i, row, offset));
                hn::Store(hn::Mul(falloff(far), hn::LoadU(d, trusted + i)), d, to + i);
            }
        }
    }
}

constexpr int smooth_radius = 3;
constexpr Measure smooth_measure{0.36F, 1e-8F};

void smooth(const Planes& layer, const Planes& trust, Planes& smooth, int x, int y) {
    const Reals d;
    Weights weights(smooth_radius);
    find_weights(
        layer, trust, x, y, smooth_measure,
        [&](std::size_t, int, std::ptrdiff_t) HWY_ATTR { return hn::Zero(d); }, weights);
    for (int row = 0; row < tile_height; ++row)
        for (std::size_t i = 0; i < tile_width; i += hn::Lanes(d)) {
            const LayerPixels p(layer, x, y + row);
            V total = hn::Set(d, 1e-12F); // windows without samples
            std::array<V, 3> sum{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
            for (std::size_t place = 0; place < weights.places(); ++place) {
                const V weight = hn::Load(d, weights.row(place, row) + i);
                const std::ptrdiff_t offset = weights.offset(place, layer.stride());
                total = hn::Add(total, weight);
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] = hn::MulAdd(
                        weight, hn::LoadU(d, p.channel[c] + std::ptrdiff_t(i) + offset), sum[c]);
            }
            for (std::size_t c = 0; c < 3; ++c)
                hn::StoreU(hn::Div(sum[c], total), d, smooth.at(int(c), x, y + row) + i);
        }
}

constexpr float least_own_weight = 0.1F;
constexpr float least_weight = 0.01F; // of pixels that a fit must stay among

/// Weighted least squares for vectors of pixels: three channels of light as linear functions of six
/// features whose origin is the pixel, so that the value there is the constant.
class Fit {
  public:
    static constexpr float steepness = 2;
    static constexpr float least_slope = 1e-6F;
    static constexpr float least_spread = 1e-4F; // squared: features that vary less explain nothing
    static constexpr std::size_t features = 6;
    static constexpr std::size_t unknowns = features + 1; // the constant is the last

    void clear() {
        const Reals d;
        matrix_.fill({});
        right_.fill({});
        for (std::size_t c = 0; c < 3; ++c) {
            hn::Store(hn::Set(d, FLT_MAX), d, lowest_[c].values.data());
            hn::Store(hn::Zero(d), d, highest_[c].values.data());
        }
    }

    HWY_INLINE void add(V weight, const std::array<V, features>& at,
                        const std::array<V, 3>& light) {
        const Reals d;
        for (std::size_t k = 0; k < features; ++k) {
            const V weighted = hn::Mul(weight, at[k]);
            for (std::size_t l = 0; l <= k; ++l)
                increase(matrix_[cell(k, l)], weighted, at[l]);
            increase(matrix_[cell(features, k)], weighted, hn::Set(d, 1.0F));
            for (std::size_t c = 0; c < 3; ++c)
                increase(right_[3 * k + c], weighted, light[c]);
        }
        increase(matrix_[cell(features, features)], weight, hn::Set(d, 1.0F));
        for (std::size_t c = 0; c < 3; ++c)
            increase(right_[3 * features + c], weight, light[c]);
        const auto alike = hn::Ge(weight, hn::Set(d, least_weight));
        for (std::size_t c = 0; c < 3; ++c) {
            const V low = load(lowest_[c]);
            const V high = load(highest_[c]);
            hn::Store(hn::IfThenElse(alike, hn::Min(low, light[c]), low), d,
                      lowest_[c].values.data());
            hn::Store(hn::IfThenElse(alike, hn::Max(high, light[c]), high), d,
                      highest_[c].values.data());
        }
    }

    /// Answers the constants, after eliminating the features. Their coefficients are kept small
    /// (ridge regression, Hoerl & Kennard 1970) as far as light of this variance leaves them open,
    /// when they are expected to be about `steepness` times the mean light. What no pixel of some
    /// weight has is no answer: few pixels may be fitted beyond all sense.
    HWY_INLINE std::array<V, 3> solve(V variance) {
        const Reals d;
        const V weight = load(matrix_[cell(features, features)]);
        const V sum = hn::Add(hn::Add(load(right_[3 * features]), load(right_[3 * features + 1])),
                              load(right_[3 * features + 2]));
        const V slope =
            hn::MulAdd(hn::Div(sum, weight), hn::Set(d, steepness / 3), hn::Set(d, least_slope));
        const V penalty =
            hn::MulAdd(weight, hn::Set(d, least_spread), hn::Div(variance, hn::Mul(slope, slope)));
        for (std::size_t k = 0; k < features; ++k) {
            const V pivot = hn::Div(hn::Set(d, 1.0F), hn::Add(load(matrix_[cell(k, k)]), penalty));
            for (std::size_t i = k + 1; i < unknowns; ++i) {
                const V factor = hn::Neg(hn::Mul(load(matrix_[cell(i, k)]), pivot));
                for (std::size_t j = k + 1; j <= i; ++j)
                    increase(matrix_[cell(i, j)], factor, load(matrix_[cell(j, k)]));
                for (std::size_t c = 0; c < 3; ++c)
                    increase(right_[3 * i + c], factor, load(right_[3 * k + c]));
            }
        }
        const V total = load(matrix_[cell(features, features)]);
        std::array<V, 3> constants;
        for (std::size_t c = 0; c < 3; ++c)
            constants[c] = hn::Clamp(hn::Div(load(right_[3 * features + c]), total),
                                     load(lowest_[c]), load(highest_[c]));
        return constants;
    }

  private:
    // More vectors than there are registers, so they are kept in memory.
    struct HWY_ALIGN Lanes {
        std::array<float, most_lanes> values{};
    };
    static constexpr std::size_t cell(std::size_t row, std::size_t column) { // column <= row
        return row * (row + 1) / 2 + column;
    }
    static HWY_INLINE V load(const Lanes& lanes) { return hn::Load(Reals(), lanes.values.data()); }
    static HWY_INLINE void increase(Lanes& lanes, V a, V b) {
        hn::Store(hn::MulAdd(a, b, load(lanes)), Reals(), lanes.values.data());
    }

    std::array<Lanes, unknowns*(unknowns + 1) / 2> matrix_;
    std::array<Lanes, 3 * unknowns> right_;
    std::array<Lanes, 3> lowest_; // light of the pixels of some weight
    std::array<Lanes, 3> highest_;
};

constexpr int fit_radius = 7;
constexpr Measure light_measure{0.36F, 1e-8F};
constexpr Measure feature_measure{0.36F, 0.036F};

/// A pixel is like itself by its own noise: it counts as its most alike neighbour does (Buades,
/// Coll & Morel 2005), but where none is alike it must remain.
HWY_INLINE void weigh_own(Weights& weights, int row, std::size_t i) {
    const Reals d;
    const std::size_t own = weights.places() / 2;
    V most = hn::Set(d, least_own_weight);
    for (std::size_t place = 0; place < weights.places(); ++place)
        if (place != own)
            most = hn::Max(most, hn::Load(d, weights.row(place, row) + i));
    hn::Store(most, d, weights.row(own, row) + i);
}

void fit(const DenoiseLayers& layers, Planes& fitted, int x, int y) {
    const Reals d;
    Weights weights(fit_radius);
    find_weights(
        layers.light, layers.trust, x, y, light_measure,
        [&](std::size_t i, int row, std::ptrdiff_t offset) HWY_ATTR {
            const auto part = [&](const Planes& layer) HWY_ATTR {
                return hn::Max(hn::Zero(d), distance(LayerPixels(layer, x, y + row),
                                                     std::ptrdiff_t(i), offset, feature_measure));
            };
            return hn::Add(part(layers.albedo), part(layers.normal));
        },
        weights);
    Fit fit;
    for (int row = 0; row < tile_height; ++row) {
        const LayerPixels light(layers.light, x, y + row);
        const LayerPixels albedo(layers.albedo, x, y + row);
        const LayerPixels normal(layers.normal, x, y + row);
        const std::array<const float*, Fit::features> feature{albedo.channel[0], albedo.channel[1],
                                                              albedo.channel[2], normal.channel[0],
                                                              normal.channel[1], normal.channel[2]};
        for (std::size_t i = 0; i < tile_width; i += hn::Lanes(d)) {
            weigh_own(weights, row, i);
            fit.clear();
            for (std::size_t place = 0; place < weights.places(); ++place) {
                const V weight = hn::Load(d, weights.row(place, row) + i);
                if (hn::AllTrue(d, hn::Eq(weight, hn::Zero(d))))
                    continue;
                const std::ptrdiff_t here(i);
                const std::ptrdiff_t there = here + weights.offset(place, layers.light.stride());
                std::array<V, Fit::features> at;
                for (std::size_t k = 0; k < Fit::features; ++k)
                    at[k] =
                        hn::Sub(hn::LoadU(d, feature[k] + there), hn::LoadU(d, feature[k] + here));
                fit.add(weight, at,
                        {hn::LoadU(d, light.channel[0] + there),
                         hn::LoadU(d, light.channel[1] + there),
                         hn::LoadU(d, light.channel[2] + there)});
            }
            const std::array<V, 3> result = fit.solve(hn::LoadU(d, light.variance + i));
            for (std::size_t c = 0; c < 3; ++c)
                hn::StoreU(result[c], d, fitted.at(int(c), x, y + row) + i);
        }
    }
}

} // namespace scree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scree {

HWY_EXPORT(smooth);
HWY_EXPORT(fit);

void smooth_tile(const Planes& layer, const Planes& trust, Planes& smooth, int x, int y) {
    HWY_DYNAMIC_DISPATCH(smooth)(layer, trust, smooth, x, y);
}

void fit_tile(const DenoiseLayers& layers, Planes& fitted, int x, int y) {
    HWY_DYNAMIC_DISPATCH(fit)(layers, fitted, x, y);
}

} // namespace scree
#endif
