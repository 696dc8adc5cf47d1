// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"

#include <string>
#include <vector>

namespace scree {

/// Applies one to eight random mutations: flipped bits, changed bytes, truncations, deletions,
/// repetitions, and insertion or overwriting with one of `pieces`.
inline std::string damaged(std::string bytes, const std::vector<std::string>& pieces,
                           Random& random) {
    const std::uint32_t steps = 1 + random.below(8);
    for (std::uint32_t k = 0; k < steps && !bytes.empty(); ++k) {
        const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
        switch (random.below(7)) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
            break;
        case 1:
            bytes[at] = static_cast<char>(random.below(256));
            break;
        case 2:
            bytes.resize(at);
            break;
        case 3:
            bytes.erase(at, 1 + random.below(16));
            break;
        case 4:
            bytes.insert(at, bytes.substr(at, 1 + random.below(64)));
            break;
        case 5:
            bytes.insert(at, pieces[random.below(static_cast<std::uint32_t>(pieces.size()))]);
            break;
        default: {
            const std::string& piece =
                pieces[random.below(static_cast<std::uint32_t>(pieces.size()))];
            bytes.replace(at, piece.size(), piece);
        }
        }
    }
    return bytes;
}

} // namespace scree
