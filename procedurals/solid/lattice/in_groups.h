// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <span>

namespace scree {

/// Calls work(inputs..., out, count) for all points, with counts that are multiples of 64 and so of
/// the lanes of any vector. The last points are padded with zeros.
template <class Work, class... Inputs>
void in_groups(const Work& work, std::span<float> out, const Inputs&... inputs) {
    constexpr std::size_t group = 64;
    assert(((inputs.size() == out.size()) && ...));
    const std::size_t whole = out.size() / group * group;
    work(inputs.data()..., out.data(), whole);
    if (whole == out.size())
        return;
    const auto padded = [&](std::span<const float> input) {
        std::array<float, group> rest{};
        std::ranges::copy(input.subspan(whole), rest.begin());
        return rest;
    };
    std::array<float, group> found{};
    const auto work_on = [&](const auto&... rests) { work(rests.data()..., found.data(), group); };
    work_on(padded(inputs)...);
    std::copy_n(found.begin(), out.size() - whole, out.begin() + std::ptrdiff_t(whole));
}

} // namespace scree
