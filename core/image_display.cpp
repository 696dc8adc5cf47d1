// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/file.h"
#include "core/image_reading.h"
#include "core/image_tags.h"
#include "core/muted_stderr.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <mutex>
#include <optional>

namespace scree {

namespace {

constexpr std::uint64_t largest_file = std::uint64_t{2} << 30;
constexpr int max_image_megabytes = 2048;

std::vector<std::string> channel_names(int count) {
    static const std::vector<std::string> names[] = {
        {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    return names[count - 1];
}

/// The stored values, not premultiplied.
Image decoded(const std::string& path, const char* format, const std::string& bytes,
              const Warn& warn) {
    static std::once_flag once;
    std::call_once(once, [] {
        OIIO::attribute("limits:channels", 4);
        OIIO::attribute("limits:imagesize_MB", max_image_megabytes);
    });
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const auto input = OIIO::ImageInput::create(format);
    if (!input)
        throw Error(path + ": this build cannot read " + format + ": " + OIIO::geterror());
    const auto failure = [&] {
        const std::string reason = input->geterror();
        return Error(path + ": is not a valid image" + (reason.empty() ? "" : ": " + reason));
    };
    // libpng prints its errors before OpenImageIO tells them.
    std::optional<MutedStderr> muted(std::in_place);
    OIIO::ImageSpec spec;
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1); // curves apply to unpremultiplied values
    if (!input->set_ioproxy(&memory) || !input->open(std::string("memory.") + format, spec, wish))
        throw failure();
    check_image_size(path, spec.width, spec.height, static_cast<std::size_t>(spec.nchannels));
    if (spec.nchannels > 4)
        throw Error(path + ": has more than 4 channels");
    Image image(spec.width, spec.height, channel_names(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, image.pixels.data()))
        throw failure();
    input->close();
    muted.reset();
    warn_of_aspect(path, spec.get_float_attribute("PixelAspectRatio", 1), warn);
    return image;
}

} // namespace

Image read_png_or_jpeg(const std::string& path, ImageFormat format, Meaning meaning,
                       const ImageOptions& options) {
    const bool png = format == ImageFormat::png;
    const Warn warn = [&](const std::string& message) { options.warn(path + ": " + message); };
    try {
        const std::string file = read_file(path, largest_file);
        const TaggedImage tagged = png ? take_apart_png(file) : take_apart_jpeg(file);
        if (tagged.components == 4)
            throw Error("is of CMYK, which is not read; convert it to RGB");
        Image image = decoded(path, png ? "png" : "jpeg", tagged.bytes, options.warn);
        if (meaning == Meaning::color)
            decode_colors(image, encoding_of(tagged, warn));
        return upright(std::move(image), tagged.exif.orientation);
    } catch (const Error& error) {
        const std::string& message = error.diagnostics().front().message;
        throw error.fault() != Fault::input || message.starts_with(path)
            ? error
            : Error(path + ": " + message);
    }
}

} // namespace scree
