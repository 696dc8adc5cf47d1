// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base64.h"
#include "core/display_encoding.h"
#include "core/drawing.h"
#include "formats/layout_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace scree {

namespace {

constexpr double mm_per_metre = 1000;

// Escapes text for XML content and attributes (XML 1.0, section 2.4) and removes control
// characters, which XML does not allow.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&' || c == '<' || c == '>' || c == '"')
            out += fmt::format("&#{};", static_cast<int>(c));
        else if (static_cast<unsigned char>(c) >= 0x20)
            out += c;
    }
    return out;
}

std::string path_data(const Region& region) {
    std::string data;
    for (const Ring& ring : region.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            data += fmt::format("{}{:.9g},{:.9g}", i == 0 ? "M" : " ", ring[i].x * mm_per_metre,
                                ring[i].y * mm_per_metre);
        data += "Z";
    }
    return data;
}

std::string hex_color(const Color& color) {
    const auto byte = [](float v) {
        return static_cast<int>(std::lround(255 * std::clamp(v, 0.0F, 1.0F)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(color.x), byte(color.y), byte(color.z));
}

// matrix(a, b, c, d, e, f) of SVG takes (x, y) to (a x + c y + e, b x + d y + f).
std::string svg_matrix(const WideMatrix& m, const Vec2& shift) {
    return fmt::format("matrix({:.12g} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g})", m[0][0], m[0][2],
                       m[2][0], m[2][2], (m[3][0] + shift.x) * mm_per_metre,
                       (m[3][2] + shift.y) * mm_per_metre);
}

// An SVG element of the picture, whose box is in millimetres: a drawing is embedded as it is,
// pixels as a PNG.
std::string picture_element(const Picture& picture, const Box2& box, const std::string& prefix,
                            const std::string& scope) {
    const Box2 place(box.min * mm_per_metre, box.max * mm_per_metre);
    if (!picture.drawing.empty())
        return embedded_drawing(picture.drawing, prefix, scope, place);
    return fmt::format("<image x=\"{:.9g}\" y=\"{:.9g}\" width=\"{:.9g}\" height=\"{:.9g}\" "
                       "preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64,{}\"/>",
                       place.min.x, place.min.y, place.size().x, place.size().y,
                       base64(png_bytes(display_image(picture.image))));
}

void write_prototype(std::string& out, const Prototype& prototype, const std::string& id,
                     bool margins) {
    auto to = std::back_inserter(out);
    const std::string name = escaped(prototype.name);
    if (prototype.picture)
        // Its origin may lie inside it, so it has no viewBox and must not be clipped.
        fmt::format_to(to,
                       "<symbol id=\"{0}\" overflow=\"visible\" style=\"overflow:visible\">"
                       "<title>{1}</title>\n{2}\n</symbol>\n",
                       id, name,
                       picture_element(*prototype.picture, prototype.picture->box, id + "-", id));
    else if (prototype.region)
        fmt::format_to(to,
                       "<path id=\"{}\" fill-rule=\"evenodd\" d=\"{}\">"
                       "<title>{}</title></path>\n",
                       id, path_data(seen_region(prototype)), name);
    if (margins && has_margin(prototype))
        fmt::format_to(to, "<path id=\"{}margin\" d=\"{}\"/>\n", id, path_data(*prototype.region));
}

void write_background(std::string& out, const Aggregate& aggregate, std::size_t number) {
    const std::string id = fmt::format("a{}background", number);
    fmt::format_to(std::back_inserter(out), "<g id=\"{}\">{}</g>\n", id,
                   picture_element(*aggregate.background, bounds(*aggregate.domain), id + "-", id));
}

// The exclusive regions, which hold shapes with their margins, as thin lines above them: a group
// of its own, to be hidden or deleted in a drawing program.
void write_margins(std::string& out, const Aggregate& aggregate, std::size_t number) {
    auto to = std::back_inserter(out);
    if (std::none_of(aggregate.prototypes.begin(), aggregate.prototypes.end(), has_margin))
        return;
    out += "<g class=\"margins\" fill=\"none\" stroke=\"#9a9aa0\" stroke-width=\"0.75\">\n";
    for (const Instance& instance : aggregate.instances)
        for (const Vec2& shift : picture_shifts(aggregate))
            if (has_margin(aggregate.prototypes[instance.prototype]) &&
                is_seen(aggregate, instance, shift))
                fmt::format_to(to,
                               "<use xlink:href=\"#a{}p{}margin\" transform=\"{}\" "
                               "vector-effect=\"non-scaling-stroke\"/>\n",
                               number, instance.prototype,
                               svg_matrix(instance.world_from_object, shift));
    out += "</g>\n";
}

void write_elements(std::string& out, const Aggregate& aggregate, std::size_t number,
                    const ElementColor& color) {
    auto to = std::back_inserter(out);
    for (const Instance& instance : aggregate.instances)
        for (const Vec2& shift : picture_shifts(aggregate)) {
            if (!is_seen(aggregate, instance, shift))
                continue;
            fmt::format_to(to, "<use xlink:href=\"#a{}p{}\" transform=\"{}\"", number,
                           instance.prototype, svg_matrix(instance.world_from_object, shift));
            if (aggregate.prototypes[instance.prototype].picture)
                out += "/>\n";
            else
                fmt::format_to(to, " fill=\"{}\"/>\n", hex_color(color(aggregate, instance)));
        }
}

void write_aggregate(std::string& out, const Aggregate& aggregate, std::size_t number,
                     const ElementColor& color, const LayoutLook& look) {
    auto to = std::back_inserter(out);
    fmt::format_to(to, "<g id=\"aggregate{}\">\n<title>{}</title>\n<defs>\n", number,
                   escaped(title(aggregate)));
    for (std::size_t p = 0; p < aggregate.prototypes.size(); ++p)
        write_prototype(out, aggregate.prototypes[p], fmt::format("a{}p{}", number, p),
                        look.margins);
    const bool clipped = is_tile(aggregate);
    if (clipped) {
        const Box2 box = bounds(*aggregate.domain);
        fmt::format_to(to,
                       "<clipPath id=\"a{}clip\"><path d=\"M{:.9g},{:.9g}H{:.9g}V{:.9g}H{:.9g}Z\"/>"
                       "</clipPath>\n",
                       number, box.min.x * mm_per_metre, box.min.y * mm_per_metre,
                       box.max.x * mm_per_metre, box.max.y * mm_per_metre,
                       box.min.x * mm_per_metre);
    }
    out += "</defs>\n";
    const std::string domain = aggregate.domain ? path_data(*aggregate.domain) : "";
    if (aggregate.domain && !aggregate.texture)
        fmt::format_to(to,
                       "<path class=\"ground\" fill=\"#f4f2f0\" fill-rule=\"evenodd\" d=\"{}\"/>\n",
                       domain);
    if (aggregate.background && aggregate.domain)
        write_background(out, aggregate, number);
    out += clipped ? fmt::format("<g clip-path=\"url(#a{}clip)\">\n", number) : "<g>\n";
    write_elements(out, aggregate, number, color);
    if (look.margins)
        write_margins(out, aggregate, number);
    out += "</g>\n";
    if (aggregate.domain && !is_tile(aggregate))
        fmt::format_to(to,
                       "<path class=\"domain\" fill=\"none\" stroke=\"#333338\" "
                       "stroke-width=\"1.5\" vector-effect=\"non-scaling-stroke\" d=\"{}\"/>\n",
                       domain);
    out += "</g>\n";
}

} // namespace

std::string layout_svg(std::span<const Aggregate> aggregates, const ElementColor& color,
                       const LayoutLook& look) {
    const Box2 box = picture_box(aggregates);
    const Vec2 low = box.min * mm_per_metre;
    const Vec2 size = box.size() * mm_per_metre;
    std::string out = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
        "version=\"1.1\" width=\"{2:.9g}mm\" height=\"{3:.9g}mm\" "
        "viewBox=\"{0:.9g} {1:.9g} {2:.9g} {3:.9g}\">\n",
        low.x, low.y, size.x, size.y);
    for (std::size_t i = 0; i < aggregates.size(); ++i)
        write_aggregate(out, aggregates[i], i, color, look);
    return out + "</svg>\n";
}

} // namespace scree
