// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/film/film.h"

#include "core/binary_stream.h"

#include <bit>
#include <cmath>

namespace scree {

namespace {

double pixel_luminance(const double* rgb) { // ITU-R BT.709
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

} // namespace

Film::Film(int width, int height, const WideVec3& origin, FilmExtras extras)
    : width_(width), height_(height), origin_(origin), extras_(std::move(extras)),
      pixels_(std::size_t(width) * std::size_t(height)),
      group_sums_(pixels_.size() * extras_.light_groups.size(), Color(0.0F)),
      mattes_(extras_.mattes ? pixels_.size() : 0) {}

bool Film::add(int x, int y, const PathSample& sample, float depth, std::span<const Color> groups) {
    Pixel& pixel = pixels_[index(x, y)];
    for (int c = 0; c < 3; ++c)
        if (!(std::isfinite(sample.radiance[c]) && sample.radiance[c] >= 0))
            return false;
    if (pixel.count++ == 0) {
        if (sample.covered)
            pixel.position = Vec3(WideVec3(sample.position) + origin_);
        pixel.depth = sample.covered ? depth : 0;
        pixel.instance = sample.instance + 1; // PathSample::none becomes 0
    } else if (std::has_single_bit(pixel.count - 1)) {
        pixel.quarter_luminance = luminance(pixel.first_radiance);
        for (int c = 0; c < 3; ++c)
            pixel.first_radiance[c] = static_cast<float>(pixel.mean[c] * (pixel.count - 1));
        pixel.first_albedo =
            pixel.albedo + Color(static_cast<float>(pixel.count - 1) - pixel.covered);
        pixel.first_normal = pixel.normal;
    }
    for (int c = 0; c < 3; ++c) {
        const double delta = double(sample.radiance[c]) - pixel.mean[c];
        pixel.mean[c] += delta / pixel.count;
        pixel.square[c] += delta * (double(sample.radiance[c]) - pixel.mean[c]);
    }
    pixel.albedo += sample.albedo;
    pixel.normal += sample.normal;
    pixel.covered += sample.covered ? 1.0F : 0.0F;
    for (std::size_t g = 0; g < groups.size(); ++g)
        group_sums_[index(x, y) * light_groups() + g] += groups[g];
    if (extras_.mattes && sample.instance != PathSample::none)
        mattes_.add(index(x, y), sample.instance, sample.material);
    return true;
}

void Film::save(std::ostream& out) const {
    write_values(out, std::span(pixels_));
    write_values(out, std::span(group_sums_));
    mattes_.save(out);
}

void Film::restore(std::istream& in) {
    read_values(in, std::span(pixels_));
    read_values(in, std::span(group_sums_));
    mattes_.restore(in);
}

double Film::luminance_at(int x, int y) const { return pixel_luminance(at(x, y).mean); }

double Film::luminance_variance(int x, int y) const {
    const Pixel& pixel = at(x, y);
    const double n = pixel.count;
    const double deviations[3] = {std::sqrt(pixel.square[0]), std::sqrt(pixel.square[1]),
                                  std::sqrt(pixel.square[2])};
    const double deviation = pixel_luminance(deviations);
    return n > 1 ? deviation * deviation / (n * (n - 1)) : 0;
}

Film::Differences Film::differences(int x, int y) const {
    const Pixel& pixel = at(x, y);
    if (pixel.count < 2)
        return {};
    const double n = pixel.count;
    const double first = std::bit_floor(pixel.count - 1);
    const double sum_of_first = double(luminance(pixel.first_radiance));
    const double apart =
        sum_of_first / first - (luminance_at(x, y) * n - sum_of_first) / (n - first);
    Differences out;
    out.halves = apart * apart * first * (n - first) / (n * n);
    if (first >= 2) {
        const double between = (2 * double(pixel.quarter_luminance) - sum_of_first) * 2 / first;
        out.quarters = between * between / 4;
    }
    return out;
}

Film::Halves Film::halves(int x, int y) const {
    const Pixel& pixel = at(x, y);
    const auto means = [](std::uint32_t samples, const Color& radiance, const Color& albedo,
                          const Vec3& normal) {
        const float share = samples > 0 ? 1 / static_cast<float>(samples) : 0;
        return Means{samples, radiance * share, albedo * share, normal * share};
    };
    Color radiance;
    for (int c = 0; c < 3; ++c)
        radiance[c] = static_cast<float>(pixel.mean[c] * pixel.count);
    const Color albedo = pixel.albedo + Color(static_cast<float>(pixel.count) - pixel.covered);
    const std::uint32_t first = pixel.count > 1 ? std::bit_floor(pixel.count - 1) : 0;
    Halves halves{means(pixel.count, radiance, albedo, pixel.normal),
                  means(first, pixel.first_radiance, pixel.first_albedo, pixel.first_normal),
                  means(pixel.count - first, radiance - pixel.first_radiance,
                        albedo - pixel.first_albedo, pixel.normal - pixel.first_normal)};
    const double n = pixel.count;
    for (int c = 0; c < 3 && n > 1; ++c)
        halves.variance[c] = static_cast<float>(pixel.square[c] / (n * (n - 1)));
    return halves;
}

template <class Value>
Image Film::picture(std::vector<std::string> channels, const Value& value) const {
    Image image(width_, height_, std::move(channels));
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
            if (at(x, y).count > 0)
                value(at(x, y), image.at(x, y));
    return image;
}

Image Film::beauty() const {
    return picture({"R", "G", "B", "A"}, [](const Pixel& pixel, float* out) {
        for (int c = 0; c < 3; ++c)
            out[c] = static_cast<float>(pixel.mean[c]);
        out[3] = pixel.covered / static_cast<float>(pixel.count);
    });
}

Image Film::light_group(std::size_t group) const {
    Image image(width_, height_, {"R", "G", "B"});
    for (std::size_t i = 0; i < pixels_.size(); ++i)
        for (int c = 0; c < 3 && pixels_[i].count > 0; ++c)
            image.pixels[3 * i + std::size_t(c)] =
                group_sums_[i * light_groups() + group][c] / static_cast<float>(pixels_[i].count);
    return image;
}

std::vector<ImagePart> Film::parts() const {
    std::vector<ImagePart> parts;
    parts.push_back({"beauty", beauty(), true});
    parts.push_back({"albedo",
                     picture({"R", "G", "B"},
                             [](const Pixel& pixel, float* out) {
                                 for (int c = 0; c < 3; ++c)
                                     out[c] = pixel.albedo[c] / static_cast<float>(pixel.count);
                             }),
                     false});
    parts.push_back({"N",
                     picture({"X", "Y", "Z"},
                             [](const Pixel& pixel, float* out) {
                                 for (int c = 0; c < 3; ++c)
                                     out[c] = pixel.normal[c] / static_cast<float>(pixel.count);
                             }),
                     false});
    parts.push_back(
        {"Z", picture({"Z"}, [](const Pixel& pixel, float* out) { out[0] = pixel.depth; }), true});
    parts.push_back({"P",
                     picture({"X", "Y", "Z"},
                             [](const Pixel& pixel, float* out) {
                                 for (int c = 0; c < 3; ++c)
                                     out[c] = pixel.position[c];
                             }),
                     true});
    parts.push_back(
        {"instance",
         picture({"id"}, [](const Pixel& pixel,
                            float* out) { out[0] = static_cast<float>(pixel.instance); }),
         true});
    parts.push_back({"variance",
                     picture({"R", "G", "B"},
                             [](const Pixel& pixel, float* out) {
                                 const double n = pixel.count;
                                 for (int c = 0; c < 3 && n > 1; ++c)
                                     out[c] = static_cast<float>(pixel.square[c] / (n * (n - 1)));
                             }),
                     true});
    for (std::size_t g = 0; g < light_groups(); ++g)
        parts.push_back({"light_" + extras_.light_groups[g], light_group(g), true});
    return parts;
}

} // namespace scree
