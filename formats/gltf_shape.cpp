// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_shape.h"

#include "core/error.h"
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace scree::gltf {

namespace {

constexpr std::size_t strip = 5;
constexpr std::size_t fan = 6;

Index find(const Attributes& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? Index() : Index(found->second);
}

template <class Vector>
std::vector<Vector> vectors(std::size_t accessor, Data& data) {
    constexpr std::size_t width = Vector::dimensions();
    const std::vector<double> numbers = data.numbers(accessor, width);
    std::vector<Vector> out(numbers.size() / width);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        out[i / width][static_cast<int>(i % width)] = numbers[i];
    return out;
}

/// The attribute `name` with its morphs; none when there is none.
template <class Vector>
std::vector<Vector> attribute(const Primitive& primitive, const std::string& name,
                              std::size_t count, const std::vector<double>& weights, Data& data) {
    const Index base = find(primitive.attributes, name);
    if (!base)
        return {};
    const auto checked = [&](std::size_t accessor) {
        std::vector<Vector> values = vectors<Vector>(accessor, data);
        if (values.size() != count)
            throw Error(fmt::format("{}: its {} {} in accessors[{}] do not match its {} positions",
                                    primitive.path, values.size(), name, accessor, count));
        return values;
    };
    std::vector<Vector> values = checked(*base);
    for (std::size_t k = 0; k < weights.size(); ++k)
        if (const Index target = find(primitive.targets[k], name); target && weights[k] != 0) {
            const std::vector<Vector> change = checked(*target);
            for (std::size_t i = 0; i < count; ++i)
                values[i] += change[i] * weights[k];
        }
    return values;
}

/// Transforms normals up to a positive factor, also where the matrix flattens: for row vectors.
Imath::M33d cofactors(const Imath::M44d& m) {
    const Imath::V3d x(m[0][0], m[0][1], m[0][2]);
    const Imath::V3d y(m[1][0], m[1][1], m[1][2]);
    const Imath::V3d z(m[2][0], m[2][1], m[2][2]);
    const Imath::V3d a = y.cross(z);
    const Imath::V3d b = z.cross(x);
    const Imath::V3d c = x.cross(y);
    const double side = x.dot(a) < 0 ? -1 : 1;
    return Imath::M33d(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z) * side;
}

bool mirrors(const Imath::M44d& m) {
    return Imath::V3d(m[0][0], m[0][1], m[0][2])
               .dot(Imath::V3d(m[1][0], m[1][1], m[1][2])
                        .cross(Imath::V3d(m[2][0], m[2][1], m[2][2]))) < 0;
}

Vec3 face_normal(const FileMesh& mesh, const Mesh::Triangle& t) {
    const Imath::V3d& a = mesh.positions[t[0]];
    return Vec3((mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).normalized());
}

void mend_normals(FileMesh& mesh) {
    const Vec3 none(0.0F);
    for (const Mesh::Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : t)
            if (mesh.normals[corner] == none)
                mesh.normals[corner] = face_normal(mesh, t);
    for (Vec3& normal : mesh.normals)
        if (normal == none)
            normal = Vec3(0, 1, 0); // of no triangle with an area: any will do
}

} // namespace

Vertices vertices_of(const Primitive& primitive, const std::vector<double>& weights,
                     std::size_t uv_set, Data& data) {
    const Index positions = find(primitive.attributes, "POSITION");
    if (!positions)
        throw Error(primitive.path + " has no POSITION");
    if (!weights.empty() && weights.size() != primitive.targets.size())
        throw Error(fmt::format("{} has {}, but {}", primitive.path,
                                counted(primitive.targets.size(), "morph target"),
                                counted(weights.size(), "weight")));
    const std::size_t count = data.elements_in(*positions);
    Vertices out;
    out.positions = attribute<Imath::V3d>(primitive, "POSITION", count, weights, data);
    out.normals = attribute<Imath::V3d>(primitive, "NORMAL", count, weights, data);
    out.uvs =
        attribute<Imath::V2d>(primitive, fmt::format("TEXCOORD_{}", uv_set), count, weights, data);
    for (Imath::V2d& uv : out.uvs)
        uv.y = 1 - uv.y;
    return out;
}

bool has_triangles(const Primitive& primitive) { return primitive.mode >= 4; }

std::vector<Mesh::Triangle> triangles_of(const Primitive& primitive, std::size_t vertices,
                                         Data& data, std::size_t& left) {
    std::vector<std::uint32_t> corners;
    if (primitive.indices) {
        corners = data.indices(*primitive.indices);
    } else {
        corners.resize(vertices);
        std::iota(corners.begin(), corners.end(), 0U);
    }
    for (const std::uint32_t corner : corners)
        if (corner >= vertices)
            throw Error(
                fmt::format("{}: a face names vertex {} of {}", primitive.path, corner, vertices));
    std::vector<Mesh::Triangle> out;
    if (primitive.mode != strip && primitive.mode != fan) {
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            out.push_back({corners[i], corners[i + 1], corners[i + 2]});
        left += corners.size() % 3;
        return out;
    }
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        const std::size_t odd = i % 2;
        const Mesh::Triangle t =
            primitive.mode == fan
                ? Mesh::Triangle{corners[i + 1], corners[i + 2], corners[0]}
                : Mesh::Triangle{corners[i], corners[i + 1 + odd], corners[i + 2 - odd]};
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
            out.push_back(t);
    }
    if (corners.size() < 3)
        left += corners.size();
    return out;
}

bool keeps_area(const Imath::M44d& matrix) {
    double largest = 0;
    double largest_cofactor = 0;
    const Imath::M33d cofactor = cofactors(matrix);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            largest = std::max(largest, std::abs(matrix[i][k]));
            largest_cofactor = std::max(largest_cofactor, std::abs(cofactor[i][k]));
        }
    // A rotation leaves errors of about 1e-16 where a direction was shrunk to nothing.
    return largest_cofactor > 1e-12 * largest * largest;
}

FileMesh placed(const Vertices& vertices, std::vector<Mesh::Triangle> triangles,
                const std::vector<Imath::M44d>& matrices) {
    const auto matrix_of = [&](std::size_t vertex) -> const Imath::M44d& {
        return matrices[matrices.size() == 1 ? 0 : vertex];
    };
    FileMesh mesh;
    mesh.triangles = std::move(triangles);
    for (std::size_t i = 0; i < vertices.positions.size(); ++i)
        mesh.positions.push_back(vertices.positions[i] * matrix_of(i));
    for (std::size_t i = 0; i < vertices.normals.size(); ++i)
        mesh.normals.emplace_back((vertices.normals[i] * cofactors(matrix_of(i))).normalized());
    for (const Imath::V2d& uv : vertices.uvs)
        mesh.uvs.emplace_back(uv);
    for (Mesh::Triangle& t : mesh.triangles)
        if (mirrors(matrix_of(t[0])))
            std::swap(t[1], t[2]);
    if (!mesh.normals.empty())
        mend_normals(mesh);
    return mesh;
}

void make_flat(FileMesh& mesh) {
    FileMesh flat;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Vec3 normal = face_normal(mesh, t);
        for (const std::uint32_t corner : t) {
            flat.positions.push_back(mesh.positions[corner]);
            flat.normals.push_back(normal);
            if (!mesh.uvs.empty())
                flat.uvs.push_back(mesh.uvs[corner]);
        }
        const auto last = static_cast<std::uint32_t>(flat.positions.size());
        flat.triangles.push_back({last - 3, last - 2, last - 1});
    }
    mend_normals(flat); // of triangles without area
    flat.parts = std::move(mesh.parts);
    mesh = std::move(flat);
}

} // namespace scree::gltf
