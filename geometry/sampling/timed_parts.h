// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace scree {

/// Parts of many cells, each with the time of its next event. Every cell has a pairing heap
/// (Fredman et al. 1986) that gives its earliest part; the nodes of all heaps share one array. The
/// parts, which are large, lie in another, so that merging touches little memory.
template <class Part>
class TimedParts {
  public:
    static constexpr std::int32_t none = -1;

    /// The root of one cell's heap.
    using Root = std::int32_t;

    /// Makes room for `count` parts.
    void reserve(std::size_t count) {
        nodes_.reserve(count);
        parts_.reserve(count);
    }

    void add(Root& root, Part part, float time) {
        std::int32_t slot = unused_;
        if (slot == none) {
            slot = static_cast<std::int32_t>(nodes_.size());
            nodes_.emplace_back();
            parts_.push_back(std::move(part));
        } else {
            unused_ = at(slot).next;
            part_at(slot) = std::move(part);
        }
        at(slot) = {time, none, none};
        root = merged(root, slot);
    }

    float time(Root root) const { return nodes_[static_cast<std::size_t>(root)].time; }

    /// Takes out the earliest part.
    Part take(Root& root) {
        const std::int32_t slot = root;
        Part part = std::move(part_at(slot));
        root = merged_all(at(slot).child);
        free(slot);
        return part;
    }

    /// Takes out all parts, and gives keep(part, time) each, whose answer says whether the part,
    /// which it may change with its time, stays.
    template <class Keep>
    void filter(Root& root, const Keep& keep) {
        std::vector<std::int32_t> open;
        if (root != none)
            open.push_back(root);
        root = none;
        while (!open.empty()) {
            const std::int32_t slot = open.back();
            open.pop_back();
            Node& node = at(slot);
            for (std::int32_t child = node.child; child != none; child = at(child).next)
                open.push_back(child);
            node.child = node.next = none;
            if (keep(part_at(slot), node.time))
                root = merged(root, slot);
            else
                free(slot);
        }
    }

  private:
    struct Node {
        float time = 0;
        std::int32_t child = none;
        std::int32_t next = none; // sibling, or the next unused
    };

    Node& at(std::int32_t slot) { return nodes_[static_cast<std::size_t>(slot)]; }
    Part& part_at(std::int32_t slot) { return parts_[static_cast<std::size_t>(slot)]; }

    void free(std::int32_t slot) {
        at(slot).next = unused_;
        unused_ = slot;
    }

    std::int32_t merged(std::int32_t a, std::int32_t b) {
        if (a == none || b == none)
            return a == none ? b : a;
        if (at(b).time < at(a).time)
            std::swap(a, b);
        at(b).next = at(a).child;
        at(a).child = b;
        return a;
    }

    // Siblings in pairs, then all of those from the last to the first.
    std::int32_t merged_all(std::int32_t first) {
        std::int32_t pairs = none;
        while (first != none) {
            const std::int32_t second = at(first).next;
            const std::int32_t rest = second == none ? none : at(second).next;
            at(first).next = none;
            if (second != none)
                at(second).next = none;
            const std::int32_t pair = merged(first, second);
            at(pair).next = pairs;
            pairs = pair;
            first = rest;
        }
        std::int32_t root = none;
        while (pairs != none) {
            const std::int32_t next = at(pairs).next;
            at(pairs).next = none;
            root = merged(root, pairs);
            pairs = next;
        }
        return root;
    }

    std::vector<Node> nodes_;
    std::vector<Part> parts_; // of the nodes
    std::int32_t unused_ = none;
};

} // namespace scree
