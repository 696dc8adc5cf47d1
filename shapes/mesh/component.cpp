// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/component.h"

namespace scree {

namespace {

void lay_down(Mesh& mesh) {
    const Box3 box = bounds(mesh);
    const Vec3 foot(box.center().x, box.min.y, box.center().z);
    for (Vec3& p : mesh.positions)
        p -= foot;
}

} // namespace

Plugin<MakeMesh> component(std::string name, std::string doc, std::vector<ParamSpec> params,
                           std::function<MakeMesh> shape) {
    auto make = [name, shape = std::move(shape)](const Params& values) {
        Mesh mesh = shape(values);
        mesh.name = name;
        lay_down(mesh);
        return mesh;
    };
    doc += " Its origin is its foot, below its middle.";
    return {std::move(name), std::move(doc), std::move(params), std::move(make)};
}

ParamSpec metres(std::string name, std::string doc, double fallback) {
    return number_spec(std::move(name), std::move(doc), "m", fallback, 1e-4, 100);
}

ParamSpec optional_metres(std::string name, std::string doc) {
    return optional_number_spec(std::move(name), std::move(doc), "m", 1e-4, 100);
}

ParamSpec ratio(std::string name, std::string doc, double fallback, double min, double max) {
    return number_spec(std::move(name), std::move(doc), "", fallback, min, max);
}

ParamSpec angle_degrees(std::string name, std::string doc, double fallback, double min,
                        double max) {
    return number_spec(std::move(name), std::move(doc), "deg", fallback, min, max);
}

ParamSpec count(std::string name, std::string doc, int fallback, int min, int max) {
    return {.name = std::move(name),
            .type = ParamType::integer,
            .doc = std::move(doc),
            .fallback = std::int64_t{fallback},
            .min = double(min),
            .max = double(max)};
}

double number_or(const Params& params, const std::string& name, double otherwise) {
    return params.has(name) ? params.number(name) : otherwise;
}

} // namespace scree
