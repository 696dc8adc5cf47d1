// SPDX-License-Identifier: GPL-3.0-or-later
// Embree's trees of strands.
#include "render/world/world_state.h"

#include <cassert>
#include <numeric>

namespace scree {

namespace {

// Back sides do not exist: light has left a fibre once it has been scattered.
void front_only(const RTCFilterFunctionNArguments* args) {
    assert(args->N == 1);
    const RTCHit* hit = reinterpret_cast<const RTCHit*>(args->hit);
    const RTCRay* ray = reinterpret_cast<const RTCRay*>(args->ray);
    if (hit->Ng_x * ray->dir_x + hit->Ng_y * ray->dir_y + hit->Ng_z * ray->dir_z > 0)
        args->valid[0] = 0;
}

// The half of a ball inside of its spline does not exist.
void outer_half_only(const RTCFilterFunctionNArguments* args) {
    assert(args->N == 1);
    const RTCHit* hit = reinterpret_cast<const RTCHit*>(args->hit);
    const StrandCap& cap = static_cast<const StrandCap*>(args->geometryUserPtr)[hit->primID];
    if (Vec3(hit->Ng_x, hit->Ng_y, hit->Ng_z).dot(cap.outwards) < 0)
        args->valid[0] = 0;
}

bool well_formed(const Strands& strands) {
    if (strands.offsets.front() != 0 || strands.offsets.back() != strands.points.size() ||
        strands.radii.size() != strands.points.size())
        return false;
    for (std::size_t i = 0; i < strands.count(); ++i)
        if (strands.offsets[i + 1] < strands.offsets[i] + strands.piece_points())
            return false;
    return true;
}

void copy_vertices(const Strands& strands, Imath::V4f* vertices) {
    for (std::size_t i = 0; i < strands.points.size(); ++i) {
        const Vec3& p = strands.points[i];
        vertices[i] = {p.x, p.y, p.z, strands.radii[i]};
    }
}

// A segment knows its neighbours, whose parts inside of it are not there.
void copy_segments(const Strands& strands, std::uint32_t* firsts, unsigned char* flags) {
    const auto more = static_cast<std::uint32_t>(strands.piece_points() - 1);
    for (std::size_t strand = 0; strand < strands.count(); ++strand) {
        const std::uint32_t begin = strands.offsets[strand];
        const std::uint32_t end = strands.offsets[strand + 1] - more;
        for (std::uint32_t i = begin; i < end; ++i) {
            *firsts++ = i;
            if (flags != nullptr)
                *flags++ =
                    static_cast<unsigned char>((i > begin ? RTC_CURVE_FLAG_NEIGHBOR_LEFT : 0) |
                                               (i + 1 < end ? RTC_CURVE_FLAG_NEIGHBOR_RIGHT : 0));
        }
    }
}

} // namespace

void World::State::collect(const std::shared_ptr<const Strands>& shape,
                           const Prototype& prototype) {
    if (shape == nullptr || shape->count() == 0)
        return;
    assert(well_formed(*shape));
    if (strand_trees.try_emplace({shape.get(), any_fibre(prototype.materials)}).second)
        strands.push_back(shape);
}

void World::State::build_strand_trees(const Context& context) {
    const std::int64_t before = bytes;
    std::size_t own = 0;
    for (auto& [key, tree] : strand_trees) {
        context.check_cancel();
        tree = build(*key.first, key.second);
        own += tree.own_bytes();
    }
    check();
    strand_figures.bytes = static_cast<std::size_t>(bytes - before) + own;
}

void World::State::add_caps(StrandTree& tree) const {
    tree.caps = end_caps(tree);
    if (tree.caps.empty())
        return;
    const embree::GeometryHandle geometry(
        rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT));
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                               tree.caps.data(), 0, sizeof(StrandCap), tree.caps.size());
    rtcSetGeometryUserData(geometry.get(), tree.caps.data());
    rtcSetGeometryIntersectFilterFunction(geometry.get(), outer_half_only);
    rtcSetGeometryOccludedFilterFunction(geometry.get(), outer_half_only);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(tree.scene.get(), geometry.get(), StrandTree::caps_id);
}

namespace {

/// Embree's arrays of curves; null where memory has run out, as `State::check` reports.
struct CurveArrays {
    CurveArrays(RTCGeometry geometry, std::size_t vertex_count, std::size_t segments, bool linear) {
        vertices = static_cast<Imath::V4f*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                    sizeof(Imath::V4f), vertex_count));
        firsts = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, sizeof(std::uint32_t), segments));
        if (linear)
            flags = static_cast<unsigned char*>(rtcSetNewGeometryBuffer(
                geometry, RTC_BUFFER_TYPE_FLAGS, 0, RTC_FORMAT_UCHAR, 1, segments));
        complete = vertices != nullptr && firsts != nullptr && (!linear || flags != nullptr);
    }

    Imath::V4f* vertices = nullptr;
    std::uint32_t* firsts = nullptr;
    unsigned char* flags = nullptr; // of linear ones alone
    bool complete = false;
};

void keep_splines(StrandTree& tree) {
    tree.own_vertices.resize(tree.strands->points.size());
    tree.own_firsts.resize(tree.strands->segment_count());
    copy_vertices(*tree.strands, tree.own_vertices.data());
    copy_segments(*tree.strands, tree.own_firsts.data(), nullptr);
    tree.vertices = tree.own_vertices.data();
    tree.firsts = tree.own_firsts.data();
}

/// The chains of cones of all splines, each with one vertex more than it has cones.
void fill_chords(StrandTree& tree, const std::vector<std::uint16_t>& counts,
                 const CurveArrays& arrays) {
    const Strands& splines = *tree.strands;
    std::uint32_t piece = 0;
    std::uint32_t vertex = 0;
    std::size_t chord = 0;
    for (std::size_t strand = 0; strand < splines.count(); ++strand) {
        const std::uint32_t end = piece + splines.offsets[strand + 1] - splines.offsets[strand] - 3;
        const std::size_t first = chord;
        for (; piece < end; ++piece)
            for (std::uint16_t k = 0; k < counts[piece]; ++k) {
                tree.chords.push_back({piece, k, counts[piece]});
                arrays.flags[chord] = RTC_CURVE_FLAG_NEIGHBOR_LEFT | RTC_CURVE_FLAG_NEIGHBOR_RIGHT;
                arrays.firsts[chord++] = vertex;
                arrays.vertices[vertex++] =
                    spline_vertex(tree, piece, static_cast<float>(k) / counts[piece]);
            }
        arrays.vertices[vertex++] = spline_vertex(tree, piece - 1, 1);
        arrays.flags[first] &= static_cast<unsigned char>(~RTC_CURVE_FLAG_NEIGHBOR_LEFT);
        arrays.flags[chord - 1] &= static_cast<unsigned char>(~RTC_CURVE_FLAG_NEIGHBOR_RIGHT);
    }
}

} // namespace

StrandTree World::State::build(const Strands& shape, bool is_fibre) const {
    const bool linear = shape.kind == CurveKind::linear;
    const std::vector<std::uint16_t> counts =
        linear ? std::vector<std::uint16_t>{} : chord_counts(shape, most_chords);
    const bool cones = linear || !counts.empty();
    StrandTree made;
    made.strands = &shape;
    made.is_fibre = is_fibre;
    made.scene = new_scene();
    // Compact trees of splines take half of the memory, and rays meet them 5 % more slowly; those
    // of cones save nothing and are 12 % slower.
    rtcSetSceneFlags(made.scene.get(), static_cast<RTCSceneFlags>(
                                           RTC_SCENE_FLAG_ROBUST |
                                           (cones ? RTC_SCENE_FLAG_NONE : RTC_SCENE_FLAG_COMPACT)));
    const embree::GeometryHandle geometry(
        rtcNewGeometry(device.get(), cones ? RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE
                                           : RTC_GEOMETRY_TYPE_ROUND_BSPLINE_CURVE));
    const std::size_t chords = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    const CurveArrays arrays(geometry.get(),
                             counts.empty() ? shape.points.size() : chords + shape.count(),
                             counts.empty() ? shape.segment_count() : chords, cones);
    if (!arrays.complete)
        return made;
    if (counts.empty()) {
        copy_vertices(shape, arrays.vertices);
        copy_segments(shape, arrays.firsts, arrays.flags);
        made.vertices = arrays.vertices;
        made.firsts = arrays.firsts;
    } else {
        keep_splines(made);
        made.chords.reserve(chords);
        fill_chords(made, counts, arrays);
    }
    if (is_fibre) {
        rtcSetGeometryIntersectFilterFunction(geometry.get(), front_only);
        rtcSetGeometryOccludedFilterFunction(geometry.get(), front_only);
    }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(made.scene.get(), geometry.get(), StrandTree::segments_id);
    if (!cones && !is_fibre) // cones have round ends
        add_caps(made);
    rtcCommitScene(made.scene.get());
    made.bounds = embree::bounds(made.scene.get());
    return made;
}

} // namespace scree
