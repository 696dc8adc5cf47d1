// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture.h"

#include "core/drawing.h"
#include "core/drawing_raster.h"
#include "core/error.h"
#include "core/file.h"
#include "core/memory_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace scree {

namespace {

// Usual drawings have at most 1 MB.
constexpr std::uint64_t largest_drawing = std::uint64_t{16} << 20;

// By content, as for images: XML begins with "<".
bool is_drawing(const std::string& path) {
    if (extension(path) == "svg")
        return true;
    std::ifstream in(path, std::ios::binary);
    std::string start(256, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(in.gcount()));
    const std::size_t first = start.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    return first != std::string::npos && start[first] == '<';
}

Box2 unit_box(const Vec2& size) {
    const Vec2 half = size / (2 * std::max(size.x, size.y));
    return {-half, half};
}

// Converts Y, Y A, R G B and R G B A to R G B A.
Image with_all_channels(Image image) {
    using Names = std::vector<std::string>;
    const Names all{"R", "G", "B", "A"};
    if (image.channels == all)
        return image;
    const auto index = [&](const char* name) {
        return std::find(image.channels.begin(), image.channels.end(), name) -
               image.channels.begin();
    };
    const std::ptrdiff_t none = std::ssize(image.channels);
    std::ptrdiff_t from[] = {index("R"), index("G"), index("B"), index("A")};
    if (const std::ptrdiff_t grey = index("Y"); grey != none)
        from[0] = from[1] = from[2] = grey;
    Image out(image.width, image.height, all);
    for (std::size_t i = 0; i < out.pixels.size() / 4; ++i)
        for (std::size_t c = 0; c < 4; ++c)
            out.pixels[4 * i + c] =
                from[c] == none ? 1.0F
                                : image.pixels[i * image.channels.size() + std::size_t(from[c])];
    return out;
}

void read_pixels(const std::string& path, const ImageOptions& options, Picture& picture) {
    picture.image = with_all_channels(read_image(path, options));
    picture.box = unit_box({double(picture.image.width), double(picture.image.height)});
}

void read_vectors(const std::string& path, int pixels, Picture& picture) {
    const std::string bytes = read_file(path, largest_drawing);
    try {
        Drawing drawing = read_drawing(bytes);
        const double scale = pixels / std::max(drawing.size.x, drawing.size.y);
        const auto side = [&](double length) {
            return std::max(1, static_cast<int>(std::lround(length * scale)));
        };
        picture.image =
            rasterised(drawing.markup, drawing.size, side(drawing.size.x), side(drawing.size.y));
        picture.box = unit_box(drawing.size);
        picture.drawing = std::move(drawing.markup);
    } catch (const Error& error) {
        const std::string message = path + ": " + error.diagnostics().front().message;
        throw error.fault() == Fault::resource ? Error::resource(message) : Error(message);
    }
}

} // namespace

Picture read_picture(const std::string& path, int pixels, const ImageOptions& options) {
    check_is_file(path); // before it is opened, which for a pipe takes until somebody writes
    Picture picture;
    picture.name = file_name(path);
    const bool drawing = is_drawing(path);
    if (drawing && !options.layer.empty())
        throw Error(
            fmt::format("{}: has no layer \"{}\"; only EXR has layers", path, options.layer));
    if (drawing)
        read_vectors(path, pixels, picture);
    else
        read_pixels(path, options, picture);
    return picture;
}

Picture read_picture_bytes(const std::string& name, std::string_view bytes) {
    const MemoryFile file(name, bytes); // readers of images read files
    try {
        Picture picture = read_picture(file.path());
        picture.name = name;
        return picture;
    } catch (const Error& error) {
        std::string message = error.diagnostics().front().message;
        if (message.starts_with(file.path()))
            message.replace(0, file.path().size(), name);
        throw error.fault() == Fault::resource ? Error::resource(message) : Error(message);
    }
}

} // namespace scree
