// SPDX-License-Identifier: GPL-3.0-or-later
// A solid texture implemented in a .cl file: evaluated on the host at shading time, and on the host
// or on an OpenCL device for baking.
#pragma once

#include "model/procedural.h"
#include "procedurals/solid/lattice/fractal_lattice.h"
#include "procedurals/solid/solid_as_cpp.h"

namespace scree {

/// The OpenCL source of a texture and the names of its settings type and its function.
struct SolidKernel {
    const char* source;
    const char* settings_type;
    const char* function;
};

inline solid::SolidPoint solid_point(const ShadingPoint& point) {
    const auto triple = [](const Vec3& v) { return solid::Triple{v.x, v.y, v.z}; };
    return {triple(point.position), triple(point.across), triple(point.along), point.random};
}

inline ShadingSample shading_sample(const solid::SolidSample& sample) {
    const auto vec = [](const solid::Triple& t) { return Vec3(t.x, t.y, t.z); };
    return {vec(sample.color), sample.height, vec(sample.slope),
            sample.roughness < 0 ? ShadingSample::unset : sample.roughness, sample.value};
}

/// Evaluates a texture on a device. Throws Error (resource) when the device fails.
void run_solid_kernel(Device& device, const SolidKernel& kernel,
                      std::span<const std::byte> settings, const FractalLattice& lattice,
                      std::span<const ShadingPoint> points, std::span<ShadingSample> samples);

/// A function of a .cl file, also compiled for processors with AVX2, with all that it calls
/// inlined. No operation is fused or reordered, so that both give the same bits.
template <class Settings, auto Function>
struct SolidFunction {
    using Type = solid::SolidSample (*)(solid::Field, const Settings*, const solid::SolidPoint&);

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    [[gnu::target("avx2"), gnu::flatten]] static solid::SolidSample
    with_avx2(solid::Field field, const Settings* settings, const solid::SolidPoint& point) {
        return Function(field, settings, point);
    }
    static Type best() { return __builtin_cpu_supports("avx2") ? with_avx2 : everywhere; }
#else
    static Type best() { return everywhere; }
#endif

  private:
    static solid::SolidSample everywhere(solid::Field field, const Settings* settings,
                                         const solid::SolidPoint& point) {
        return Function(field, settings, point);
    }
};

/// `Function(field, settings, point)` is the function of the .cl file. `InLanes(field, settings,
/// points, samples)`, if any, evaluates several points at once with identical bits, or returns
/// false when it cannot.
template <class Settings, auto Function, auto InLanes = nullptr>
class SolidProcedural : public Procedural {
  public:
    SolidProcedural(std::shared_ptr<const FractalLattice> lattice, const Settings& settings,
                    const SolidKernel& kernel, bool scales_with_object)
        : lattice_(std::move(lattice)), settings_(settings), kernel_(kernel),
          scales_with_object_(scales_with_object) {}

    bool solid() const override { return true; }
    bool scales_with_object() const override { return scales_with_object_; }

    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        const solid::Field field{&lattice_->header(), lattice_->nodes16().data(),
                                 lattice_->nodes32().data()};
        if constexpr (!std::is_null_pointer_v<decltype(InLanes)>)
            if (points.size() > 1 && InLanes(field, settings_, points, samples))
                return;
        for (std::size_t i = 0; i < points.size(); ++i)
            samples[i] = shading_sample(function_(field, &settings_, solid_point(points[i])));
    }

    void bake(std::span<const ShadingPoint> points, std::span<ShadingSample> samples,
              Device* device) const override {
        if (device == nullptr)
            Procedural::bake(points, samples, nullptr);
        else
            run_solid_kernel(*device, kernel_, std::as_bytes(std::span(&settings_, 1)), *lattice_,
                             points, samples);
    }

  private:
    std::shared_ptr<const FractalLattice> lattice_;
    Settings settings_;
    SolidKernel kernel_;
    bool scales_with_object_;
    typename SolidFunction<Settings, Function>::Type function_ =
        SolidFunction<Settings, Function>::best();
};

} // namespace scree
