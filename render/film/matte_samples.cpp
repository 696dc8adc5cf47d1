// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/film/matte_samples.h"

#include "core/binary_stream.h"

namespace scree {

void MatteSamples::add(std::size_t pixel, std::uint32_t instance, std::uint32_t material) {
    std::vector<Seen>& seen = seen_[pixel];
    for (Seen& known : seen)
        if (known.instance == instance && known.material == material) {
            ++known.samples;
            return;
        }
    seen.push_back({instance, material, 1});
}

void MatteSamples::save(std::ostream& out) const {
    for (const std::vector<Seen>& seen : seen_) {
        write_value(out, static_cast<std::uint32_t>(seen.size()));
        write_values(out, std::span(seen));
    }
}

void MatteSamples::restore(std::istream& in) {
    for (std::vector<Seen>& seen : seen_) {
        const auto count = read_value<std::uint32_t>(in);
        seen.clear();
        // One by one: a damaged file must not ask for memory that it could not fill.
        for (std::uint32_t i = 0; i < count && in; ++i)
            seen.push_back(read_value<Seen>(in));
        if (!in)
            return;
    }
}

} // namespace scree
