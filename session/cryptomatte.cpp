// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/cryptomatte.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>
#include <set>

namespace scree {

namespace {

constexpr std::size_t most_named = 10000; // every part of the file repeats the names
constexpr std::size_t ranks = 6;          // names per pixel; compositors expect as many

std::uint32_t murmur3(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return std::uint32_t(static_cast<unsigned char>(text[i]));
    };
    const auto scramble = [](std::uint32_t k) {
        return std::rotl(k * 0xcc9e2d51U, 15) * 0x1b873593U;
    };
    std::uint32_t hash = 0;
    std::size_t i = 0;
    for (; i + 4 <= text.size(); i += 4) {
        const std::uint32_t block =
            byte(i) | byte(i + 1) << 8 | byte(i + 2) << 16 | byte(i + 3) << 24;
        hash = std::rotl(hash ^ scramble(block), 13) * 5 + 0xe6546b64U;
    }
    std::uint32_t tail = 0;
    for (std::size_t j = text.size(); j > i; --j)
        tail = tail << 8 | byte(j - 1);
    hash ^= scramble(tail);
    hash ^= static_cast<std::uint32_t>(text.size());
    hash = (hash ^ hash >> 16) * 0x85ebca6bU;
    hash = (hash ^ hash >> 13) * 0xc2b2ae35U;
    return hash ^ hash >> 16;
}

/// Names that are given once each: "stones", "stones.2".
class UniqueNames {
  public:
    std::string operator()(const std::string& name) {
        std::string unique = name;
        for (int number = 2; !given_.insert(unique).second; ++number)
            unique = fmt::format("{}.{}", name, number);
        return unique;
    }

  private:
    std::set<std::string> given_;
};

std::vector<std::string> object_names(std::span<const Aggregate> aggregates) {
    std::vector<std::string> names;
    UniqueNames unique;
    for (const Aggregate& aggregate : aggregates)
        names.push_back(unique(aggregate.name.empty() ? aggregate.generator : aggregate.name));
    return names;
}

std::vector<std::string> instance_names(std::span<const Aggregate> aggregates) {
    std::vector<std::string> names;
    const std::vector<std::string> objects = object_names(aggregates);
    for (std::size_t a = 0; a < aggregates.size(); ++a)
        for (std::size_t i = 0; i < aggregates[a].instances.size(); ++i)
            names.push_back(fmt::format(
                "{}/{}.{}", objects[a],
                aggregates[a].prototypes[aggregates[a].instances[i].prototype].name, i + 1));
    return names;
}

struct KindOf {
    const char* operator()(const Matte& /*material*/) const { return "matte"; }
    const char* operator()(const Plastic& /*material*/) const { return "plastic"; }
    const char* operator()(const Metal& /*material*/) const { return "metal"; }
    const char* operator()(const Glass& /*material*/) const { return "glass"; }
    const char* operator()(const Translucent& /*material*/) const { return "translucent"; }
    const char* operator()(const Fibre& /*material*/) const { return "fibre"; }
    const char* operator()(const std::shared_ptr<const CustomMaterial>& /*material*/) const {
        return "custom";
    }
};

// The same material may be there several times, as part of different objects.
std::vector<std::string>
material_names(std::span<const std::shared_ptr<const Material>> materials) {
    std::vector<std::string> names;
    std::map<const Material*, std::string> known;
    UniqueNames unique;
    for (const auto& material : materials) {
        std::string& name = known[material.get()];
        if (name.empty())
            name = unique(std::visit(KindOf{}, *material));
        names.push_back(name);
    }
    return names;
}

// One for each object, repeated for each of its instances.
std::vector<std::uint32_t> by_instance(std::span<const std::uint32_t> of_objects,
                                       std::span<const Aggregate> aggregates) {
    std::vector<std::uint32_t> ids;
    for (std::size_t a = 0; a < aggregates.size(); ++a)
        ids.insert(ids.end(), aggregates[a].instances.size(), of_objects[a]);
    return ids;
}

Metadata metadata_of(std::string_view layer, std::span<const std::string> names) {
    const std::string key =
        "cryptomatte/" + fmt::format("{:08x}", cryptomatte_id(layer)).substr(0, 7) + "/";
    Metadata metadata{{key + "name", std::string(layer)},
                      {key + "hash", "MurmurHash3_32"},
                      {key + "conversion", "uint32_to_float32"}};
    if (names.size() > most_named)
        return metadata;
    nlohmann::json manifest = nlohmann::json::object();
    for (const std::string& name : names)
        manifest[name] = fmt::format("{:08x}", cryptomatte_id(name));
    metadata.emplace_back(key + "manifest", manifest.dump());
    return metadata;
}

/// A name's share of a pixel.
struct Share {
    std::uint32_t id;
    std::uint32_t samples;
};

// The names of a pixel, those with the largest shares first.
void find_shares(std::span<const Seen> seen, const auto& id_of, std::vector<Share>& shares) {
    shares.clear();
    for (const Seen& one : seen) {
        const std::uint32_t id = id_of(one);
        const auto known = std::ranges::find(shares, id, &Share::id);
        if (known == shares.end())
            shares.push_back({id, one.samples});
        else
            known->samples += one.samples;
    }
    std::ranges::sort(shares, [](const Share& a, const Share& b) {
        return a.samples != b.samples ? a.samples > b.samples : a.id < b.id;
    });
}

} // namespace

std::uint32_t cryptomatte_id(std::string_view name) {
    const std::uint32_t hash = murmur3(name);
    const std::uint32_t exponent = hash >> 23 & 255;
    return exponent == 0 || exponent == 255 ? hash ^ 1U << 23 : hash;
}

Cryptomatte make_cryptomatte(std::string_view layer, const Film& film,
                             std::span<const Aggregate> aggregates,
                             std::span<const std::shared_ptr<const Material>> materials) {
    assert(film.has_mattes());
    const bool by_material = layer == cryptomatte_layers[2];
    const std::vector<std::string> names = by_material ? material_names(materials)
                                           : layer == cryptomatte_layers[1]
                                               ? instance_names(aggregates)
                                               : object_names(aggregates);
    std::vector<std::uint32_t> ids;
    ids.reserve(names.size());
    for (const std::string& name : names)
        ids.push_back(cryptomatte_id(name));
    if (layer == cryptomatte_layers[0])
        ids = by_instance(ids, aggregates);
    const auto id_of = [&](const Seen& seen) {
        return ids[by_material ? seen.material : seen.instance];
    };

    Cryptomatte out;
    out.metadata = metadata_of(layer, names);
    for (std::size_t level = 0; level < ranks / 2; ++level)
        out.parts.push_back({fmt::format("{}{:02}", layer, level),
                             Image(film.width(), film.height(), {"R", "G", "B", "A"}), true});
    std::vector<Share> shares;
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x) {
            find_shares(film.seen(x, y), id_of, shares);
            const auto whole = static_cast<float>(film.samples(x, y));
            for (std::size_t rank = 0; rank < std::min(ranks, shares.size()); ++rank) {
                float* const out_pixel = out.parts[rank / 2].image.at(x, y) + rank % 2 * 2;
                out_pixel[0] = std::bit_cast<float>(shares[rank].id);
                out_pixel[1] = static_cast<float>(shares[rank].samples) / whole;
            }
        }
    return out;
}

} // namespace scree
