// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image.h"

#include "core/display_encoding.h"
#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <mutex>

namespace scree {

namespace {

// 16384 x 8192 pixels of 4 float channels. A larger image in a scene is a mistake or an attack (a
// file of 300 bytes can claim any size).
constexpr std::uint64_t max_image_bytes = std::uint64_t{2} << 30;
constexpr int max_side = 1 << 16;

enum class Format { png, jpeg, exr };

// By content, since an extension may be wrong and OpenImageIO's other readers are not safe against
// malicious files.
Format format_of(const std::string& path) {
    std::array<unsigned char, 8> magic{};
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw Error(path + ": cannot be read: " + std::strerror(errno));
    in.read(reinterpret_cast<char*>(magic.data()), magic.size());
    const auto begins = [&](std::initializer_list<unsigned char> bytes) {
        return std::equal(bytes.begin(), bytes.end(), magic.begin());
    };
    if (begins({0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a}))
        return Format::png;
    if (begins({0xff, 0xd8, 0xff}))
        return Format::jpeg;
    if (begins({0x76, 0x2f, 0x31, 0x01}))
        return Format::exr;
    throw Error(path + ": is not a PNG, JPEG or EXR image");
}

void check_size(const std::string& path, std::int64_t width, std::int64_t height,
                std::size_t channels) {
    if (width < 1 || height < 1 || channels < 1)
        throw Error(path + ": is an empty image");
    if (width > max_side || height > max_side ||
        std::uint64_t(width) * std::uint64_t(height) * channels * sizeof(float) > max_image_bytes)
        throw Error(path + ": is too large: " + std::to_string(width) + " x " +
                    std::to_string(height) + " with " + std::to_string(channels) + " channels");
}

std::vector<std::string> channel_names(int count) {
    static const std::vector<std::string> names[] = {
        {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    return names[count - 1];
}

Image read_display_image(const std::string& path, const char* format, bool to_linear) {
    static std::once_flag once;
    std::call_once(once, [] {
        OIIO::attribute("limits:channels", 4);
        OIIO::attribute("limits:imagesize_MB", static_cast<int>(max_image_bytes >> 20));
    });
    const auto input = OIIO::ImageInput::create(format);
    if (!input)
        throw Error(path + ": this build cannot read " + format + ": " + OIIO::geterror());
    const auto failure = [&] {
        const std::string reason = input->geterror();
        return Error(path + ": is not a valid image" + (reason.empty() ? "" : ": " + reason));
    };
    OIIO::ImageSpec spec;
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1); // the sRGB curve applies to unpremultiplied values
    if (!input->open(path, spec, wish))
        throw failure();
    check_size(path, spec.width, spec.height, static_cast<std::size_t>(spec.nchannels));
    if (spec.nchannels > 4)
        throw Error(path + ": has more than 4 channels");
    Image image(spec.width, spec.height, channel_names(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, image.pixels.data()))
        throw failure();
    input->close();
    if (!to_linear)
        return image;
    const int colors = spec.nchannels <= 2 ? 1 : 3;
    for (std::size_t i = 0; i < image.pixels.size(); i += std::size_t(spec.nchannels)) {
        const float alpha = spec.nchannels > colors ? image.pixels[i + std::size_t(colors)] : 1.0F;
        for (std::size_t c = i; c < i + std::size_t(colors); ++c)
            image.pixels[c] = alpha * linear_from_display(image.pixels[c]);
    }
    return image;
}

// R, G, B, A first, then the others in the file's (alphabetical) order.
std::vector<std::string> ordered_channels(const Imf::ChannelList& list) {
    std::vector<std::string> names;
    for (const char* name : {"R", "G", "B", "A"})
        if (list.findChannel(name) != nullptr)
            names.emplace_back(name);
    for (auto channel = list.begin(); channel != list.end(); ++channel)
        if (std::find(names.begin(), names.end(), channel.name()) == names.end())
            names.emplace_back(channel.name());
    return names;
}

Imf::FrameBuffer frame_buffer(Image& image, const Imath::Box2i& window) {
    Imf::FrameBuffer frame;
    const std::size_t x_stride = image.channels.size() * sizeof(float);
    const std::size_t y_stride = x_stride * std::size_t(image.width);
    for (std::size_t c = 0; c < image.channels.size(); ++c)
        frame.insert(image.channels[c],
                     Imf::Slice::Make(Imf::FLOAT, &image.pixels[c], window, x_stride, y_stride));
    return frame;
}

ImagePart read_part(const std::string& path, Imf::MultiPartInputFile& file, int index) {
    const Imf::Header& header = file.header(index);
    if (header.hasType() && Imf::isDeepData(header.type()))
        throw Error(path + ": holds deep data");
    ImagePart part;
    part.name = header.hasName() ? header.name() : "";
    part.full_float = false;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
            throw Error(path + ": holds subsampled channels");
        part.full_float = part.full_float || c.channel().type != Imf::HALF;
    }
    const Imath::Box2i& window = header.dataWindow();
    const auto width = std::int64_t{window.max.x} - window.min.x + 1;
    const auto height = std::int64_t{window.max.y} - window.min.y + 1;
    std::vector<std::string> names = ordered_channels(header.channels());
    check_size(path, width, height, names.size());
    part.image = Image(static_cast<int>(width), static_cast<int>(height), std::move(names));
    Imf::InputPart input(file, index);
    input.setFrameBuffer(frame_buffer(part.image, window));
    input.readPixels(window.min.y, window.max.y);
    return part;
}

template <class Read>
auto with_exr(const std::string& path, const Read& read) {
    static std::once_flag once;
    std::call_once(once, [] { Imf::Header::setMaxImageSize(max_side, max_side); });
    try {
        Imf::MultiPartInputFile file(path.c_str());
        return read(file);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error::resource(path + ": not enough memory to read it");
    } catch (const std::exception& failure) {
        throw Error(path + ": is not a valid EXR: " + failure.what());
    }
}

// OpenEXR's own streams report no error on closing, and the destructors of its files swallow errors
// of the last writes; this stream remembers them.
class CheckedStream final : public Imf::OStream {
  public:
    explicit CheckedStream(const std::string& path)
        : OStream(path.c_str()), file_(std::fopen(path.c_str(), "wb")) {
        if (file_ == nullptr)
            fail();
    }
    CheckedStream(const CheckedStream&) = delete;
    CheckedStream& operator=(const CheckedStream&) = delete;
    ~CheckedStream() override {
        if (file_ != nullptr)
            std::fclose(file_);
    }

    void write(const char bytes[], int count) override {
        if (std::fwrite(bytes, 1, static_cast<std::size_t>(count), file_) !=
            static_cast<std::size_t>(count))
            fail();
    }
    uint64_t tellp() override { return static_cast<uint64_t>(ftello(file_)); }
    void seekp(uint64_t position) override {
        if (fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0)
            fail();
    }

    /// Throws if anything failed since the stream was opened.
    void finish() {
        if (std::fclose(std::exchange(file_, nullptr)) != 0 && error_ == 0)
            error_ = errno;
        if (error_ != 0)
            throw Error::resource(std::string("cannot write ") + fileName() + ": " +
                                  std::strerror(error_));
    }

  private:
    [[noreturn]] void fail() {
        error_ = errno != 0 ? errno : EIO;
        throw Error::resource(std::string("cannot write ") + fileName() + ": " +
                              std::strerror(error_));
    }

    std::FILE* file_;
    int error_ = 0;
};

void insert_numbers(Imf::Header& header, const std::string& name, const std::vector<float>& v) {
    assert(!v.empty() && v.size() <= 3);
    if (v.size() == 1)
        header.insert(name, Imf::FloatAttribute(v[0]));
    else if (v.size() == 2)
        header.insert(name, Imf::V2fAttribute({v[0], v[1]}));
    else
        header.insert(name, Imf::V3fAttribute({v[0], v[1], v[2]}));
}

std::vector<float> numbers_of(const Imf::Attribute& attribute) {
    if (const auto* one = dynamic_cast<const Imf::FloatAttribute*>(&attribute))
        return {one->value()};
    if (const auto* two = dynamic_cast<const Imf::V2fAttribute*>(&attribute))
        return {two->value().x, two->value().y};
    if (const auto* three = dynamic_cast<const Imf::V3fAttribute*>(&attribute))
        return {three->value().x, three->value().y, three->value().z};
    return {};
}

// Standard attributes, which are not ours.
bool is_standard_number(const std::string& name) {
    return name == "pixelAspectRatio" || name == "screenWindowCenter" ||
           name == "screenWindowWidth";
}

Imf::Header header_of(const ImagePart& part, const Metadata& metadata,
                      const HeaderNumbers& numbers) {
    Imf::Header header(part.image.width, part.image.height);
    header.setName(part.name);
    header.setType(Imf::SCANLINEIMAGE);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const std::string& channel : part.image.channels)
        header.channels().insert(channel, Imf::Channel(part.full_float ? Imf::FLOAT : Imf::HALF));
    for (const auto& [name, value] : metadata)
        header.insert(name, Imf::StringAttribute(value));
    for (const auto& [name, value] : numbers)
        insert_numbers(header, name, value);
    return header;
}

void write_part(Imf::MultiPartOutputFile& file, int index, const ImagePart& part) {
    const Image& image = part.image;
    const std::size_t channels = image.channels.size();
    const Imath::Box2i window({0, 0}, {image.width - 1, image.height - 1});
    std::vector<half> halves;
    if (!part.full_float) {
        halves.resize(image.pixels.size());
        std::transform(image.pixels.begin(), image.pixels.end(), halves.begin(), [](float v) {
            return half(std::clamp(v, -float(HALF_MAX), float(HALF_MAX))); // NaN stays NaN
        });
    }
    const std::size_t size = part.full_float ? sizeof(float) : sizeof(half);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < channels; ++c) {
        const void* first = part.full_float ? static_cast<const void*>(&image.pixels[c])
                                            : static_cast<const void*>(&halves[c]);
        frame.insert(image.channels[c],
                     Imf::Slice::Make(part.full_float ? Imf::FLOAT : Imf::HALF, first, window,
                                      size * channels, size * channels * std::size_t(image.width)));
    }
    Imf::OutputPart output(file, index);
    output.setFrameBuffer(frame);
    output.writePixels(image.height);
}

// 8 x 8 ordered dither (Bayer 1973). The thresholds lie in (0, 1), so values that are exact 8-bit
// steps stay unchanged.
float dither(int x, int y) {
    int rank = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int a = ((x ^ y) >> bit) & 1;
        const int b = (y >> bit) & 1;
        rank |= ((a << 1) | b) << (2 * (2 - bit));
    }
    return (static_cast<float>(rank) + 0.5F) / 64.0F;
}

Image read_any_image(const std::string& path, bool to_linear) {
    const Format format = format_of(path);
    if (format != Format::exr)
        return read_display_image(path, format == Format::png ? "png" : "jpeg", to_linear);
    ImagePart part =
        with_exr(path, [&](Imf::MultiPartInputFile& file) { return read_part(path, file, 0); });
    if (part.image.channels.size() > 4)
        throw Error(path + ": has more than 4 channels in its first part");
    return std::move(part.image);
}

} // namespace

Image read_image(const std::string& path) { return read_any_image(path, true); }

Image read_data_image(const std::string& path) { return read_any_image(path, false); }

ExrFile read_exr(const std::string& path) {
    if (format_of(path) != Format::exr)
        throw Error(path + ": is not an EXR image");
    return with_exr(path, [&](Imf::MultiPartInputFile& file) {
        ExrFile result;
        for (int i = 0; i < file.parts(); ++i)
            result.parts.push_back(read_part(path, file, i));
        const Imf::Header& header = file.header(0);
        for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
            const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
            const std::string name = attribute.name();
            if (text != nullptr && name != "name" && name != "type" && name != "view")
                result.metadata.emplace_back(name, text->value());
            std::vector<float> numbers = numbers_of(attribute.attribute());
            if (!numbers.empty() && !is_standard_number(name))
                result.numbers.emplace_back(name, std::move(numbers));
        }
        return result;
    });
}

void write_exr(const std::string& path, std::span<const ImagePart> parts, const Metadata& metadata,
               const HeaderNumbers& numbers) {
    assert(!parts.empty());
    write_atomically(path, [&](const std::string& temporary) {
        std::vector<Imf::Header> headers;
        for (const ImagePart& part : parts)
            headers.push_back(header_of(part, metadata, numbers));
        try {
            Imf::setGlobalThreadCount(thread_count());
            CheckedStream stream(temporary);
            {
                Imf::MultiPartOutputFile file(stream, headers.data(),
                                              static_cast<int>(headers.size()));
                for (std::size_t i = 0; i < parts.size(); ++i)
                    write_part(file, static_cast<int>(i), parts[i]);
            }
            stream.finish();
        } catch (const Error&) {
            throw;
        } catch (const std::exception& failure) {
            throw Error::resource("cannot write " + path + ": " + failure.what());
        }
    });
}

std::string png_bytes(const Image& image, const Metadata& metadata) {
    const int channels = static_cast<int>(image.channels.size());
    std::vector<unsigned char> steps(image.pixels.size());
    std::size_t i = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < channels; ++c, ++i) {
                const float v = std::clamp(image.pixels[i], 0.0F, 1.0F); // NaN stays NaN
                const float step = std::isnan(v) ? 0.0F : v * 255.0F + dither(x, y);
                steps[i] = static_cast<unsigned char>(std::min(step, 255.0F));
            }
    OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    for (const auto& [name, value] : metadata)
        spec.attribute(name, value);
    // Written to memory first: OpenImageIO's PNG writer reports success on a full disk; write_file
    // reports the failure.
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("memory.png", &memory);
    if (!output || !output->open("memory.png", spec) ||
        !output->write_image(OIIO::TypeUInt8, steps.data()) || !output->close())
        throw Error::resource("cannot make a PNG: " +
                              (output ? output->geterror() : OIIO::geterror()));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void write_png(const std::string& path, const Image& image, const Metadata& metadata) {
    write_file(path, png_bytes(image, metadata));
}

} // namespace scree
