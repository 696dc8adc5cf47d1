// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/material.h"
#include "render/bsdf/bsdf.h"
#include "render/bsdf/medium.h"
#include "render/bsdf/painted.h"

namespace scree {

/// What is under a surface through which light walks.
class Subsurface {
  public:
    /// Where the surface has this colour.
    virtual Medium medium(const Color& color) const = 0;

    /// How the surface scatters the light that comes out from under it, as if seen from straight
    /// above.
    virtual Bsdf emerging(const Painted& painted) const = 0;

  protected:
    ~Subsurface() = default;
};

/// A material made ready for rendering: one object for all its hits. Thread-safe.
class PreparedMaterial {
  public:
    virtual ~PreparedMaterial() = default;

    const Paint& paint() const { return paint_; }

    /// How a place that is painted so scatters light; `outside`: the viewer is on the outer side.
    /// Called for every hit.
    virtual Bsdf bsdf(const Painted& painted, bool outside) const = 0;

    /// Of light on its way behind the surface [1/m].
    virtual Color absorption() const { return Color(0.0F); }

    /// Null unless the light that the surface lets in walks through a medium.
    virtual const Subsurface* subsurface() const { return nullptr; }

  protected:
    explicit PreparedMaterial(Paint paint) : paint_(std::move(paint)) {}

  private:
    Paint paint_;
};

/// A material whose places differ in their colour alone.
template <class L>
class ColoredLobe final : public PreparedMaterial {
  public:
    explicit ColoredLobe(Paint paint) : PreparedMaterial(std::move(paint)) {}

    Bsdf bsdf(const Painted& painted, bool /*outside*/) const override {
        return {&lobe_, painted.color};
    }

  private:
    L lobe_;
};

} // namespace scree
