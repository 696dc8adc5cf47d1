// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/ramp.h"

#include "core/error.h"
#include "procedurals/reflectance.h"

#include <algorithm>

namespace scree {

namespace {

struct Stop {
    float at = 0;
    Color color;
    Color other; // for instances whose random number is 1
};

/// A piecewise linear colour ramp, constant beyond its ends.
class Ramp final : public Procedural {
  public:
    Ramp(const Vec3& from, const Vec3& to, std::vector<Stop> stops)
        : from_(from), per_metre_((to - from) / (to - from).length2()), stops_(std::move(stops)) {
        for (const Stop& stop : stops_)
            varies_ = varies_ || stop.color != stop.other;
    }

    bool solid() const override { return !varies_; }
    bool scales_with_object() const override { return true; } // its ends are places of the object

    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const ShadingPoint& p = points[i];
            const float at = (p.position - from_).dot(per_metre_);
            const float across = p.across.dot(per_metre_);
            const float along = p.along.dot(per_metre_);
            const float width = std::max(std::sqrt(across * across + along * along), 1e-4F);
            ShadingSample sample;
            sample.color =
                (integral(at + width / 2, p.random) - integral(at - width / 2, p.random)) / width;
            sample.value = std::clamp(at, 0.0F, 1.0F);
            samples[i] = sample;
        }
    }

  private:
    // The integral of the colour from the first stop to x; negative before the stop.
    Color integral(float x, float random) const {
        const auto color = [&](const Stop& stop) {
            return stop.color * (1 - random) + stop.other * random;
        };
        Color sum = color(stops_.front()) * (std::min(x, stops_.front().at) - stops_.front().at);
        for (std::size_t k = 1; k < stops_.size() && x > stops_[k - 1].at; ++k) {
            const float width = stops_[k].at - stops_[k - 1].at;
            const float part = std::min(x, stops_[k].at) - stops_[k - 1].at;
            const float slope = width > 0 ? part / width / 2 : 0.0F;
            sum += (color(stops_[k - 1]) * (1 - slope) + color(stops_[k]) * slope) * part;
        }
        return sum + color(stops_.back()) * std::max(0.0F, x - stops_.back().at);
    }

    Vec3 from_;
    Vec3 per_metre_; // along the ramp [1/m]
    std::vector<Stop> stops_;
    bool varies_ = false;
};

std::shared_ptr<const Procedural> make_ramp(const Params& params) {
    const Vec3& from = params.vector3("from");
    const Vec3& to = params.vector3("to");
    if (!((to - from).length() > 1e-9F))
        throw params.error("to", "is the same point as from");
    std::vector<Stop> stops;
    for (const Params& given : params.list("stops")) {
        const Color color = reflectance(given, "color");
        stops.push_back({static_cast<float>(given.number("at")), color,
                         given.has("other") ? reflectance(given, "other") : color});
        if (stops.size() > 1 && stops.back().at < stops[stops.size() - 2].at)
            throw given.error("at", "lies before that of the stop before");
    }
    return std::make_shared<const Ramp>(from, to, std::move(stops));
}

} // namespace

Plugin<MakeProcedural> ramp_plugin() {
    return {
        "ramp",
        "Colours along a line through the object, constant beyond its ends, box-filtered over "
        "the pixel.",
        {{.name = "from",
          .type = ParamType::vector3,
          .doc = "Start of the ramp in the object's frame.",
          .unit = "m"},
         {.name = "to", .type = ParamType::vector3, .doc = "End of the ramp.", .unit = "m"},
         {.name = "stops",
          .type = ParamType::list,
          .doc = "Colours in order of their position along the ramp.",
          .fields = {{.name = "at",
                      .type = ParamType::number,
                      .doc = "Position as a share of the ramp.",
                      .min = 0.0,
                      .max = 1.0},
                     {.name = "color", .type = ParamType::color, .doc = "Colour at this position."},
                     {.name = "other",
                      .type = ParamType::color,
                      .doc = "Every instance has a random mixture of the two colours; the "
                             "same as color when not given.",
                      .optional = true}},
          .min_items = 1}},
        make_ramp};
}

} // namespace scree
