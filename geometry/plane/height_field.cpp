// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/height_field.h"

#include "core/error.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace scree {

namespace {

/// Four neighbouring pixels along one axis and how much each counts.
struct Taps {
    std::array<int, 4> index;
    std::array<float, 4> weight;
};

Taps taps(double at, int count, bool tiles) { // `at` in pixels, 0 at the first one's centre
    const double floor = std::floor(at);
    const auto t = static_cast<float>(at - floor);
    const float t2 = t * t, t3 = t2 * t;
    Taps result{{},
                {0.5F * (-t3 + 2 * t2 - t), 0.5F * (3 * t3 - 5 * t2 + 2),
                 0.5F * (-3 * t3 + 4 * t2 + t), 0.5F * (t3 - t2)}};
    for (int k = 0; k < 4; ++k) {
        const double index = floor + k - 1;
        result.index[std::size_t(k)] =
            tiles ? static_cast<int>(index - count * std::floor(index / count))
                  : static_cast<int>(std::clamp(index, 0.0, double(count - 1)));
    }
    return result;
}

template <std::size_t channels>
std::array<float, channels> interpolate(const HeightField& field, const Vec2& uv) {
    const Image& image = field.image;
    assert(image.channels.size() == channels);
    const Taps x = taps(uv.x * image.width - 0.5, image.width, field.tiles);
    const Taps y = taps((1 - uv.y) * image.height - 0.5, image.height, field.tiles);
    std::array<float, channels> sum{};
    for (std::size_t j = 0; j < 4; ++j) {
        std::array<float, channels> row{};
        for (std::size_t i = 0; i < 4; ++i) {
            const float* pixel = image.at(x.index[i], y.index[j]);
            for (std::size_t c = 0; c < channels; ++c)
                row[c] += x.weight[i] * pixel[c];
        }
        for (std::size_t c = 0; c < channels; ++c)
            sum[c] += y.weight[j] * row[c];
    }
    return sum;
}

} // namespace

float HeightField::height(const Vec2& uv) const {
    return is_vector() ? interpolate<3>(*this, uv)[1] : interpolate<1>(*this, uv)[0];
}

Vec3 HeightField::offset(const Vec2& uv) const {
    if (!is_vector())
        return {0.0F, height(uv), 0.0F};
    const std::array<float, 3> xyz = interpolate<3>(*this, uv);
    return {xyz[0], xyz[1], xyz[2]};
}

HeightField HeightField::as_vector() const {
    if (is_vector())
        return *this;
    HeightField result{Image(image.width, image.height, {"R", "G", "B"}), size, mid_level, tiles};
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        result.image.pixels[3 * i + 1] = image.pixels[i];
    return result;
}

HeightField HeightField::as_height() const {
    if (!is_vector())
        return *this;
    HeightField result{Image(image.width, image.height, {"Y"}), size, mid_level, tiles};
    for (std::size_t i = 0; i < result.image.pixels.size(); ++i)
        result.image.pixels[i] = image.pixels[3 * i + 1];
    return result;
}

void write_height(const std::string& path, const HeightField& field, const Metadata& metadata) {
    const ImagePart part{field.is_vector() ? "displacement" : "height", field.image, true};
    const auto f = [](double value) { return static_cast<float>(value); };
    write_exr(path, std::span(&part, 1), metadata,
              {{"worldSize", {f(field.size.x), f(field.size.y)}},
               {"midlevel", {f(field.mid_level)}},
               {"tiles", {field.tiles ? 1.0F : 0.0F}}});
}

HeightField read_height(const std::string& path) {
    ExrFile file = read_exr(path);
    HeightField field;
    field.image = std::move(file.parts.front().image);
    const std::vector<std::string>& channels = field.image.channels;
    if (channels != std::vector<std::string>{"Y"} &&
        channels != std::vector<std::string>{"R", "G", "B"})
        throw Error(path + ": is not a height map: expected channel Y, or R, G and B");
    const auto number = [&](const std::string& name) -> const std::vector<float>* {
        for (const auto& [key, value] : file.numbers)
            if (key == name)
                return &value;
        return nullptr;
    };
    const std::vector<float>* size = number("worldSize");
    if (size == nullptr || size->size() != 2)
        throw Error(path + ": its header has no worldSize; expected two numbers in metres");
    field.size = {(*size)[0], (*size)[1]};
    if (!(field.size.x > 0 && field.size.y > 0 && std::isfinite(field.size.x) &&
          std::isfinite(field.size.y)))
        throw Error(path + ": its worldSize must be above 0");
    if (const std::vector<float>* mid = number("midlevel"))
        field.mid_level = mid->front();
    if (const std::vector<float>* tiles = number("tiles"))
        field.tiles = tiles->front() != 0;
    if (!std::all_of(field.image.pixels.begin(), field.image.pixels.end(),
                     [](float v) { return std::isfinite(v); }))
        throw Error(path + ": holds values that are not finite");
    return field;
}

} // namespace scree
