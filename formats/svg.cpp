// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math.h"
#include "formats/layout_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace scree {

namespace {

constexpr double mm_per_metre = 1000;

// What may stand in text and attributes (XML 1.0, section 2.4); control characters may not at all.
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
std::string svg_matrix(const Matrix& m, const Vec2& shift) {
    return fmt::format("matrix({:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g})", m[0][0], m[0][2],
                       m[2][0], m[2][2], (double(m[3][0]) + shift.x) * mm_per_metre,
                       (double(m[3][2]) + shift.y) * mm_per_metre);
}

// Whether a copy on a torus reaches into the domain, judged by its bounding circle.
bool is_seen(const Aggregate& aggregate, const Instance& instance, const Vec2& shift) {
    if (!aggregate.torus)
        return true;
    const Box2 box = bounds(*aggregate.prototypes[instance.prototype].region);
    const Matrix& m = instance.world_from_object;
    const double scale = std::max(std::hypot(m[0][0], m[0][2]), std::hypot(m[2][0], m[2][2]));
    double reach = 0; // from the origin of the prototype
    for (const Vec2& corner :
         {box.min, box.max, Vec2(box.min.x, box.max.y), Vec2(box.max.x, box.min.y)})
        reach = std::max(reach, corner.length() * scale);
    Box2 domain = bounds(*aggregate.domain);
    domain.min -= Vec2(reach, reach);
    domain.max += Vec2(reach, reach);
    return domain.intersects(Vec2(double(m[3][0]), double(m[3][2])) + shift);
}

void write_aggregate(std::string& out, const Aggregate& aggregate, std::size_t number,
                     const ElementColor& color) {
    auto to = std::back_inserter(out);
    fmt::format_to(to, "<g id=\"aggregate{}\">\n<title>{}</title>\n<defs>\n", number,
                   escaped(aggregate.generator));
    for (std::size_t p = 0; p < aggregate.prototypes.size(); ++p) {
        const Prototype& prototype = aggregate.prototypes[p];
        if (prototype.region)
            fmt::format_to(to,
                           "<path id=\"a{}p{}\" fill-rule=\"evenodd\" d=\"{}\">"
                           "<title>{}</title></path>\n",
                           number, p, path_data(*prototype.region), escaped(prototype.name));
    }
    const bool clipped = aggregate.torus && aggregate.domain;
    if (clipped)
        fmt::format_to(to, "<clipPath id=\"a{}clip\"><path d=\"{}\"/></clipPath>\n", number,
                       path_data(*aggregate.domain));
    out += "</defs>\n";
    const std::string domain = aggregate.domain ? path_data(*aggregate.domain) : "";
    if (aggregate.domain)
        fmt::format_to(to,
                       "<path class=\"ground\" fill=\"#f4f2f0\" fill-rule=\"evenodd\" d=\"{}\"/>\n",
                       domain);
    out += clipped ? fmt::format("<g clip-path=\"url(#a{}clip)\">\n", number) : "<g>\n";
    for (const Vec2& shift : picture_shifts(aggregate))
        for (const Instance& instance : aggregate.instances)
            if (aggregate.prototypes[instance.prototype].region &&
                is_seen(aggregate, instance, shift))
                fmt::format_to(to, "<use xlink:href=\"#a{}p{}\" transform=\"{}\" fill=\"{}\"/>\n",
                               number, instance.prototype,
                               svg_matrix(instance.world_from_object, shift),
                               hex_color(color(aggregate, instance)));
    out += "</g>\n";
    if (aggregate.domain)
        fmt::format_to(to,
                       "<path class=\"domain\" fill=\"none\" stroke=\"#333338\" "
                       "stroke-width=\"1.5\" vector-effect=\"non-scaling-stroke\" d=\"{}\"/>\n",
                       domain);
    out += "</g>\n";
}

} // namespace

std::string layout_svg(std::span<const Aggregate> aggregates, const ElementColor& color) {
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
        write_aggregate(out, aggregates[i], i, color);
    return out + "</svg>\n";
}

} // namespace scree
