// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface.h"

#include "render/bsdf/ggx.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

// How far above a surface a bent direction must stay, as a cosine (0.6 degrees).
constexpr float min_cosine = 0.01F;

// The shading normal nearest to `n` for which the viewer, and for mirrors the mirrored viewer, is
// above the surface (Keller et al. 2017, "The Iray light transport simulation and rendering
// system", section A.3): no black rims.
Vec3 adapted(const Vec3& n, const Vec3& geometric, const Vec3& wo, bool mirrors) {
    if (mirrors) {
        const Vec3 mirrored = ggx::reflect(wo, n);
        const float height = mirrored.dot(geometric);
        if (height >= min_cosine)
            return n;
        return unit(wo + unit(mirrored + geometric * (min_cosine - height)));
    }
    const float height = wo.dot(n);
    return height >= min_cosine ? n : unit(n + wo * (min_cosine - height));
}

std::unique_ptr<const PreparedMaterial> prepared(const Material& material, AlbedoTables& tables) {
    return std::visit(
        [&](const auto& m) {
            if constexpr (requires { m.prepare(tables); })
                return m.prepare(tables);
            else
                return m->prepare(tables);
        },
        material);
}

const Vec3& shading_normal(const Hit& hit, const Painted& painted) {
    return painted.bent ? painted.normal : hit.shading_normal;
}

} // namespace

// Where the geometric normal says dark and the shading normal says lit, shade softly instead of
// with the facets' edges (Chiang, Li & Burley 2019, "Taming the shadow terminator").
float Surface::terminator(const Vec3& wi, const Vec3& local) const {
    if (!smooth || local.z <= 0)
        return 1;
    const float g = wi.dot(normal) / (local.z * frame.z.dot(normal));
    return g >= 1 ? 1 : g <= 0 ? 0 : g * (1 + g - g * g);
}

BsdfValue Surface::evaluate(const Vec3& wi) const {
    const Vec3 local = frame.local_from_world(wi);
    if ((local.z > 0) != (wi.dot(normal) > 0))
        return {};
    return bsdf.evaluate(wo, local, terminator(wi, local));
}

BsdfSample Surface::sample(float choice, const Vec2f& u) const {
    BsdfSample sample = bsdf.sample(wo, choice, u);
    if (!(sample.pdf > 0))
        return sample;
    const Vec3 local = sample.direction;
    sample.direction = frame.world_from_local(local);
    const float height = sample.direction.dot(normal);
    if ((height > 0) == sample.transmitted) {
        if (!sample.delta)
            return {};
        // The light has been chosen to be reflected or transmitted; keep it on that side.
        const float wanted = sample.transmitted ? -min_cosine : min_cosine;
        sample.direction = unit(sample.direction + normal * (wanted - height));
    } else if (smooth && bsdf.lobe->traits().diffuse) {
        const BsdfValue value = bsdf.evaluate(wo, local, terminator(sample.direction, local));
        sample.weight = value.value / sample.pdf;
    }
    return sample;
}

MaterialSet::MaterialSet(std::span<const std::shared_ptr<const Material>> materials,
                         float least_roughness)
    : least_roughness_(least_roughness) {
    for (const std::shared_ptr<const Material>& material : materials) {
        materials_.push_back(prepared(*material, tables_));
        if (least_roughness > 0)
            rough_.push_back(prepared(roughened(*material, least_roughness), tables_));
    }
}

namespace {

/// Which way the surface at a hit faces a viewer who looks along `direction`; its lobe comes after.
Surface facing(const Hit& hit, const Vec3& direction, const PreparedMaterial& material) {
    Surface surface;
    surface.material = &material;
    surface.outside = direction.dot(hit.normal) < 0;
    surface.normal = surface.outside ? hit.normal : -hit.normal;
    return surface;
}

/// Turns the frame of a surface whose lobe is known to a viewer who looks along `direction`.
void orient(Surface& surface, const Hit& hit, const Vec3& direction, const Painted& painted) {
    const LobeTraits& traits = surface.bsdf.lobe->traits();
    const Vec3 wo = -direction;
    surface.smooth = hit.smooth || painted.bent;
    Vec3 normal = shading_normal(hit, painted);
    if (!surface.outside)
        normal = -normal;
    if (surface.smooth)
        normal = adapted(normal, surface.normal, wo, traits.mirrors);
    surface.frame = traits.oriented ? Frame(normal, hit.tangent) : Frame(normal);
    surface.wo = surface.frame.local_from_world(wo);
}

} // namespace

Surface MaterialSet::surface(const Hit& hit, const Vec3& direction, const Painted& painted,
                             bool rough) const {
    assert(hit.material < materials_.size());
    const bool roughened = rough && !rough_.empty();
    Surface surface = facing(hit, direction, *(roughened ? rough_ : materials_)[hit.material]);
    if (roughened && painted.roughness >= 0) {
        Painted rougher = painted;
        rougher.roughness = std::max(painted.roughness, least_roughness_);
        surface.bsdf = surface.material->bsdf(rougher, surface.outside);
    } else {
        surface.bsdf = surface.material->bsdf(painted, surface.outside);
    }
    orient(surface, hit, direction, painted);
    return surface;
}

Surface MaterialSet::emerging(const Hit& hit, const Vec3& direction, const Painted& painted) const {
    const Vec3& normal = shading_normal(hit, painted);
    const bool outwards = direction.dot(hit.normal) > 0;
    // As if seen from straight above: where the light comes from makes no difference.
    const Vec3 down = outwards ? -normal : normal;
    Surface surface = facing(hit, down, at(hit));
    surface.bsdf = surface.material->subsurface()->emerging(painted);
    orient(surface, hit, down, painted);
    return surface;
}

} // namespace scree
