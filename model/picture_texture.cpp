// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/picture_texture.h"

#include <algorithm>

namespace scree {

namespace {

// Below this alpha the premultiplied colour consists of rounding errors only (8 bits hold 1/255).
constexpr float least_alpha = 1.0F / 512;

class PictureTexture final : public Procedural {
  public:
    PictureTexture(std::shared_ptr<const PictureFilter> picture, const PictureLook& look)
        : filter_(std::move(picture)), look_(look) {
        const Imath::M33d& m = look.picture_from_uv;
        scale_ = std::sqrt(std::abs(m[0][0] * m[1][1] - m[0][1] * m[1][0]));
    }

    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 uv = Vec2(points[i].uv) * look_.picture_from_uv;
            samples[i] = {color(uv, double(points[i].uv_footprint) * scale_) * look_.tint, 0.0F};
        }
    }

  private:
    Color color(const Vec2& uv, double width) const {
        Rgba found = filter_->trilinear(uv, width);
        if (look_.ground) {
            const Color under = *look_.ground * (1 - found[3]);
            return {found[0] + under.x, found[1] + under.y, found[2] + under.z};
        }
        // Coarser mip levels include opaque texels farther away.
        for (width = std::max(width, 1.0 / filter_->level(0).width);
             found[3] < least_alpha && width < 2; width *= 2)
            found = filter_->trilinear(uv, width);
        if (found[3] < least_alpha)
            return Color(0.0F);
        return {found[0] / found[3], found[1] / found[3], found[2] / found[3]};
    }

    std::shared_ptr<const PictureFilter> filter_;
    PictureLook look_;
    double scale_; // of lengths, from UVs to the picture
};

} // namespace

std::shared_ptr<const Procedural> picture_texture(std::shared_ptr<const PictureFilter> picture,
                                                  const PictureLook& look) {
    return std::make_shared<PictureTexture>(std::move(picture), look);
}

std::shared_ptr<const Procedural> picture_texture(const Image& picture) {
    return picture_texture(std::make_shared<const PictureFilter>(picture, Beyond::clamped));
}

} // namespace scree
