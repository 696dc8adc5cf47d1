// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/chromaticities.h"
#include "core/error.h"
#include "core/file.h"
#include "core/image_layers.h"
#include "core/image_reading.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <mutex>

namespace scree {

namespace {

using Imath::Box2i;
using Names = std::vector<std::string>;

template <class Read>
auto with_exr(const std::string& path, const Read& read) {
    static std::once_flag once;
    std::call_once(once, [] { Imf::Header::setMaxImageSize(max_image_side, max_image_side); });
    try {
        Imf::MultiPartInputFile file(path.c_str());
        return read(file);
    } catch (const Error& error) {
        const Diagnostic& first = error.diagnostics().front();
        throw first.message.starts_with(path)
            ? error
            : Error(Diagnostic{{}, {}, path + ": " + first.message, first.hint});
    } catch (const std::bad_alloc&) {
        throw Error::resource(path + ": not enough memory to read it");
    } catch (const std::exception& failure) {
        throw Error(path + ": is not a valid EXR: " + failure.what());
    }
}

Names channel_names(const Imf::Header& header) {
    Names names;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
        names.emplace_back(c.name());
    return names;
}

Image empty_image(const std::string& path, const Box2i& window, Names channels) {
    const auto width = std::int64_t{window.max.x} - window.min.x + 1;
    const auto height = std::int64_t{window.max.y} - window.min.y + 1;
    check_image_size(path, width, height, channels.size());
    return {static_cast<int>(width), static_cast<int>(height), std::move(channels)};
}

/// Reads the channels `names` of the part's data window into those of an image.
Image read_channels(const std::string& path, Imf::MultiPartInputFile& file, int part,
                    const Names& names, Names channels) {
    const Imf::Header& header = file.header(part);
    if (header.hasType() && Imf::isDeepData(header.type()))
        throw Error("holds deep data, which is not read; flatten it");
    const Box2i& window = header.dataWindow();
    Image image = empty_image(path, window, std::move(channels));
    Imf::FrameBuffer frame;
    const std::size_t x_stride = names.size() * sizeof(float);
    const std::size_t y_stride = x_stride * std::size_t(image.width);
    for (std::size_t c = 0; c < names.size(); ++c) {
        const Imf::Channel& channel = header.channels()[names[c].c_str()];
        if (channel.xSampling != 1 || channel.ySampling != 1)
            throw Error(fmt::format("the channel {} holds one value for {} x {} pixels, which is "
                                    "read beside a luminance only (Y, RY, BY)",
                                    names[c], channel.xSampling, channel.ySampling));
        frame.insert(names[c],
                     Imf::Slice::Make(Imf::FLOAT, &image.pixels[c], window, x_stride, y_stride));
    }
    Imf::InputPart input(file, part);
    input.setFrameBuffer(frame);
    input.readPixels(window.min.y, window.max.y);
    return image;
}

/// Luminance and chroma, which OpenEXR turns into colours.
Image read_luminance_chroma(const std::string& path, const Imf::MultiPartInputFile& file,
                            const ImageLayer& layer) {
    if (file.parts() > 1)
        throw Error("holds luminance and chroma in one of several parts, which is not read; save "
                    "it as R, G and B");
    Imf::RgbaInputFile input(path.c_str(), layer.unnamed ? "" : layer.name);
    const Box2i window = input.dataWindow();
    Image image =
        empty_image(path, window,
                    layer.find("A") != nullptr ? Names{"R", "G", "B", "A"} : Names{"R", "G", "B"});
    std::vector<Imf::Rgba> pixels(std::size_t(image.width) * std::size_t(image.height));
    input.setFrameBuffer(Imf::ComputeBasePointer(pixels.data(), window), 1,
                         std::size_t(image.width));
    input.readPixels(window.min.y, window.max.y);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::array<float, 4> values{pixels[i].r, pixels[i].g, pixels[i].b, pixels[i].a};
        std::copy_n(values.begin(), image.channels.size(),
                    &image.pixels[i * image.channels.size()]);
    }
    return image;
}

/// What of the data window lies in the display window, black and transparent outside.
Image in_display_window(const std::string& path, Image image, const Imf::Header& header,
                        const Warn& warn) {
    const Box2i& data = header.dataWindow();
    const Box2i& display = header.displayWindow();
    if (data == display)
        return image;
    Image out = empty_image(path, display, image.channels);
    const Box2i both{{std::max(data.min.x, display.min.x), std::max(data.min.y, display.min.y)},
                     {std::min(data.max.x, display.max.x), std::min(data.max.y, display.max.y)}};
    if (both.isEmpty())
        warn(path + ": its data window lies outside its display window, so that it is black");
    for (int y = both.min.y; y <= both.max.y && !both.isEmpty(); ++y)
        std::copy_n(image.at(both.min.x - data.min.x, y - data.min.y),
                    std::size_t(both.max.x - both.min.x + 1) * image.channels.size(),
                    out.at(both.min.x - display.min.x, y - display.min.y));
    return out;
}

/// The channels that make a picture, or for data all that have a role, in the order R, G, B, A, Y.
Image read_layer(const std::string& path, Imf::MultiPartInputFile& file, const ImageLayer& layer,
                 Meaning meaning) {
    if (layer.find("RY") != nullptr || layer.find("BY") != nullptr)
        return read_luminance_chroma(path, file, layer);
    Names roles{"R", "G", "B", "A", "Y"};
    if (meaning == Meaning::color && layer.has_color())
        roles =
            layer.find("R") != nullptr && layer.find("G") != nullptr && layer.find("B") != nullptr
                ? Names{"R", "G", "B", "A"}
                : Names{"Y", "A"};
    Names names;
    Names channels;
    for (const std::string& role : roles)
        if (const ImageLayer::Channel* channel = layer.find(role)) {
            names.push_back(channel->name);
            channels.push_back(role);
        }
    if (names.empty()) // so that the caller can say what there is
        for (const ImageLayer::Channel& channel : layer.channels) {
            names.push_back(channel.name);
            channels.push_back(channel.role);
        }
    return read_channels(path, file, layer.part, names, std::move(channels));
}

/// Converts what the header says of the colours.
void to_rec709(Image& image, const Imf::Header& header) {
    if (Imf::hasEnvmap(header) && Imf::envmap(header) == Imf::ENVMAP_CUBE)
        throw Error("holds a cube map, which is not read; convert it to latitude and longitude");
    if (!Imf::hasChromaticities(header) || image.channels.size() < 3)
        return;
    const Imf::Chromaticities& of_file = Imf::chromaticities(header);
    const Chromaticities primaries{Vec2(of_file.red), Vec2(of_file.green), Vec2(of_file.blue),
                                   Vec2(of_file.white)};
    const auto same = [](const Vec2& a, const Vec2& b) { return (a - b).length() < 1e-4; };
    const Chromaticities own;
    if (!(same(primaries.red, own.red) && same(primaries.green, own.green) &&
          same(primaries.blue, own.blue) && same(primaries.white, own.white)))
        convert_primaries(image, rec709_from(primaries));
}

std::optional<PictureWindow> window_of(const Imf::Header& header) {
    const Box2i& data = header.dataWindow();
    const Box2i& display = header.displayWindow();
    if (data == display)
        return {};
    return PictureWindow{data.min.x - display.min.x, data.min.y - display.min.y,
                         display.max.x - display.min.x + 1, display.max.y - display.min.y + 1};
}

// Standard attributes, which are not ours.
bool is_standard_number(const std::string& name) {
    return name == "pixelAspectRatio" || name == "screenWindowCenter" ||
           name == "screenWindowWidth";
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

/// All channels of a part, without the part's name before theirs; R, G, B and A first, then the
/// others in the file's (alphabetical) order.
ImagePart read_part(const std::string& path, Imf::MultiPartInputFile& file, int index) {
    const Imf::Header& header = file.header(index);
    ImagePart part;
    part.name = header.hasName() ? header.name() : "";
    const std::string prefix = part.name + ".";
    Names names = channel_names(header);
    auto sorted = names.begin();
    for (const char* name : {"R", "G", "B", "A"}) {
        const auto found = std::find_if(sorted, names.end(), [&](const std::string& given) {
            return given == name || given == prefix + name;
        });
        if (found != names.end()) {
            std::rotate(sorted, found, found + 1);
            ++sorted;
        }
    }
    Names channels = names;
    for (std::string& channel : channels)
        if (channel.starts_with(prefix))
            channel.erase(0, prefix.size());
    part.image = read_channels(path, file, index, names, std::move(channels));
    part.full_float = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return header.channels()[name.c_str()].type != Imf::HALF;
    });
    return part;
}

} // namespace

Image read_exr_image(const std::string& path, Meaning meaning, const ImageOptions& options) {
    return with_exr(path, [&](Imf::MultiPartInputFile& file) {
        std::vector<ImageLayer> layers;
        for (int part = 0; part < file.parts(); ++part) {
            const Imf::Header& header = file.header(part);
            for (ImageLayer& layer :
                 layers_of_part(part, header.hasName() ? header.name() : "", channel_names(header)))
                layers.push_back(std::move(layer));
        }
        const ImageLayer& layer = chosen_layer(layers, options.layer, meaning);
        const Imf::Header& header = file.header(layer.part);
        Image image =
            in_display_window(path, read_layer(path, file, layer, meaning), header, options.warn);
        if (meaning == Meaning::color)
            to_rec709(image, header);
        warn_of_aspect(path, header.pixelAspectRatio(), options.warn);
        const auto* orientation = header.findTypedAttribute<Imf::IntAttribute>("Orientation");
        return upright(std::move(image), orientation == nullptr ? 1 : orientation->value());
    });
}

ExrFile read_exr(const std::string& path) {
    if (image_format(path) != ImageFormat::exr)
        throw Error(path + ": is not an EXR image");
    return with_exr(path, [&](Imf::MultiPartInputFile& file) {
        ExrFile result;
        for (int i = 0; i < file.parts(); ++i)
            result.parts.push_back(read_part(path, file, i));
        const Imf::Header& header = file.header(0);
        result.window = window_of(header);
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

} // namespace scree
