// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "render/film/color.h"
#include "render/render_options.h"

#include <span>
#include <string>

namespace scree {

/// What a shard's picture says of itself, beside the provenance, so that all can be put together.
struct ShardFacts {
    Shard shard;
    std::uint64_t samples = 0; // of all its pixels
    bool interrupted = false;
    PngLook look{};
};

/// The attributes of a shard's header.
Metadata shard_metadata(const ShardFacts& facts);

/// The sample count per pixel as pictures' headers hold it.
std::pair<std::string, std::string> samples_metadata(double samples_per_pixel);

/// A whole picture, as if it had been rendered in one piece.
struct MergedShards {
    ExrFile picture;
    PngLook look;
};

/// Puts the pictures of all shards together. Throws Error (input) naming the file for one that is
/// not a shard, of another picture than the first, interrupted or given twice, and when some are
/// missing.
MergedShards merge_shards(std::span<const std::string> paths);

} // namespace scree
