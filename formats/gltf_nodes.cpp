// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_nodes.h"

#include "core/error.h"
#include "formats/gltf_file.h"

#include <fmt/format.h>

namespace scree::gltf {

namespace {

/// The parent of every node.
std::vector<Index> parents_of(const File& file) {
    std::vector<Index> parents(file.nodes.size());
    for (std::size_t i = 0; i < file.nodes.size(); ++i)
        for (const std::size_t child : file.nodes[i].children) {
            if (parents[child])
                throw Error(fmt::format("nodes[{}] is a child of nodes[{}] and of nodes[{}]; a "
                                        "node has one parent",
                                        child, *parents[child], i));
            parents[child] = i;
        }
    return parents;
}

/// All nodes, parents before their children; without recursion, since chains may be long.
std::vector<std::size_t> from_the_roots(const File& file, const std::vector<Index>& parents) {
    std::vector<std::size_t> order;
    std::vector<bool> reached(file.nodes.size());
    for (std::size_t i = 0; i < file.nodes.size(); ++i)
        if (!parents[i])
            order.push_back(i);
    for (std::size_t next = 0; next < order.size(); ++next) {
        reached[order[next]] = true;
        const std::vector<std::size_t>& children = file.nodes[order[next]].children;
        order.insert(order.end(), children.begin(), children.end());
    }
    for (std::size_t i = 0; i < file.nodes.size(); ++i)
        if (!reached[i])
            throw Error(fmt::format("nodes[{}] is in a ring of children", i));
    return order;
}

} // namespace

Imath::M44d placement(const Imath::V3d& move, const Imath::Quatd& turn, const Imath::V3d& scale) {
    Imath::M44d scaled;
    scaled.setScale(scale);
    Imath::M44d moved;
    moved.setTranslation(move);
    return scaled * turn.normalized().toMatrix44() * moved;
}

NodePlaces node_places(const File& file) {
    const std::vector<Index> parents = parents_of(file);
    NodePlaces places;
    places.world_from_node.resize(file.nodes.size());
    places.seen.resize(file.nodes.size(), file.scenes.empty());
    if (!file.scenes.empty())
        for (const std::size_t node : file.scenes[file.scene.value_or(0)])
            places.seen[node] = true;
    std::vector<bool> hidden(file.nodes.size());
    for (const std::size_t i : from_the_roots(file, parents)) {
        const Node& node = file.nodes[i];
        const Index& parent = parents[i];
        places.world_from_node[i] = parent ? node.parent_from_node * places.world_from_node[*parent]
                                           : node.parent_from_node;
        if (parent && places.seen[*parent])
            places.seen[i] = true;
        hidden[i] = !node.visible || (parent && hidden[*parent]);
    }
    for (std::size_t i = 0; i < file.nodes.size(); ++i)
        if (hidden[i])
            places.seen[i] = false;
    return places;
}

} // namespace scree::gltf
