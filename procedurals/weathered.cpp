// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/weathered.h"

#include "geometry/rock/solid_noise.h"
#include "procedurals/lichen.h"
#include "procedurals/reflectance.h"

#include <algorithm>
#include <optional>

namespace scree {

namespace {

constexpr float water = 1.33F; // refractive index
constexpr float wet_roughness = 0.1F;
constexpr float dusty_roughness = 0.9F;
constexpr float dust_edge = radians(12.0F); // over which the slope stops dust
constexpr double dust_grain = 0.02;         // of the pattern in it [m]

float smooth(float t) {
    t = std::clamp(t, 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

template <class T>
T blend(const T& a, const T& b, float t) {
    return a + (b - a) * t;
}

/// The reflectance of a rough surface under a film of water: light is lost to the surface below
/// by total reflection inside of the film (Angstrom 1925; Lekner & Dorf 1988).
Color wetted(const Color& dry) {
    constexpr float outside = 0.02F; // Fresnel reflectance, straight on
    constexpr float inside = 0.07F;  // of diffuse light that would leave without total reflection
    constexpr float kept = 1 - (1 - inside) / (water * water);
    Color wet;
    for (int i = 0; i < 3; ++i)
        wet[i] = (1 - outside) * dry[i] * (1 - kept) / (1 - kept * dry[i]);
    return wet;
}

/// What weather and time do to a surface, by its slope and its height.
class Weathered final : public Procedural {
  public:
    explicit Weathered(const Params& params)
        : base_(params.object<Procedural>("base")), dust_(float(params.number("dust"))),
          dust_color_(reflectance(params, "dust_color")),
          steepest_dust_(float(params.number("dust_angle"))), wet_(float(params.number("wet"))),
          wet_edge_(float(params.number("wet_edge"))),
          lichen_color_(reflectance(params, "lichen_color")),
          lichen_other_(reflectance(params, "lichen_other")),
          dry_roughness_(float(params.number("roughness"))),
          seed_(static_cast<std::uint32_t>(params.integer("seed"))) {
        if (params.has("wet_below"))
            wet_below_ = float(params.number("wet_below"));
        if (params.number("lichen") > 0)
            lichen_.emplace(params.number("lichen"), params.number("lichen_size"), seed_);
        if (!lichen_ && dust_ == 0 && !wet_below_)
            throw params.error("lichen", "nothing weathers: lichen and dust are 0 and there is no "
                                         "wet_below");
    }

    bool scales_with_object() const override { return base_->scales_with_object(); }

    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        base_->evaluate(points, samples);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (lichen_)
                grow_lichen(points[i], samples[i]);
            if (dust_ > 0)
                lay_dust(points[i], samples[i]);
            if (wet_below_)
                wet(points[i], samples[i]);
        }
    }

  private:
    /// In [-1, 1] or so.
    float noise(const ShadingPoint& point, double wavelength, std::uint32_t which) const {
        if (double(point.footprint) > wavelength)
            return 0;
        return 2 * float(gradient_noise(WideVec3(point.position) / wavelength, seed_ + which));
    }

    void grow_lichen(const ShadingPoint& point, ShadingSample& sample) const {
        // It grows towards light: not on undersides, less on walls.
        const float exposure = smooth((point.up + 0.5F) / 1.2F);
        const Lichen::Seen lichen = lichen_->at(point.position, point.footprint, exposure);
        const Color color = blend(lichen_color_, lichen_other_, lichen.hue) * lichen.shade;
        sample.color = blend(sample.color, color, lichen.cover);
        sample.slope = blend(sample.slope, lichen.slope, lichen.cover);
        if (sample.roughness != ShadingSample::unset)
            sample.roughness = blend(sample.roughness, 1.0F, lichen.cover);
    }

    void lay_dust(const ShadingPoint& point, ShadingSample& sample) const {
        const float slope = std::acos(std::clamp(point.up, -1.0F, 1.0F));
        const float ragged = noise(point, dust_grain, 101) + noise(point, 5 * dust_grain, 102);
        const float limit = steepest_dust_ + dust_edge * ragged;
        const float cover = dust_ * smooth((limit - slope) / dust_edge);
        sample.color = blend(sample.color, dust_color_, cover);
        sample.slope *= 1 - 0.8F * cover;
        if (sample.roughness != ShadingSample::unset)
            sample.roughness = blend(sample.roughness, dusty_roughness, cover);
    }

    void wet(const ShadingPoint& point, ShadingSample& sample) const {
        const float line = *wet_below_ + wet_edge_ * noise(point, 4 * double(wet_edge_), 201);
        const float depth = line - point.level;
        const float by = wet_ * smooth(0.5F + depth / std::max(wet_edge_, point.footprint));
        sample.color = blend(sample.color, wetted(sample.color), by);
        const float dry =
            sample.roughness == ShadingSample::unset ? dry_roughness_ : sample.roughness;
        sample.roughness = blend(dry, wet_roughness, by);
    }

    std::shared_ptr<const Procedural> base_;
    std::optional<Lichen> lichen_;
    float dust_;
    Color dust_color_;
    float steepest_dust_;            // [rad]
    std::optional<float> wet_below_; // [m]
    float wet_;
    float wet_edge_; // [m]
    Color lichen_color_;
    Color lichen_other_;
    float dry_roughness_;
    std::uint32_t seed_;
};

} // namespace

Plugin<MakeProcedural> weathered_plugin() {
    return {
        "weathered",
        "Another procedural that weather has been at: lichen on what faces the light, dust on what "
        "is level, a foot that is wet.",
        {
            {.name = "base",
             .type = ParamType::object,
             .families = {"procedural"},
             .doc = "What is below."},
            {.name = "lichen",
             .type = ParamType::number,
             .doc = "Share of a surface that faces up which crusts of lichen cover.",
             .fallback = 0.0,
             .min = 0.0,
             .max = Lichen::most_cover},
            {.name = "lichen_size",
             .type = ParamType::number,
             .doc = "Of the largest crusts, across.",
             .unit = "m",
             .fallback = 0.06,
             .min = 1e-4,
             .max = 1e3},
            {.name = "lichen_color",
             .type = ParamType::color,
             .doc = "Of some crusts.",
             .fallback = Color(0.36F, 0.38F, 0.30F)},
            {.name = "lichen_other",
             .type = ParamType::color,
             .doc = "Of others; each is a mixture of its own.",
             .fallback = Color(0.52F, 0.50F, 0.42F)},
            {.name = "dust",
             .type = ParamType::number,
             .doc = "How thick dust covers what is level, from not at all to fully.",
             .fallback = 0.0,
             .min = 0.0,
             .max = 1.0},
            {.name = "dust_color",
             .type = ParamType::color,
             .doc = "Colour of the dust.",
             .fallback = Color(0.42F, 0.36F, 0.28F)},
            {.name = "dust_angle",
             .type = ParamType::number,
             .doc = "Slope on which no more dust stays.",
             .unit = "deg",
             .fallback = 40.0,
             .min = 1.0,
             .max = 90.0},
            {.name = "wet_below",
             .type = ParamType::number,
             .doc = "Height below which the surface is wet; above the scene's y = 0, not the "
                    "object's. Nothing is wet when not given.",
             .unit = "m",
             .optional = true},
            {.name = "wet",
             .type = ParamType::number,
             .doc = "How wet.",
             .fallback = 1.0,
             .min = 0.0,
             .max = 1.0},
            {.name = "wet_edge",
             .type = ParamType::number,
             .doc = "Height over which wet becomes dry.",
             .unit = "m",
             .fallback = 0.02,
             .min = 1e-4,
             .max = 1e3},
            {.name = "roughness",
             .type = ParamType::number,
             .doc = "Of the dry surface beside a wet one, where base has none of its own: a "
                    "material's own roughness is not used then.",
             .fallback = 0.7,
             .min = 0.0,
             .max = 1.0},
            {.name = "seed",
             .type = ParamType::integer,
             .doc = "Seed of the lichen and of ragged borders.",
             .fallback = 1.0},
        },
        [](const Params& params) { return std::make_shared<const Weathered>(params); },
    };
}

} // namespace scree
