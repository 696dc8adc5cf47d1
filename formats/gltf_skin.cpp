// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_skin.h"

#include "core/error.h"

#include <fmt/format.h>

namespace scree::gltf {

namespace {

/// For each joint: from where a vertex lies in the mesh to where the joint takes it.
std::vector<Imath::M44d> joint_matrices(const File& file, std::size_t number,
                                        const NodePlaces& places, Data& data) {
    const Skin& skin = file.skins[number];
    std::vector<double> inverse;
    if (skin.inverse_bind_matrices) {
        inverse = data.numbers(*skin.inverse_bind_matrices, 16);
        if (inverse.size() < 16 * skin.joints.size())
            throw Error(fmt::format("skins[{}] has {} joints, but {} inverse bind matrices", number,
                                    skin.joints.size(), inverse.size() / 16));
    }
    std::vector<Imath::M44d> out;
    for (std::size_t joint = 0; joint < skin.joints.size(); ++joint) {
        Imath::M44d bind;
        for (std::size_t i = 0; i < 16 && !inverse.empty(); ++i)
            bind[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = inverse[16 * joint + i];
        out.push_back(bind * places.world_from_node[skin.joints[joint]]);
    }
    return out;
}

} // namespace

std::vector<Imath::M44d> skin_matrices(const File& file, std::size_t skin,
                                       const Primitive& primitive, std::size_t vertices,
                                       const NodePlaces& places, Data& data) {
    const std::vector<Imath::M44d> joints = joint_matrices(file, skin, places, data);
    std::vector<Imath::M44d> out(vertices, Imath::M44d(0.0));
    std::vector<double> sums(vertices);
    for (std::size_t set = 0;; ++set) { // four joints a vertex in each
        const auto names = primitive.attributes.find(fmt::format("JOINTS_{}", set));
        const auto shares = primitive.attributes.find(fmt::format("WEIGHTS_{}", set));
        if (names == primitive.attributes.end() || shares == primitive.attributes.end())
            break;
        const std::vector<double> numbers = data.numbers(names->second, 4);
        const std::vector<double> weights = data.numbers(shares->second, 4);
        if (numbers.size() != 4 * vertices || weights.size() != 4 * vertices)
            throw Error(
                fmt::format("{}: its JOINTS_{} and WEIGHTS_{} do not match its {} positions",
                            primitive.path, set, set, vertices));
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (weights[i] == 0)
                continue;
            if (!(numbers[i] >= 0 && numbers[i] < double(joints.size())))
                throw Error(fmt::format("{}: vertex {} names joint {} of {} in skins[{}]",
                                        primitive.path, i / 4, numbers[i], joints.size(), skin));
            out[i / 4] += joints[static_cast<std::size_t>(numbers[i])] * weights[i];
            sums[i / 4] += weights[i];
        }
    }
    for (std::size_t i = 0; i < vertices; ++i) {
        if (!(sums[i] > 0))
            throw Error(
                fmt::format("{}: vertex {} has no joint of skins[{}]", primitive.path, i, skin));
        out[i] *= 1 / sums[i]; // weights of integers sum to 1 but for rounding
    }
    return out;
}

} // namespace scree::gltf
