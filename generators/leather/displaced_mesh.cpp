// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/displaced_surface.h"

#include "core/parallel.h"
#include "generators/leather/seam_blend.h"
#include "generators/leather/tile_repeats.h"
#include "geometry/mesh/triangle_corners.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace scree {

namespace {

// Vertices of one place whose normals differ by a larger angle lie on a crease, whose edges stay
// straight.
constexpr float smooth_cosine = 0.82F; // 35 degrees

/// A vertex's normal for moving it: that of all vertices at its place together.
struct Place {
    Vec3 normal{0.0F};
    bool smooth = true;
};

Vec3 face_vector(const Mesh& mesh, const Mesh::Triangle& t) {
    return (mesh.positions[t[1]] - mesh.positions[t[0]])
        .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
}

/// Unit normals weighted by area, one per place.
std::vector<Vec3> normals_of_places(const Mesh& mesh, const std::vector<std::uint32_t>& place) {
    std::vector<Vec3> normals(mesh.positions.size(), Vec3(0.0F));
    for (const Mesh::Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            normals[place[v]] += face_vector(mesh, t);
    for (Vec3& normal : normals)
        normal = normal.length2() > 0 ? normal.normalized() : Vec3(0, 1, 0);
    return normals;
}

/// A mesh whose edges are halved again and again, its seams kept together by their places.
class Refinement {
  public:
    explicit Refinement(const Mesh& mesh) : mesh_(mesh), place_(weld(mesh)) {
        const std::vector<Vec3> shared = normals_of_places(mesh_, place_);
        if (mesh_.normals.empty())
            for (std::size_t i = 0; i < mesh_.positions.size(); ++i)
                mesh_.normals.push_back(shared[place_[i]]);
        places_.resize(mesh_.positions.size());
        for (std::size_t i = 0; i < place_.size(); ++i) {
            Place& place = places_[place_[i]];
            place.normal = shared[place_[i]];
            place.smooth = place.smooth && mesh_.normals[i].dot(place.normal) > smooth_cosine;
        }
    }

    /// Halves all edges that are longer than `limit` [m], once.
    void split(float limit) {
        split_if(
            [&](std::uint32_t a, std::uint32_t b, std::size_t) { return length(a, b) > limit; });
    }

    /// How many triangles `split(limit)` would make.
    std::size_t count_after_split(float limit) const {
        std::size_t count = mesh_.triangles.size();
        for (const Mesh::Triangle& t : mesh_.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                count += length(t[k], t[(k + 1) % 3]) > limit;
        return count;
    }

    /// Halves the edges off which the map lies by more than `tolerance` [m], once: never to more
    /// than `most` triangles, and first those with most room between. Returns whether there were
    /// any.
    bool split_where_bent(const HeightField& field, const Vec2& tiles, float tolerance,
                          std::size_t most);

    float longest_edge() const {
        float longest = 0;
        for (const Mesh::Triangle& t : mesh_.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                longest = std::max(longest, length(t[k], t[(k + 1) % 3]));
        return longest;
    }

    Mesh& mesh() { return mesh_; }

    /// Moves every place by the mean of what the map says at its vertices, along the normal there.
    /// Across seams of the UVs the map is blended within `blend` [m].
    void displace(const HeightField& field, const Vec2& tiles, double blend);

  private:
    /// Which edges, by 3 * triangle + corner, lie on a seam or a crease: the triangles on their
    /// two sides have vertices of their own, with UVs that may differ.
    std::vector<bool> torn_edges() const;

    float length(std::uint32_t a, std::uint32_t b) const {
        return (mesh_.positions[a] - mesh_.positions[b]).length();
    }

    /// Halves the edges of which `halve(a, b, 3 * triangle + corner)` holds: for both triangles of
    /// an edge alike.
    template <class Halve>
    void split_if(const Halve& halve) {
        middles_.clear();
        std::vector<Mesh::Triangle> triangles;
        triangles.reserve(2 * mesh_.triangles.size());
        for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
            const Mesh::Triangle t = mesh_.triangles[i];
            std::array<std::uint32_t, 3> m{};
            std::array<bool, 3> halved{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                halved[k] = halve(a, b, 3 * i + k);
                if (halved[k])
                    m[k] = middle(a, b);
            }
            append(triangles, t, m, halved);
        }
        mesh_.triangles = std::move(triangles);
    }

    static void append(std::vector<Mesh::Triangle>& out, const Mesh::Triangle& t,
                       const std::array<std::uint32_t, 3>& m, const std::array<bool, 3>& halved) {
        const int count = halved[0] + halved[1] + halved[2];
        if (count == 0) {
            out.push_back(t);
        } else if (count == 3) {
            out.insert(
                out.end(),
                {{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
        } else if (count == 1) {
            const std::size_t k = halved[0] ? 0 : halved[1] ? 1 : 2;
            out.insert(out.end(),
                       {{t[k], m[k], t[(k + 2) % 3]}, {m[k], t[(k + 1) % 3], t[(k + 2) % 3]}});
        } else { // the corner between the two halved edges, then the rest
            const std::size_t whole = !halved[0] ? 0 : !halved[1] ? 1 : 2;
            const std::uint32_t a = t[whole], b = t[(whole + 1) % 3], c = t[(whole + 2) % 3];
            const std::uint32_t bc = m[(whole + 1) % 3], ca = m[(whole + 2) % 3];
            out.insert(out.end(), {{a, b, bc}, {a, bc, ca}, {ca, bc, c}});
        }
    }

    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const auto key = [](std::uint32_t i, std::uint32_t j) {
            return (std::uint64_t{std::min(i, j)} << 32) | std::max(i, j);
        };
        const auto [found, is_new] = middles_.try_emplace(key(a, b), 0);
        if (!is_new)
            return found->second;
        const auto index = static_cast<std::uint32_t>(mesh_.positions.size());
        found->second = index;
        // Both sides of a seam must come to the same bits: in the order of the places.
        std::uint32_t p = place_[a], q = place_[b];
        if (p > q)
            std::swap(p, q);
        const Vec3 from = mesh_.positions[p], to = mesh_.positions[q], edge = to - from;
        Vec3 bulge(0.0F); // of the cubic through both ends, square to their normals
        if (places_[p].smooth)
            bulge += places_[p].normal * places_[p].normal.dot(edge);
        if (places_[q].smooth)
            bulge -= places_[q].normal * places_[q].normal.dot(edge);
        const Place between{(places_[p].normal + places_[q].normal).normalized(),
                            places_[p].smooth || places_[q].smooth};
        const Vec2f uv = (mesh_.uvs[a] + mesh_.uvs[b]) * 0.5F;
        const Vec3 normal = (mesh_.normals[a] + mesh_.normals[b]).normalized();
        mesh_.positions.push_back((from + to) * 0.5F - bulge * 0.125F);
        mesh_.normals.push_back(normal);
        mesh_.uvs.push_back(uv);
        // One place for both sides of a seam, whose vertices differ.
        const auto [shared, first] =
            middles_.try_emplace(key(p, q) | (std::uint64_t{1} << 63), index);
        place_.push_back(first ? index : shared->second);
        places_.push_back(between);
        return index;
    }

    Mesh mesh_;
    std::vector<std::uint32_t> place_; // of every vertex: the first vertex at the same position
    std::vector<Place> places_;        // by that vertex
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

std::vector<bool> Refinement::torn_edges() const {
    const std::vector<bool> split = split_places(place_);
    using Ends = std::pair<std::uint32_t, std::uint32_t>;
    std::map<Ends, std::pair<Ends, std::size_t>> open; // by places: the vertices, and which edge
    std::vector<bool> torn(3 * mesh_.triangles.size());
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh_.triangles[i][k], b = mesh_.triangles[i][(k + 1) % 3];
            if (!split[place_[a]] && !split[place_[b]])
                continue;
            const Ends vertices = std::minmax(a, b);
            const Ends places = std::minmax(place_[a], place_[b]);
            const auto [found, first] = open.try_emplace(places, vertices, 3 * i + k);
            if (!first && found->second.first != vertices)
                torn[3 * i + k] = torn[found->second.second] = true;
        }
    return torn;
}

bool Refinement::split_where_bent(const HeightField& field, const Vec2& tiles, float tolerance,
                                  std::size_t most) {
    const auto offset_at = [&](const Vec2f& uv) {
        return field.offset(Vec2(double(uv.x) * tiles.x, double(uv.y) * tiles.y));
    };
    std::vector<Vec3> offsets(mesh_.positions.size());
    parallel_for(offsets.size(), 1024,
                 [&](std::size_t i) { offsets[i] = offset_at(mesh_.uvs[i]); });
    const std::vector<bool> torn = torn_edges();
    std::vector<float> areas(3 * mesh_.triangles.size()); // between the map and the edge, about
    parallel_for(mesh_.triangles.size(), 1024, [&](std::size_t i) {
        const Mesh::Triangle& t = mesh_.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = std::min(t[k], t[(k + 1) % 3]);
            const std::uint32_t b = std::max(t[k], t[(k + 1) % 3]);
            if (torn[3 * i + k])
                continue;
            float bend = 0;
            for (const float at : {0.25F, 0.5F, 0.75F})
                bend = std::max(bend, (offset_at(mesh_.uvs[a] * (1 - at) + mesh_.uvs[b] * at) -
                                       (offsets[a] * (1 - at) + offsets[b] * at))
                                          .length());
            if (bend > tolerance)
                areas[3 * i + k] = bend * length(a, b);
        }
    });
    // Each edge halved in a triangle makes one triangle more.
    const std::size_t room = most - std::min(most, mesh_.triangles.size());
    float least = 0;
    if (room < areas.size()) {
        std::vector<float> sorted = areas;
        std::ranges::nth_element(sorted, sorted.begin() + std::ptrdiff_t(room), std::greater());
        least = sorted[room];
    }
    if (std::ranges::none_of(areas, [&](float area) { return area > least; }))
        return false;
    split_if([&](std::uint32_t, std::uint32_t, std::size_t edge) { return areas[edge] > least; });
    return true;
}

void Refinement::displace(const HeightField& field, const Vec2& tiles, double blend) {
    const std::size_t count = mesh_.positions.size();
    // The directions of growing u and v, summed over the triangles round each place.
    std::vector<Vec3> along_u(count, Vec3(0.0F)), along_v(count, Vec3(0.0F));
    for (const Mesh::Triangle& t : mesh_.triangles) {
        const Vec3 e1 = mesh_.positions[t[1]] - mesh_.positions[t[0]];
        const Vec3 e2 = mesh_.positions[t[2]] - mesh_.positions[t[0]];
        const Vec2f d1 = mesh_.uvs[t[1]] - mesh_.uvs[t[0]], d2 = mesh_.uvs[t[2]] - mesh_.uvs[t[0]];
        const float sign = d1.x * d2.y - d1.y * d2.x < 0 ? -1.0F : 1.0F;
        for (const std::uint32_t v : t) {
            along_u[place_[v]] += (e1 * d2.y - e2 * d1.y) * sign;
            along_v[place_[v]] += (e2 * d1.x - e1 * d2.x) * sign;
        }
    }
    for (Vec2f& uv : mesh_.uvs)
        uv = Vec2f(static_cast<float>(uv.x * tiles.x), static_cast<float>(uv.y * tiles.y));
    const SeamBlend seams(mesh_, place_, blend);
    std::vector<Vec3> offsets(count);
    parallel_for(count, 1024, [&](std::size_t i) {
        const Vec3 offset = field.offset(Vec2(mesh_.uvs[i]));
        const std::uint32_t p = place_[i];
        offsets[i] = places_[p].normal * offset.y;
        if (along_u[p].length2() > 0 && along_v[p].length2() > 0)
            offsets[i] += along_u[p].normalized() * offset.x - along_v[p].normalized() * offset.z;
        offsets[i] =
            seams.offset(field, static_cast<std::uint32_t>(i), offsets[i], places_[p].normal);
    });
    std::vector<Vec3> sums(count, Vec3(0.0F));
    std::vector<float> shares(count, 0.0F);
    for (std::size_t i = 0; i < count; ++i) {
        sums[place_[i]] += offsets[i];
        shares[place_[i]] += 1;
    }
    for (std::size_t i = 0; i < count; ++i)
        mesh_.positions[i] += sums[place_[i]] / shares[place_[i]];
    const std::vector<Vec3> normals = normals_of_places(mesh_, place_);
    for (std::size_t i = 0; i < count; ++i)
        mesh_.normals[i] = normals[place_[i]];
}

} // namespace

std::size_t triangles_needed(const Mesh& mesh, double edge, std::size_t most) {
    using Corners = std::array<Imath::V3d, 3>; // in double, or small edges of far corners stay
    std::size_t count = 0;
    std::vector<Corners> open; // parts of a triangle that may be too large
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = corners_of(mesh, t);
        open.push_back({Imath::V3d(a), Imath::V3d(b), Imath::V3d(c)});
        while (!open.empty() && count <= most) {
            const Corners p = open.back();
            open.pop_back();
            const auto edge2 = [&](std::size_t k) { return (p[(k + 1) % 3] - p[k]).length2(); };
            const std::size_t k = std::ranges::max(std::array<std::size_t, 3>{0, 1, 2}, {}, edge2);
            if (edge2(k) <= edge * edge) {
                ++count;
                continue;
            }
            const std::size_t end = (k + 1) % 3, opposite = (k + 2) % 3;
            const Imath::V3d middle = (p[k] + p[end]) * 0.5;
            open.push_back({p[k], middle, p[opposite]});
            open.push_back({middle, p[end], p[opposite]});
        }
    }
    return count;
}

Mesh displaced_mesh(const HeightField& field, const Mesh& mesh, std::size_t triangles,
                    double blend) {
    Refinement refined(mesh);
    const Vec2 tiles = tile_repeats(mesh, field.size);
    // Half of the triangles are of one size, the others go to where the relief bends.
    const std::size_t even = std::max(mesh.triangles.size(), triangles / 2);
    // Halved edges end between half the limit and the limit: triangles of about 0.6 of it.
    const auto limit =
        static_cast<float>(1.6 * std::sqrt(4 / std::sqrt(3.0) * area(mesh) / double(even)));
    while (true) {
        const float longest = refined.longest_edge();
        float split_above = limit;
        while (split_above < longest && refined.count_after_split(split_above) > even)
            split_above *= 1.05F;
        if (split_above >= longest)
            break;
        refined.split(split_above);
    }
    constexpr int rounds = 4; // edges down to a sixteenth
    constexpr double flat = 0.002;
    const auto [low, high] = std::ranges::minmax(field.image.pixels);
    for (int round = 0; round < rounds; ++round) {
        const std::size_t count = refined.mesh().triangles.size();
        const std::size_t most = count + (triangles - count) / std::size_t(rounds - round);
        if (!refined.split_where_bent(field, tiles, static_cast<float>(flat * (high - low)), most))
            break;
    }
    refined.displace(field, tiles, blend);
    return std::move(refined.mesh());
}

} // namespace scree
