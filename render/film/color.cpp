// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/film/color.h"

#include "core/error.h"

#include <OpenColorIO/OpenColorIO.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace OCIO = OCIO_NAMESPACE;

namespace scree {

namespace {

// (1 - 2a) on the diagonal and a elsewhere keeps greys; its inverse is of the same form.
OCIO::TransformRcPtr mix_channels(double a) {
    const double b = 1 - 2 * a;
    const OCIO::MatrixTransformRcPtr matrix = OCIO::MatrixTransform::Create();
    const double rows[16] = {b, a, a, 0, a, b, a, 0, a, a, b, 0, 0, 0, 0, 1};
    matrix->setMatrix(rows);
    return matrix;
}

// One entry for every 16-bit float, so that shadows and highlights are equally precise.
OCIO::TransformRcPtr filmic_lut() {
    constexpr unsigned halves = 1U << 16;
    const OCIO::Lut1DTransformRcPtr lut = OCIO::Lut1DTransform::Create(halves, true);
    for (unsigned bits = 0; bits < halves; ++bits) {
        half h;
        h.setBits(static_cast<unsigned short>(bits));
        double shown = 0;
        if (h.isInfinity())
            shown = h.isNegative() ? 0 : 1;
        else if (!h.isNan())
            shown = filmic_curve(std::max(0.0, double(float(h))));
        const auto value = static_cast<float>(shown);
        lut->setValue(bits, value, value, value);
    }
    return lut;
}

OCIO::TransformRcPtr standard_transform() {
    const OCIO::ExponentWithLinearTransformRcPtr srgb = OCIO::ExponentWithLinearTransform::Create();
    srgb->setGamma({2.4, 2.4, 2.4, 1.0}); // IEC 61966-2-1
    srgb->setOffset({0.055, 0.055, 0.055, 0.0});
    srgb->setDirection(OCIO::TRANSFORM_DIR_INVERSE);
    return srgb;
}

OCIO::TransformRcPtr filmic_transform() {
    const OCIO::GroupTransformRcPtr group = OCIO::GroupTransform::Create();
    group->appendTransform(mix_channels(filmic_crosstalk));
    group->appendTransform(filmic_lut());
    group->appendTransform(mix_channels(-filmic_crosstalk / (1 - 3 * filmic_crosstalk)));
    group->appendTransform(standard_transform());
    return group;
}

constexpr const char* linear_name = "lin_rec709";

OCIO::ConstConfigRcPtr own_config() {
    const OCIO::ConfigRcPtr config = OCIO::Config::Create();
    config->setMajorVersion(2);
    const auto add_space = [&](const char* name, const OCIO::TransformRcPtr& from_linear) {
        const OCIO::ColorSpaceRcPtr space = OCIO::ColorSpace::Create();
        space->setName(name);
        space->setBitDepth(OCIO::BIT_DEPTH_F32);
        if (from_linear)
            space->setTransform(from_linear, OCIO::COLORSPACE_DIR_FROM_REFERENCE);
        config->addColorSpace(space);
    };
    add_space(linear_name, nullptr);
    add_space("srgb", standard_transform());
    add_space("filmic_srgb", filmic_transform());
    config->setRole(OCIO::ROLE_SCENE_LINEAR, linear_name);
    config->setRole(OCIO::ROLE_DEFAULT, linear_name);
    config->addDisplayView("sRGB", "filmic", "filmic_srgb", "");
    config->addDisplayView("sRGB", "standard", "srgb", "");
    config->setActiveDisplays("sRGB");
    config->addDisplayView("sRGB", "raw", linear_name, "");
    config->setActiveViews("filmic, standard, raw");
    config->validate();
    return config;
}

OCIO::ConstConfigRcPtr current_config() {
    const char* path = std::getenv("OCIO");
    if (path == nullptr || *path == '\0') {
        static const OCIO::ConstConfigRcPtr own = own_config();
        return own;
    }
    try {
        OCIO::ConstConfigRcPtr config = OCIO::Config::CreateFromFile(path);
        config->validate();
        return config;
    } catch (const OCIO::Exception& failure) {
        throw Error(std::string("$OCIO: ") + path +
                    ": cannot be used as a color configuration: " + failure.what());
    }
}

// Our light is linear Rec. 709; configurations call that by different names.
std::string source_space(const OCIO::Config& config) {
    for (const char* name :
         {linear_name, "Linear Rec.709 (sRGB)", "Utility - Linear - sRGB", "lin_srgb"})
        if (config.getColorSpace(name))
            return name;
    return OCIO::ROLE_SCENE_LINEAR;
}

std::vector<std::string> views_of(const OCIO::Config& config) {
    const char* display = config.getDefaultDisplay();
    std::vector<std::string> names;
    const std::string first = config.getDefaultView(display);
    names.push_back(first);
    for (int i = 0; i < config.getNumViews(display); ++i)
        if (config.getView(display, i) != first)
            names.emplace_back(config.getView(display, i));
    return names;
}

} // namespace

double filmic_curve(double x) {
    constexpr double maximum = 1;     // P
    constexpr double contrast = 1;    // a
    constexpr double start = 0.22;    // m: where the straight part begins
    constexpr double length = 0.4;    // l: of the straight part
    constexpr double toe_bend = 1.33; // c
    constexpr double black = 0;       // b
    constexpr double straight = (maximum - start) * length / contrast;
    constexpr double shoulder_x = start + straight;
    constexpr double shoulder_y = start + contrast * straight;
    constexpr double bend = contrast * maximum / (maximum - shoulder_y);
    if (x > shoulder_x)
        return maximum - (maximum - shoulder_y) * std::exp(-bend * (x - shoulder_x) / maximum);
    const double line = start + contrast * (x - start);
    const double t = std::clamp(x / start, 0.0, 1.0);
    const double toe_weight = 1 - t * t * (3 - 2 * t);
    const double toe = start * std::pow(std::max(0.0, x) / start, toe_bend) + black;
    return toe_weight > 0 ? toe * toe_weight + line * (1 - toe_weight) : line;
}

std::vector<std::string> view_names() { return views_of(*current_config()); }

Image to_display(const Image& beauty, const std::string& view, double exposure) {
    const OCIO::ConstConfigRcPtr config = current_config();
    const std::vector<std::string> names = views_of(*config);
    if (!view.empty() && std::find(names.begin(), names.end(), view) == names.end()) {
        std::string known;
        for (const std::string& name : names)
            known += (known.empty() ? "" : ", ") + name;
        throw Error::usage("unknown view '" + view + "'; there are: " + known,
                           did_you_mean(view, names));
    }
    Image shown(beauty.width, beauty.height, {"R", "G", "B"});
    const auto factor = static_cast<float>(std::exp2(exposure));
    const std::size_t channels = beauty.channels.size();
    const std::size_t step = channels >= 3 ? 1 : 0;
    for (std::size_t i = 0; i < shown.pixels.size() / 3; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const float v = beauty.pixels[i * channels + c * step] * factor;
            shown.pixels[3 * i + c] = std::isnan(v) ? 0.0F : v;
        }
    try {
        const OCIO::DisplayViewTransformRcPtr transform = OCIO::DisplayViewTransform::Create();
        const std::string source = source_space(*config);
        transform->setSrc(source.c_str());
        transform->setDisplay(config->getDefaultDisplay());
        transform->setView(view.empty() ? names.front().c_str() : view.c_str());
        const OCIO::ConstCPUProcessorRcPtr processor =
            config->getProcessor(transform)->getDefaultCPUProcessor();
        OCIO::PackedImageDesc pixels(shown.pixels.data(), shown.width, shown.height, 3);
        processor->apply(pixels);
    } catch (const OCIO::Exception& failure) {
        throw Error(std::string("color configuration: ") + failure.what());
    }
    return shown;
}

} // namespace scree
