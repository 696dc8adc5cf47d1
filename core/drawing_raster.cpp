// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing_raster.h"

#include "core/display_encoding.h"
#include "core/error.h"

#include <librsvg/rsvg.h>

#include <array>
#include <cassert>
#include <memory>

namespace scree {

namespace {

struct Unref {
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Handle = std::unique_ptr<RsvgHandle, Unref>;

[[noreturn]] void fail(GError* error) {
    std::string reason = error != nullptr ? error->message : "unknown";
    if (error != nullptr)
        g_error_free(error);
    throw Error("cannot be drawn: " + reason);
}

// Loaded from memory without a base URL, so that librsvg cannot load other files.
Handle load(const std::string& markup) {
    GError* error = nullptr;
    Handle handle(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(markup.data()),
                                            markup.size(), &error));
    if (!handle)
        fail(error);
    rsvg_handle_set_dpi(handle.get(), 96);
    return handle;
}

const std::array<float, 256>& linear_steps() {
    static const auto table = [] {
        std::array<float, 256> out{};
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = linear_from_display(static_cast<float>(i) / 255);
        return out;
    }();
    return table;
}

// cairo's ARGB32 holds premultiplied display-encoded values.
Image linear_image(const unsigned char* data, int stride, int width, int height) {
    Image image(width, height, {"R", "G", "B", "A"});
    for (int y = 0; y < height; ++y) {
        const auto* row = reinterpret_cast<const std::uint32_t*>(data + std::ptrdiff_t{y} * stride);
        for (int x = 0; x < width; ++x) {
            const std::uint32_t alpha = row[x] >> 24;
            float* out = image.at(x, y);
            out[3] = static_cast<float>(alpha) / 255;
            for (int c = 0; c < 3 && alpha > 0; ++c) {
                const std::uint32_t value = (row[x] >> (16 - 8 * c)) & 0xff;
                out[c] = alpha == 255 ? linear_steps()[value]
                                      : out[3] * linear_from_display(static_cast<float>(value) /
                                                                     static_cast<float>(alpha));
            }
        }
    }
    return image;
}

} // namespace

Vec2 drawing_size(const std::string& markup) {
    const Handle handle = load(markup);
    Vec2 size(0.0);
    if (!rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &size.x, &size.y)) {
        gboolean has_box = FALSE;
        RsvgRectangle box{};
        rsvg_handle_get_intrinsic_dimensions(handle.get(), nullptr, nullptr, nullptr, nullptr,
                                             &has_box, &box);
        if (has_box)
            size = {box.width, box.height};
    }
    if (!(size.x > 0 && size.y > 0 && size.x < 1e9 && size.y < 1e9))
        throw Error("has no size: expected a width and height above 0, or a viewBox");
    return size;
}

Image rasterised(const std::string& markup, const Vec2& size, int width, int height) {
    assert(width > 0 && height > 0);
    const Handle handle = load(markup);
    const std::unique_ptr<cairo_surface_t, Unref> surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
        throw Error::resource("not enough memory to draw it");
    const std::unique_ptr<cairo_t, Unref> context(cairo_create(surface.get()));
    cairo_scale(context.get(), width / size.x, height / size.y);
    const RsvgRectangle viewport{0, 0, size.x, size.y};
    GError* error = nullptr;
    if (!rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error))
        fail(error);
    cairo_surface_flush(surface.get());
    return linear_image(cairo_image_surface_get_data(surface.get()),
                        cairo_image_surface_get_stride(surface.get()), width, height);
}

} // namespace scree
