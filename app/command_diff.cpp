// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/exr_part.h"
#include "app/standard_streams.h"
#include "core/error.h"
#include "core/image.h"
#include "core/utf8.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace scree {

namespace {

struct DiffOptions {
    std::string a;
    std::string b;
    std::string part; // empty: the first of a
    std::optional<double> max;
};

const ImagePart* find_part(const ExrFile& file, const std::string& name) {
    for (const ImagePart& part : file.parts)
        if (part.name == name)
            return &part;
    return nullptr;
}

struct Difference {
    double rmse = 0;
    double largest = 0;
    int x = 0; // pixel with the largest difference
    int y = 0;
    double mean_z2 = 0; // mean of squared difference / variance; 1 if only the noise differs
    bool has_variance = false;
    bool same_bits = true;
};

// The variance parts of both pictures hold the variance of each pixel's mean in the beauty, so
// (a - b)^2 divided by their sum has mean 1 when the pictures differ by noise only.
Difference compare(const Image& a, const Image& b, const ImagePart* variance_a,
                   const ImagePart* variance_b) {
    Difference out;
    out.has_variance = variance_a != nullptr && variance_b != nullptr &&
                       variance_a->image.channels.size() >= 3 &&
                       variance_b->image.channels.size() >= 3;
    const std::size_t channels = std::min<std::size_t>({3, a.channels.size(), b.channels.size()});
    double sum = 0;
    double z2 = 0;
    std::size_t z_count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            for (std::size_t c = 0; c < channels; ++c) {
                const double d = double(a.at(x, y)[c]) - double(b.at(x, y)[c]);
                out.same_bits = out.same_bits && d == 0;
                sum += d * d;
                if (!(std::abs(d) <= out.largest)) {
                    out.largest = std::abs(d);
                    out.x = x;
                    out.y = y;
                }
                if (!out.has_variance)
                    continue;
                const double v =
                    double(variance_a->image.at(x, y)[c]) + double(variance_b->image.at(x, y)[c]);
                if (v <= 0)
                    continue;
                z2 += d * d / v;
                ++z_count;
            }
        }
    }
    out.rmse = std::sqrt(sum / (double(a.width) * a.height * double(channels)));
    out.mean_z2 = z_count > 0 ? z2 / double(z_count) : 0;
    return out;
}

/// Colours, or what else the first three channels hold, must be the same.
void check_alike(const Image& a, const Image& b, const DiffOptions& options) {
    if (a.width != b.width || a.height != b.height)
        throw Error(fmt::format("{} is {} x {} pixels and {} is {} x {}", options.a, a.width,
                                a.height, options.b, b.width, b.height));
    const auto compared = [](const Image& image) {
        std::vector<std::string> names = image.channels;
        names.resize(std::min<std::size_t>(names.size(), 3));
        return names;
    };
    if (compared(a) != compared(b))
        throw Error(fmt::format("{} has the channels {} and {} has {}", options.a,
                                fmt::join(a.channels, ", "), options.b,
                                fmt::join(b.channels, ", ")));
}

int diff(const DiffOptions& options) {
    const ExrFile a = read_exr(options.a);
    const ExrFile b = read_exr(options.b);
    const ImagePart& part_a =
        options.part.empty() ? a.parts.front() : named_part(a, options.a, options.part);
    const bool by_order = options.part.empty() && (part_a.name.empty() || b.parts.size() == 1);
    const ImagePart& part_b =
        by_order ? b.parts.front()
                 : named_part(b, options.b, options.part.empty() ? part_a.name : options.part);
    check_alike(part_a.image, part_b.image, options);
    if (options.part.empty() && a.parts.size() + b.parts.size() > 2)
        print_result(visible(fmt::format("compares the part {}; {} has: {}\n", part_a.name,
                                         options.a, part_names(a))));
    const bool is_first = &part_a == &a.parts.front();
    const Difference d =
        compare(part_a.image, part_b.image, is_first ? find_part(a, "variance") : nullptr,
                is_first ? find_part(b, "variance") : nullptr);
    print_result(
        fmt::format("rmse {:.6g}, largest {:.6g} at ({}, {})", d.rmse, d.largest, d.x, d.y));
    if (d.has_variance)
        print_result(fmt::format(", mean squared difference over variance {:.3f}", d.mean_z2));
    print_result(fmt::format("{}\n", d.same_bits ? ", pixels identical" : ""));
    const bool within = d.rmse <= options.max.value_or(0);
    if (!within && options.max)
        print_result(fmt::format("rmse is above {:.6g}\n", *options.max));
    return within ? 0 : 1;
}

} // namespace

void add_diff_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<DiffOptions>();
    CLI::App* command = app.add_subcommand(
        "diff", "Compare two pictures; exit code 1 when their RMSE is above --max (default 0).");
    command->add_option("A", options->a, "First .exr")->required();
    command->add_option("B", options->b, "Second .exr")->required();
    command
        ->add_option(
            "--part", options->part,
            "Part of multi-part files (default: the first of A, and of the same name in B)")
        ->type_name("NAME");
    command->add_option("--max", options->max, "Largest RMSE that counts as the same")
        ->check(CLI::NonNegativeNumber);
    command->footer("Example:\n  scree diff before.exr after.exr --max 0.01");
    command->callback([options, &run] { run = [options] { return diff(*options); }; });
}

} // namespace scree
