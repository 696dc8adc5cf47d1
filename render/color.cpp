// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/color.h"

#include "core/error.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace scree {

namespace OCIO = OCIO_NAMESPACE;

namespace {

constexpr const char* scene_linear = "linear Rec. 709";

OCIO::TransformRcPtr srgb_encoding() { // IEC 61966-2-1
    const OCIO::ExponentWithLinearTransformRcPtr out = OCIO::ExponentWithLinearTransform::Create();
    const double gamma[4] = {2.4, 2.4, 2.4, 1};
    const double offset[4] = {0.055, 0.055, 0.055, 0};
    out->setGamma(gamma);
    out->setOffset(offset);
    out->setDirection(OCIO::TRANSFORM_DIR_INVERSE);
    return out;
}

// AgX's tone curve over its log range, as the polynomial that Wrensch (2023, "Minimal AgX
// implementation") fitted to Sobotka's sigmoid.
double agx_curve(double x) {
    const double y =
        (((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x - 0.00232;
    return std::clamp(y, 0.0, 1.0);
}

OCIO::MatrixTransformRcPtr agx_inset() { // the same source; rows of a matrix for column vectors
    const double rows[16] = {0.842479062253094,
                             0.0784335999999992,
                             0.0792237451477643,
                             0, //
                             0.0423282422610123,
                             0.878468636469772,
                             0.0791661274605434,
                             0, //
                             0.0423756549057051,
                             0.0784336,
                             0.879142973793104,
                             0, //
                             0,
                             0,
                             0,
                             1};
    const OCIO::MatrixTransformRcPtr out = OCIO::MatrixTransform::Create();
    out->setMatrix(rows);
    return out;
}

OCIO::TransformRcPtr filmic_encoding() {
    // Range of AgX: 10 stops below and 6.5 above middle grey.
    const float stops[2] = {-12.47393F, 4.026069F};
    const OCIO::AllocationTransformRcPtr shaper = OCIO::AllocationTransform::Create();
    shaper->setAllocation(OCIO::ALLOCATION_LG2);
    shaper->setVars(2, stops);

    constexpr unsigned long entries = 4096;
    const OCIO::Lut1DTransformRcPtr curve = OCIO::Lut1DTransform::Create(entries, false);
    for (unsigned long i = 0; i < entries; ++i) {
        const auto y = static_cast<float>(agx_curve(double(i) / (entries - 1)));
        curve->setValue(i, y, y, y);
    }

    // Between the source's default look (1, 1) and its "punchy" one (1.35, 1.4).
    const OCIO::CDLTransformRcPtr look = OCIO::CDLTransform::Create();
    const double power[3] = {1.2, 1.2, 1.2};
    look->setPower(power);
    look->setSat(1.25);

    const OCIO::MatrixTransformRcPtr outset = agx_inset();
    outset->setDirection(OCIO::TRANSFORM_DIR_INVERSE);

    const OCIO::GroupTransformRcPtr group = OCIO::GroupTransform::Create();
    group->appendTransform(agx_inset());
    group->appendTransform(shaper);
    group->appendTransform(curve);
    group->appendTransform(look);
    group->appendTransform(outset);
    return group;
}

void add_space(OCIO::Config& config, const char* name, const OCIO::TransformRcPtr& from_scene) {
    const OCIO::ColorSpaceRcPtr space = OCIO::ColorSpace::Create();
    space->setName(name);
    if (from_scene)
        space->setTransform(from_scene, OCIO::COLORSPACE_DIR_FROM_REFERENCE);
    config.addColorSpace(space);
}

OCIO::ConstConfigRcPtr built_in_config() {
    const OCIO::ConfigRcPtr config = OCIO::Config::Create();
    config->setMajorVersion(2);
    add_space(*config, scene_linear, nullptr);
    add_space(*config, "sRGB", srgb_encoding());
    add_space(*config, "AgX", filmic_encoding());
    config->setRole(OCIO::ROLE_SCENE_LINEAR, scene_linear);
    config->setRole(OCIO::ROLE_DEFAULT, scene_linear);
    config->addDisplayView("sRGB", "filmic", "AgX", "");
    config->addDisplayView("sRGB", "standard", "sRGB", "");
    config->setActiveDisplays("sRGB");
    config->setActiveViews("filmic, standard");
    config->validate();
    return config;
}

OCIO::ConstConfigRcPtr load_config() {
    const char* path = std::getenv("OCIO");
    if (path == nullptr || *path == '\0')
        return built_in_config();
    try {
        return OCIO::Config::CreateFromFile(path);
    } catch (const OCIO::Exception& problem) {
        throw Error(std::string("$OCIO: ") + path + ": cannot be read: " + problem.what());
    }
}

const OCIO::ConstConfigRcPtr& config_in_use() {
    static const OCIO::ConstConfigRcPtr config = load_config();
    return config;
}

std::vector<std::string> views_of(const OCIO::Config& config) {
    const char* display = config.getDefaultDisplay();
    std::vector<std::string> names{config.getDefaultView(display)};
    for (int i = 0; i < config.getNumViews(display); ++i)
        if (names.front() != config.getView(display, i))
            names.emplace_back(config.getView(display, i));
    return names;
}

OCIO::ConstCPUProcessorRcPtr processor_for(const OCIO::Config& config, const std::string& view,
                                           float exposure) {
    const OCIO::MatrixTransformRcPtr gain = OCIO::MatrixTransform::Create();
    const double stops = std::exp2(double(exposure));
    const double scale[4] = {stops, stops, stops, 1};
    double matrix[16];
    double offset[4];
    OCIO::MatrixTransform::Scale(matrix, offset, scale);
    gain->setMatrix(matrix);

    const OCIO::DisplayViewTransformRcPtr to_view = OCIO::DisplayViewTransform::Create();
    to_view->setSrc(OCIO::ROLE_SCENE_LINEAR);
    to_view->setDisplay(config.getDefaultDisplay());
    to_view->setView(view.c_str());

    const OCIO::GroupTransformRcPtr group = OCIO::GroupTransform::Create();
    group->appendTransform(gain);
    group->appendTransform(to_view);
    return config.getProcessor(group)->getDefaultCPUProcessor();
}

} // namespace

std::vector<std::string> view_names() { return views_of(*config_in_use()); }

Image to_display(const Image& beauty, const std::string& view, float exposure) {
    const OCIO::ConstConfigRcPtr& config = config_in_use();
    const std::vector<std::string> views = views_of(*config);
    const std::string chosen = view.empty() ? views.front() : view;
    if (std::find(views.begin(), views.end(), chosen) == views.end()) {
        std::string known;
        for (const std::string& name : views)
            known += (known.empty() ? "" : ", ") + name;
        throw Error::usage("there is no view " + chosen + "; there are " + known,
                           did_you_mean(chosen, views));
    }
    // OpenColorIO works on three or four interleaved channels; grey becomes three equal ones.
    const std::size_t channels = beauty.channels.size() >= 4 ? 4 : 3;
    Image out(beauty.width, beauty.height,
              channels == 4 ? std::vector<std::string>{"R", "G", "B", "A"}
                            : std::vector<std::string>{"R", "G", "B"});
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (std::size_t c = 0; c < channels; ++c)
                out.at(x, y)[c] = beauty.at(x, y)[std::min(c, beauty.channels.size() - 1)];
    try {
        OCIO::PackedImageDesc pixels(out.pixels.data(), out.width, out.height, long(channels));
        processor_for(*config, chosen, exposure)->apply(pixels);
    } catch (const OCIO::Exception& problem) {
        throw Error("view " + chosen + ": " + problem.what());
    }
    for (float& value : out.pixels)
        value = std::clamp(value, 0.0F, 1.0F);
    return out;
}

} // namespace scree
