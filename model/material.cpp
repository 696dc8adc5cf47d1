// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/material.h"

namespace scree {

namespace {

bool asks_for_uv(const Paint& paint) {
    return paint.palette.empty() && paint.texture.procedural != nullptr &&
           !paint.texture.procedural->solid();
}

bool is_oriented(const Material& material) {
    return std::visit(
        [](const auto& m) {
            if constexpr (requires { m->oriented(); })
                return m->oriented();
            else
                return requires { m.oriented; };
        },
        material);
}

} // namespace

Texture texture_of(const Params& params, const std::string& name) {
    if (auto procedural = params.object<Procedural>(name))
        return {Color(0.0F), std::move(procedural)};
    return {params.color(name), nullptr};
}

ParamSpec material_spec(const std::string& doc) {
    return {.name = "material",
            .type = ParamType::object,
            .families = {"material"},
            .doc = doc + "; grey matte when not given.",
            .optional = true};
}

const Paint* paint_of(const Material& material) {
    return std::visit(
        [](const auto& m) -> const Paint* {
            if constexpr (requires { m.paint; })
                return &m.paint;
            else if constexpr (requires { m->paint(); })
                return m->paint();
            else
                return nullptr;
        },
        material);
}

const Paint* paint_of(const Materials& materials) {
    return materials.size() == 1 && materials.front() ? paint_of(*materials.front()) : nullptr;
}

bool any_fibre(const Materials& materials) {
    return std::any_of(materials.begin(), materials.end(), [](const auto& material) {
        return material && std::holds_alternative<Fibre>(*material);
    });
}

bool has_inside(const Material& material) {
    return std::holds_alternative<Glass>(material) || std::holds_alternative<Translucent>(material);
}

bool shows_picture(const Material& material) {
    const Paint* paint = paint_of(material);
    return paint != nullptr && asks_for_uv(*paint);
}

Material roughened(const Material& material, float least) {
    Material out = material;
    std::visit(
        [&](auto& m) {
            if constexpr (requires { m.roughness; })
                m.roughness = std::max(m.roughness, least);
        },
        out);
    return out;
}

bool uses_uv(const Material& material) { return shows_picture(material) || is_oriented(material); }

} // namespace scree
