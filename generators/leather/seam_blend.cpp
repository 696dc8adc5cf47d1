// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/seam_blend.h"

#include "core/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <unordered_map>

namespace scree {

namespace {

using Corner = std::pair<std::size_t, std::size_t>; // triangle and 0, 1 or 2: an edge begins there

bool whole_apart(const Vec2f& a, const Vec2f& b) {
    const auto whole = [](float d) { return std::abs(d - std::round(d)) < 1e-3F; };
    return whole(a.x - b.x) && whole(a.y - b.y);
}

/// The edges along which two triangles do not share vertices, and whose UVs there are not whole
/// tiles apart: pairs of corners, one of each triangle.
std::vector<std::pair<Corner, Corner>> seam_edges(const Mesh& mesh,
                                                  const std::vector<std::uint32_t>& place) {
    const std::vector<bool> split = split_places(place);
    std::unordered_map<std::uint64_t, Corner> open;
    std::vector<std::pair<Corner, Corner>> seams;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            const std::uint32_t p = place[a], q = place[b];
            if (!split[p] || !split[q])
                continue;
            open.emplace(std::uint64_t{p} << 32 | q, Corner{t, k});
            const auto found = open.find(std::uint64_t{q} << 32 | p);
            if (found == open.end())
                continue;
            const auto [other, l] = found->second;
            const std::uint32_t c = mesh.triangles[other][(l + 1) % 3],
                                d = mesh.triangles[other][l];
            if (!whole_apart(mesh.uvs[a], mesh.uvs[c]) || !whole_apart(mesh.uvs[b], mesh.uvs[d]))
                seams.push_back({{t, k}, {other, l}});
        }
    return seams;
}

/// For every vertex the first vertex of its piece of the UV map.
std::vector<std::uint32_t> pieces(const Mesh& mesh) {
    DisjointSets sets(mesh.positions.size());
    for (const Mesh::Triangle& t : mesh.triangles) {
        sets.unite(t[0], t[1]);
        sets.unite(t[0], t[2]);
    }
    std::vector<std::uint32_t> first(mesh.positions.size());
    for (std::uint32_t i = 0; i < first.size(); ++i)
        first[i] = sets.find(i);
    return first;
}

/// The triangles round every vertex: those of vertex i are `all[first[i]]` to `all[first[i + 1]]`.
struct Fans {
    std::vector<std::uint32_t> first, all;

    explicit Fans(const Mesh& mesh)
        : first(mesh.positions.size() + 1), all(3 * mesh.triangles.size()) {
        for (const Mesh::Triangle& t : mesh.triangles)
            for (const std::uint32_t v : t)
                ++first[v + 1];
        for (std::size_t i = 1; i < first.size(); ++i)
            first[i] += first[i - 1];
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (const std::uint32_t v : mesh.triangles[t])
                all[next[v]++] = t;
    }
};

/// The part of `v` that is square to `axis`, a unit vector.
Vec3 square_to(const Vec3& v, const Vec3& axis) { return v - axis * axis.dot(v); }

float distance_to(const Vec3& p, const Vec3& from, const Vec3& along, float length) {
    const Vec3 way = p - from;
    return (way - along * std::clamp(way.dot(along), 0.0F, length)).length();
}

} // namespace

std::vector<bool> split_places(const std::vector<std::uint32_t>& place) {
    std::vector<bool> split(place.size());
    for (std::uint32_t i = 0; i < place.size(); ++i)
        if (place[i] != i)
            split[place[i]] = true;
    return split;
}

SeamBlend::SeamBlend(const Mesh& mesh, const std::vector<std::uint32_t>& place, double reach)
    : reach_(static_cast<float>(reach)) {
    find_edges(mesh, place);
    if (edges_.empty())
        return;
    positions_ = mesh.positions;
    seen_.resize(mesh.positions.size());
    spread(mesh);
}

void SeamBlend::find_edges(const Mesh& mesh, const std::vector<std::uint32_t>& place) {
    const std::vector<std::pair<Corner, Corner>> seams = seam_edges(mesh, place);
    if (seams.empty())
        return;
    const std::vector<std::uint32_t> piece = pieces(mesh);
    const auto add = [&](const Corner& looking, const Corner& across) {
        const Mesh::Triangle& here = mesh.triangles[looking.first];
        const Mesh::Triangle& there = mesh.triangles[across.first];
        Edge edge;
        edge.ends = {here[looking.second], here[(looking.second + 1) % 3]};
        edge.from = mesh.positions[edge.ends[0]];
        edge.along = mesh.positions[edge.ends[1]] - edge.from;
        edge.length = edge.along.length();
        edge.along.normalize();
        const Vec3 into_here =
            square_to(mesh.positions[here[(looking.second + 2) % 3]] - edge.from, edge.along);
        // The other triangle runs through the edge the other way.
        const std::uint32_t first = there[(across.second + 1) % 3], last = there[across.second];
        const std::uint32_t tip = there[(across.second + 2) % 3];
        const Vec3 to_tip = mesh.positions[tip] - edge.from;
        const double height = square_to(to_tip, edge.along).length();
        if (!(edge.length > 0) || !(height > 0) || !(into_here.length() > 0))
            return; // a triangle without area
        edge.away = into_here.normalized();
        edge.uv = Vec2(mesh.uvs[first]);
        edge.uv_along = (Vec2(mesh.uvs[last]) - edge.uv) / double(edge.length);
        const Vec2 foot = edge.uv + edge.uv_along * double(to_tip.dot(edge.along));
        edge.uv_away = (foot - Vec2(mesh.uvs[tip])) / height;
        edge.seen = piece[first];
        edges_.push_back(edge);
    };
    for (const auto& [one, other] : seams) {
        add(one, other);
        add(other, one);
    }
}

bool SeamBlend::sees(std::uint32_t vertex, std::uint32_t piece) const {
    const Seen& seen = seen_[vertex];
    return seen.count == most ||
           std::any_of(seen.seams.begin(), seen.seams.begin() + seen.count,
                       [&](const Near& near) { return edges_[near.edge].seen == piece; });
}

// From the edges outwards over their side's piece, the nearest first.
void SeamBlend::spread(const Mesh& mesh) {
    using Step = std::tuple<float, std::uint32_t, std::uint32_t>; // distance, vertex, edge
    std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
        for (const std::uint32_t end : edges_[e].ends)
            open.emplace(0.0F, end, e);
    const Fans fans(mesh);
    while (!open.empty()) {
        const auto [distance, vertex, e] = open.top();
        open.pop();
        const Edge& edge = edges_[e];
        if (sees(vertex, edge.seen))
            continue;
        Seen& seen = seen_[vertex];
        seen.seams[seen.count++] = {e, distance};
        for (std::uint32_t i = fans.first[vertex]; i < fans.first[vertex + 1]; ++i)
            for (const std::uint32_t v : mesh.triangles[fans.all[i]]) {
                const float d = distance_to(mesh.positions[v], edge.from, edge.along, edge.length);
                if (d < reach_ && !sees(v, edge.seen))
                    open.emplace(d, v, e);
            }
    }
}

Vec3 SeamBlend::offset(const HeightField& field, std::uint32_t i, const Vec3& own,
                       const Vec3& normal) const {
    if (seen_.empty() || seen_[i].count == 0)
        return own;
    Vec3 sum = own;
    float weights = 1;
    for (std::uint32_t k = 0; k < seen_[i].count; ++k) {
        const Near& near = seen_[i].seams[k];
        const Edge& edge = edges_[near.edge];
        const Vec3 way = positions_[i] - edge.from;
        const float along = way.dot(edge.along);
        const float away = (way - edge.along * along).length();
        const Vec3 there =
            field.offset(edge.uv + edge.uv_along * double(along) + edge.uv_away * double(away));
        const float t = near.distance / reach_;
        const float weight = (1 - t) * (1 - t) * (1 + 2 * t);
        // The directions of growing u and v: those in which the other does not grow.
        const Vec2 &a = edge.uv_along, &b = edge.uv_away;
        const float sign = cross(a, b) < 0 ? -1.0F : 1.0F;
        const Vec3 u = edge.along * float(b.y) - edge.away * float(a.y);
        const Vec3 v = edge.away * float(a.x) - edge.along * float(b.x);
        Vec3 offset = normal * there.y;
        if (u.length2() > 0 && v.length2() > 0)
            offset += (u.normalized() * there.x - v.normalized() * there.z) * sign;
        sum += offset * weight;
        weights += weight;
    }
    return sum / weights;
}

} // namespace scree
