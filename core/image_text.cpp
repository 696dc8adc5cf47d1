// SPDX-License-Identifier: GPL-3.0-or-later
// Text by OpenImageIO, which rasterises it with FreeType.
#include "core/canvas.h"
#include "core/error.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <cmath>
#include <filesystem>

namespace scree {

namespace {

/// The font of Debian's package fonts-dejavu-core by its path, since OpenImageIO 2.5 does not look
/// into the folders of /usr/share/fonts; on other systems by its name.
const std::string& font() {
    static const std::string found = [] {
        const std::string path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
        return std::filesystem::exists(path) ? path : "DejaVuSans";
    }();
    return found;
}

} // namespace

TextMask text_mask(const std::string& text, double size) {
    const int pixels = std::max(1, static_cast<int>(std::lround(size)));
    TextMask mask;
    if (text.find_first_not_of(' ') == std::string::npos) {
        mask.image = Image(0, 0, {"A"});
        return mask;
    }
    const OIIO::ROI ink = OIIO::ImageBufAlgo::text_size(text, pixels, font());
    OIIO::ImageBuf buffer;
    bool drawn = ink.defined();
    if (drawn) {
        constexpr int border = 2; // text_size may be a pixel too small
        mask.left = ink.xbegin - border;
        mask.top = ink.ybegin - border;
        mask.image = Image(ink.width() + 2 * border, ink.height() + 2 * border, {"A"});
        buffer.reset(OIIO::ImageSpec(mask.image.width, mask.image.height, 1, OIIO::TypeFloat));
        drawn = OIIO::ImageBufAlgo::zero(buffer) &&
                OIIO::ImageBufAlgo::render_text(buffer, -mask.left, -mask.top, text, pixels, font(),
                                                {1.0F}) &&
                buffer.get_pixels(buffer.roi(), OIIO::TypeFloat, mask.image.pixels.data());
    }
    if (!drawn)
        throw Error::resource("cannot draw text with the font DejaVu Sans: is it installed "
                              "(fonts-dejavu-core), or named by OPENIMAGEIO_FONTS?");
    return mask;
}

} // namespace scree
