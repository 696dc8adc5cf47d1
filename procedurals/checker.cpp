// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/checker.h"

#include "procedurals/reflectance.h"

#include <algorithm>

namespace scree {

namespace {

// The integral of the square wave that is +1 on [0, 1) and -1 on [1, 2), with period 2.
double wave_integral(double x) {
    const double phase = x - 2 * std::floor(x / 2);
    return phase < 1 ? phase : 2 - phase;
}

// The mean of that wave over [x - w/2, x + w/2]: an exact box filter against aliasing (Heckbert
// 1986).
double filtered_wave(double x, double width) {
    width = std::max(width, 1e-6);
    return (wave_integral(x + width / 2) - wave_integral(x - width / 2)) / width;
}

class Checker final : public Procedural {
  public:
    explicit Checker(const Params& params)
        : size_(params.number("size")), even_(reflectance(params, "color_a")),
          odd_(reflectance(params, "color_b")),
          scales_with_object_(params.flag("scale_with_object")) {}

    bool solid() const override { return true; }
    bool scales_with_object() const override { return scales_with_object_; }

    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3& p = points[i].position;
            const double width = double(points[i].footprint) / size_;
            const double product = filtered_wave(double(p.x) / size_, width) *
                                   filtered_wave(double(p.z) / size_, width);
            const auto share = static_cast<float>(0.5 + 0.5 * product);
            ShadingSample sample;
            sample.color = even_ * share + odd_ * (1.0F - share);
            sample.value = share;
            samples[i] = sample;
        }
    }

  private:
    double size_;
    Color even_;
    Color odd_;
    bool scales_with_object_;
};

} // namespace

Plugin<MakeProcedural> checker_plugin() {
    return {
        "checker",
        "Squares of two colours on the object's x-z plane, box-filtered over the pixel.",
        {
            {.name = "size",
             .type = ParamType::number,
             .doc = "Side of a square.",
             .unit = "m",
             .fallback = 0.1,
             .min = 1e-4,
             .max = 1e4},
            {.name = "color_a",
             .type = ParamType::color,
             .doc = "Colour of the square at the origin.",
             .fallback = Color(0.8F, 0.8F, 0.8F)},
            {.name = "color_b",
             .type = ParamType::color,
             .doc = "Colour of its neighbours.",
             .fallback = Color(0.3F, 0.3F, 0.3F)},
            scale_with_object_spec(),
        },
        [](const Params& params) { return std::make_shared<Checker>(params); },
    };
}

} // namespace scree
