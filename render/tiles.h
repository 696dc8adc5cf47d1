// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/render_options.h"

#include <optional>
#include <string>
#include <vector>

namespace scree {

/// A square of pixels, rendered by one thread at a time.
struct Tile {
    int x0, y0, x1, y1; // [pixels] of the film
    int done = 0;       // samples that each of its pixels has
    int row = 0;        // that many rows, from the top, already have `end`: it was interrupted
    int end = 0;        // samples
    // When it last had as many samples everywhere, of renders with a limit of noise:
    float error = 0;       // relative
    float gain_sum = 0;    // of squared errors over those of independent samples, after each pass
    int passes = 0;        // of that sum
    bool finished = false; // has all samples that were asked for, or little enough noise
};

/// The tiles of a film that belong to a shard, from the top. Every shard gets as many tiles as the
/// others (or one more), spread evenly over the picture in a random order, so that all take about
/// as long.
std::vector<Tile> shard_tiles(int width, int height, const Shard& shard);

/// A shard as users write it: "I/N", with I from 1 to N and N up to 65536. Nothing for other text.
std::optional<Shard> parse_shard(const std::string& text);
std::string shard_text(const Shard& shard);

} // namespace scree
