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
Vec3 adapted(const Vec3& n, const Vec3& geometric, const Vec3& wo, bool mirror) {
    if (mirror) {
        const Vec3 mirrored = ggx::reflect(wo, n);
        const float height = mirrored.dot(geometric);
        if (height >= min_cosine)
            return n;
        return unit(wo + unit(mirrored + geometric * (min_cosine - height)));
    }
    const float height = wo.dot(n);
    return height >= min_cosine ? n : unit(n + wo * (min_cosine - height));
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
        // The light has decided for a side; keep it there.
        const float wanted = sample.transmitted ? -min_cosine : min_cosine;
        sample.direction = unit(sample.direction + normal * (wanted - height));
    } else if (smooth && (bsdf.kind == BsdfKind::matte || bsdf.kind == BsdfKind::plastic ||
                          bsdf.kind == BsdfKind::emerging)) {
        const BsdfValue value = bsdf.evaluate(wo, local, terminator(sample.direction, local));
        sample.weight = value.value / sample.pdf;
    }
    return sample;
}

Color Surface::albedo() const {
    const bool is_glass = bsdf.kind == BsdfKind::smooth_glass || bsdf.kind == BsdfKind::rough_glass;
    return is_glass ? Color(1.0F, 1.0F, 1.0F) : bsdf.color;
}

MaterialSet::MaterialSet(std::span<const std::shared_ptr<const Material>> materials) {
    for (const std::shared_ptr<const Material>& shared : materials) {
        const Material& material = *shared;
        Prepared prepared;
        if (const auto* matte = std::get_if<Matte>(&material)) {
            prepared.paint = matte->paint;
        } else if (const auto* plastic = std::get_if<Plastic>(&material)) {
            prepared.kind = BsdfKind::plastic;
            prepared.paint = plastic->paint;
            prepared.ior = plastic->ior;
            prepare_lobe(prepared, plastic->roughness, plastic->ior);
        } else if (const auto* metal = std::get_if<Metal>(&material)) {
            prepared.kind = BsdfKind::metal;
            prepared.paint = metal->paint;
            prepare_lobe(prepared, metal->roughness, 0);
        } else if (const auto* translucent = std::get_if<Translucent>(&material)) {
            prepared.kind = BsdfKind::translucent;
            prepared.paint = translucent->paint;
            prepared.ior = translucent->ior;
            prepared.distance = translucent->distance;
            prepare_lobe(prepared, translucent->roughness, translucent->ior);
        } else {
            const Glass& glass = std::get<Glass>(material);
            prepared.alpha = glass.roughness * glass.roughness;
            prepared.kind =
                prepared.alpha < ggx::min_alpha ? BsdfKind::smooth_glass : BsdfKind::rough_glass;
            prepared.ior = glass.ior;
            prepared.absorption = glass.absorption;
        }
        materials_.push_back(std::move(prepared));
    }
}

void MaterialSet::prepare_lobe(Prepared& prepared, float roughness, float facet_ior) {
    prepared.alpha = ggx::alpha(roughness);
    prepared.albedo =
        &tables_.try_emplace({prepared.alpha, facet_ior}, prepared.alpha, facet_ior).first->second;
    if (prepared.paint.texture.procedural != nullptr)
        prepared.varied = &varied_tables_.try_emplace(facet_ior, facet_ior).first->second;
}

Surface MaterialSet::surface(const Hit& hit, const Vec3& direction, const Painted& painted) const {
    assert(hit.material < materials_.size());
    const Prepared& material = materials_[hit.material];
    Surface surface;
    surface.smooth = hit.smooth || painted.bent;
    Vec3 normal = painted.bent ? painted.normal : hit.shading_normal;
    surface.bsdf.kind = material.kind;
    surface.bsdf.color = painted.color;
    const bool varied = painted.roughness >= 0 && material.varied != nullptr;
    surface.bsdf.alpha = varied ? ggx::alpha(std::min(painted.roughness, 1.0F)) : material.alpha;
    surface.bsdf.albedo = varied ? material.varied->at(painted.roughness) : material.albedo;
    const Vec3 wo = -direction;
    surface.outside = wo.dot(hit.normal) > 0;
    surface.normal = surface.outside ? hit.normal : -hit.normal;
    surface.bsdf.eta = material.ior;
    if (!surface.outside) {
        normal = -normal;
        // Only glass has an inside to look from; other coats are on both sides.
        if (material.kind == BsdfKind::smooth_glass || material.kind == BsdfKind::rough_glass)
            surface.bsdf.eta = 1 / material.ior;
    }
    surface.inside = material.absorption;
    if (surface.smooth)
        normal = adapted(normal, surface.normal, wo, material.kind != BsdfKind::matte);
    surface.frame = Frame(normal);
    surface.wo = surface.frame.local_from_world(wo);
    return surface;
}

Surface MaterialSet::emerging(const Hit& hit, const Vec3& direction, const Painted& painted) const {
    const Vec3& normal = painted.bent ? painted.normal : hit.shading_normal;
    const bool outwards = direction.dot(hit.normal) > 0;
    // As if seen from straight above: where the light comes from makes no difference.
    Surface surface = this->surface(hit, outwards ? -normal : normal, painted);
    surface.bsdf.kind = BsdfKind::emerging;
    return surface;
}

Medium MaterialSet::medium(const Hit& hit, const Color& color) const {
    return make_medium(color, materials_[hit.material].distance);
}

} // namespace scree
