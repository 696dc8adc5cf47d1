// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image.h"

#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace scree {

namespace {

// OpenEXR's own streams report no error on closing, and the destructors of its files swallow errors
// of the last writes; this stream remembers them.
class CheckedStream final : public Imf::OStream {
  public:
    /// Errors name the path that the file will have.
    CheckedStream(const std::string& temporary, const std::string& path)
        : OStream(path.c_str()), file_(std::fopen(temporary.c_str(), "wb")) {
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

Imath::Box2i data_window(const Image& image, const PictureWindow& window) {
    return {{window.x, window.y}, {window.x + image.width - 1, window.y + image.height - 1}};
}

// Of the first part R, G, B: what a program shows that knows nothing of parts. Of others albedo.R:
// Blender and others go by the channels' names alone.
std::vector<std::string> channels_in_file(const ImagePart& part, std::size_t index) {
    std::vector<std::string> names = part.image.channels;
    if (index > 0)
        for (std::string& name : names)
            name.insert(0, part.name + ".");
    return names;
}

Imf::Header header_of(const ImagePart& part, std::size_t index, const PictureWindow& window,
                      const Metadata& metadata, const HeaderNumbers& numbers) {
    Imf::Header header(Imath::Box2i({0, 0}, {window.whole_width - 1, window.whole_height - 1}),
                       data_window(part.image, window));
    header.setName(part.name);
    header.setType(Imf::SCANLINEIMAGE);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const std::string& channel : channels_in_file(part, index))
        header.channels().insert(channel, Imf::Channel(part.full_float ? Imf::FLOAT : Imf::HALF));
    for (const auto& [name, value] : metadata)
        header.insert(name, Imf::StringAttribute(value));
    for (const auto& [name, value] : numbers)
        insert_numbers(header, name, value);
    return header;
}

void write_part(Imf::MultiPartOutputFile& file, std::size_t index, const ImagePart& part,
                const Imath::Box2i& window) {
    const Image& image = part.image;
    const std::size_t channels = image.channels.size();
    std::vector<half> halves;
    if (!part.full_float) {
        halves.resize(image.pixels.size());
        std::transform(image.pixels.begin(), image.pixels.end(), halves.begin(), [](float v) {
            return half(std::clamp(v, -float(HALF_MAX), float(HALF_MAX))); // NaN stays NaN
        });
    }
    const std::size_t size = part.full_float ? sizeof(float) : sizeof(half);
    const std::vector<std::string> names = channels_in_file(part, index);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < channels; ++c) {
        const void* first = part.full_float ? static_cast<const void*>(&image.pixels[c])
                                            : static_cast<const void*>(&halves[c]);
        frame.insert(names[c],
                     Imf::Slice::Make(part.full_float ? Imf::FLOAT : Imf::HALF, first, window,
                                      size * channels, size * channels * std::size_t(image.width)));
    }
    Imf::OutputPart output(file, static_cast<int>(index));
    output.setFrameBuffer(frame);
    output.writePixels(image.height);
}

} // namespace

void write_exr(const std::string& path, std::span<const ImagePart> parts, const Metadata& metadata,
               const HeaderNumbers& numbers, const std::optional<PictureWindow>& cropped) {
    assert(!parts.empty());
    const Image& first = parts.front().image;
    const PictureWindow window = cropped.value_or(PictureWindow{0, 0, first.width, first.height});
    write_atomically(path, [&](const std::string& temporary) {
        std::vector<Imf::Header> headers;
        for (std::size_t i = 0; i < parts.size(); ++i)
            headers.push_back(header_of(parts[i], i, window, metadata, numbers));
        try {
            Imf::setGlobalThreadCount(thread_count());
            CheckedStream stream(temporary, path);
            {
                Imf::MultiPartOutputFile file(stream, headers.data(),
                                              static_cast<int>(headers.size()));
                for (std::size_t i = 0; i < parts.size(); ++i)
                    write_part(file, i, parts[i], data_window(parts[i].image, window));
            }
            stream.finish();
        } catch (const Error&) {
            throw;
        } catch (const std::exception& failure) {
            throw Error::resource("cannot write " + path + ": " + failure.what());
        }
    });
}

} // namespace scree
