// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/merge_shards.h"

#include "core/error.h"
#include "render/tiles.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace scree {

namespace {

constexpr const char* shard_key = "scree:shard";
constexpr const char* samples_key = "scree:samples";
constexpr const char* shard_prefix = "scree:shard";

/// One shard's file.
struct ShardFile {
    std::string path;
    ExrFile file;
    ShardFacts facts;
};

Error wrong(const ShardFile& shard, const std::string& message, const std::string& hint = {}) {
    return Error(Diagnostic{{}, {}, shard.path + ": " + message, hint});
}

std::string text_of(const Metadata& metadata, const std::string& key) {
    for (const auto& [name, value] : metadata)
        if (name == key)
            return value;
    return {};
}

// The last of `samples` and of what is said of the shard alone is left out.
Metadata common(const Metadata& metadata) {
    Metadata out = metadata;
    std::erase_if(out, [](const auto& entry) {
        return entry.first.starts_with(shard_prefix) || entry.first == samples_key;
    });
    std::ranges::sort(out);
    return out;
}

ShardFile read_shard(const std::string& path) {
    ShardFile shard{path, read_exr(path), {}};
    const Metadata& metadata = shard.file.metadata;
    const std::string given = text_of(metadata, shard_key);
    ShardFacts& facts = shard.facts;
    const std::optional<Shard> parsed = parse_shard(given);
    if (!parsed)
        throw wrong(shard, "is not a shard", "shards are made by scree render --shard I/N");
    facts.shard = *parsed;
    const std::string samples = text_of(metadata, "scree:shard_samples");
    std::from_chars(samples.data(), samples.data() + samples.size(), facts.samples);
    facts.interrupted = text_of(metadata, "scree:shard_interrupted") == "yes";
    facts.look.view = text_of(metadata, "scree:shard_view");
    std::sscanf(text_of(metadata, "scree:shard_exposure").c_str(), "%f", &facts.look.exposure);
    if (text_of(metadata, "scree:shard_png_bits") == "16")
        facts.look.depth = PngDepth::sixteen;
    return shard;
}

bool same_window(const std::optional<PictureWindow>& a, const std::optional<PictureWindow>& b) {
    if (!a || !b)
        return a.has_value() == b.has_value();
    return a->x == b->x && a->y == b->y && a->whole_width == b->whole_width &&
           a->whole_height == b->whole_height;
}

void check_alike(const ShardFile& first, const ShardFile& other) {
    if (other.facts.shard.count != first.facts.shard.count)
        throw wrong(other,
                    fmt::format("is one of {} shards, but {} is one of {}", other.facts.shard.count,
                                first.path, first.facts.shard.count));
    const Metadata expected = common(first.file.metadata);
    const Metadata given = common(other.file.metadata);
    const auto [a, b] = std::ranges::mismatch(expected, given);
    if (a != expected.end() || b != given.end())
        throw wrong(other, fmt::format("is of another picture than {}: their {} differ", first.path,
                                       a != expected.end() ? a->first : b->first));
    const auto same_part = [](const ImagePart& x, const ImagePart& y) {
        return x.name == y.name && x.image.channels == y.image.channels &&
               x.image.width == y.image.width && x.image.height == y.image.height;
    };
    if (!std::ranges::equal(first.file.parts, other.file.parts, same_part) ||
        !same_window(first.file.window, other.file.window))
        throw wrong(other,
                    fmt::format("has another size, crop or other parts than {}", first.path));
}

void copy_tiles(const ShardFile& from, ExrFile& to) {
    for (std::size_t i = 0; i < to.parts.size(); ++i) {
        const Image& source = from.file.parts[i].image;
        Image& target = to.parts[i].image;
        const std::size_t channels = source.channels.size();
        for (const Tile& tile : shard_tiles(source.width, source.height, from.facts.shard))
            for (int y = tile.y0; y < tile.y1; ++y)
                std::copy_n(source.at(tile.x0, y), std::size_t(tile.x1 - tile.x0) * channels,
                            target.at(tile.x0, y));
    }
}

void check_complete(const std::vector<std::string>& path_of) {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < path_of.size(); ++i)
        if (path_of[i].empty())
            missing.push_back(i + 1);
    if (!missing.empty())
        throw Error(fmt::format("of {} shards, these are missing: {}", path_of.size(),
                                fmt::join(missing, ", ")));
}

} // namespace

Metadata shard_metadata(const ShardFacts& facts) {
    Metadata metadata{{shard_key, shard_text(facts.shard)},
                      {"scree:shard_samples", std::to_string(facts.samples)},
                      {"scree:shard_exposure", fmt::format("{}", facts.look.exposure)},
                      {"scree:shard_view", facts.look.view},
                      {"scree:shard_png_bits", std::to_string(static_cast<int>(facts.look.depth))}};
    if (facts.interrupted)
        metadata.emplace_back("scree:shard_interrupted", "yes");
    return metadata;
}

std::pair<std::string, std::string> samples_metadata(double samples_per_pixel) {
    return {samples_key, fmt::format("{:g}", samples_per_pixel)};
}

MergedShards merge_shards(std::span<const std::string> paths) {
    ShardFile first = read_shard(paths.front());
    std::vector<std::string> path_of(static_cast<std::size_t>(first.facts.shard.count));
    std::uint64_t samples = 0;
    const auto take = [&](const ShardFile& shard) {
        if (shard.facts.interrupted)
            throw wrong(shard, "was interrupted", "finish it with --resume");
        std::string& known = path_of[static_cast<std::size_t>(shard.facts.shard.index)];
        if (!known.empty())
            throw wrong(shard, fmt::format("is the same shard as {}", known));
        known = shard.path;
        samples += shard.facts.samples;
    };
    take(first);
    for (const std::string& path : paths.subspan(1)) {
        const ShardFile shard = read_shard(path);
        check_alike(first, shard);
        take(shard);
        copy_tiles(shard, first.file);
    }
    check_complete(path_of);
    MergedShards merged{std::move(first.file), first.facts.look};
    Metadata& metadata = merged.picture.metadata;
    std::erase_if(metadata,
                  [](const auto& entry) { return entry.first.starts_with(shard_prefix); });
    const Image& image = merged.picture.parts.front().image;
    for (auto& [name, value] : metadata)
        if (name == samples_key)
            value = samples_metadata(double(samples) / (double(image.width) * image.height)).second;
    return merged;
}

} // namespace scree
