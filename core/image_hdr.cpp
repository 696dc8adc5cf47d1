// SPDX-License-Identifier: GPL-3.0-or-later
// Radiance's pictures (Ward 1991; "File Formats" of Radiance 5). OpenImageIO refuses those in XYZ
// and turns some orders of pixels the wrong way.
#include "core/chromaticities.h"
#include "core/error.h"
#include "core/file.h"
#include "core/image_reading.h"
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <sstream>

namespace scree {

namespace {

constexpr std::uint64_t largest_file = std::uint64_t{2} << 30;

/// What the lines before the pixels say.
struct HdrHeader {
    int width = 0; // of the stored image
    int height = 0;
    int orientation = 1; // of EXIF
    bool xyz = false;
    Imath::V3d scale{1.0}; // by which the radiance was multiplied: of red, green and blue
    float aspect = 1;      // width of a pixel in its height
    std::optional<Chromaticities> primaries;
};

class HdrReader {
  public:
    HdrReader(std::string path, std::string bytes)
        : path_(std::move(path)), bytes_(std::move(bytes)) {}

    HdrHeader header() {
        HdrHeader out;
        for (std::string text = line(); !text.empty(); text = line())
            if (const std::size_t equals = text.find('='); equals != std::string::npos)
                variable(text.substr(0, equals), text.substr(equals + 1), out);
        resolution(line(), out);
        check_image_size(path_, out.width, out.height, 3);
        return out;
    }

    Image pixels(const HdrHeader& header) {
        if (bytes_.size() - at_ < 4 * std::size_t(header.height)) // a line has at least a pixel
            fail("is not a valid HDR image: it ends before its last pixel");
        Image image(header.width, header.height, {"R", "G", "B"});
        std::vector<std::array<std::uint8_t, 4>> row(std::size_t(header.width));
        for (int y = 0; y < header.height; ++y) {
            scanline(row);
            for (int x = 0; x < header.width; ++x) {
                const auto& [r, g, b, exponent] = row[std::size_t(x)];
                const float scale = exponent == 0 ? 0.0F : std::ldexp(1.0F, exponent - 136);
                float* out = image.at(x, y);
                out[0] = float(r) * scale;
                out[1] = float(g) * scale;
                out[2] = float(b) * scale;
            }
        }
        return image;
    }

  private:
    using Pixel = std::array<std::uint8_t, 4>;

    [[noreturn]] void fail(const std::string& message) const {
        throw Error(path_ + ": " + message);
    }

    std::string line() {
        const std::size_t end = bytes_.find('\n', at_);
        if (end == std::string::npos || end - at_ > 4096)
            fail("is not a valid HDR image: its header does not end");
        std::string text = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        if (text.ends_with('\r'))
            text.pop_back();
        return text;
    }

    std::vector<double> numbers(const std::string& name, const std::string& text,
                                std::size_t count) const {
        std::istringstream in(text);
        in.imbue(std::locale::classic());
        std::vector<double> out;
        for (double value = 0; in >> value;)
            out.push_back(value);
        if (out.size() != count || !in.eof())
            fail(fmt::format("{}: expected {} number{}, got \"{:.40}\"", name, count,
                             count == 1 ? "" : "s", text));
        return out;
    }

    void variable(const std::string& name, const std::string& value, HdrHeader& out) const {
        const auto above_zero = [&](double v) {
            if (!(v > 0))
                fail(fmt::format("{}: expected a number above 0, got \"{:.40}\"", name, value));
            return v;
        };
        if (name == "FORMAT") {
            out.xyz = trimmed(value) == "32-bit_rle_xyze";
            if (!out.xyz && trimmed(value) != "32-bit_rle_rgbe")
                fail(fmt::format("FORMAT: expected 32-bit_rle_rgbe or 32-bit_rle_xyze, got "
                                 "\"{:.40}\"",
                                 value));
        } else if (name == "EXPOSURE") {
            out.scale *= above_zero(numbers(name, value, 1)[0]);
        } else if (name == "COLORCORR") {
            const std::vector<double> n = numbers(name, value, 3);
            out.scale *= Imath::V3d(above_zero(n[0]), above_zero(n[1]), above_zero(n[2]));
        } else if (name == "PIXASPECT") { // a pixel's height in its width
            out.aspect = static_cast<float>(1 / above_zero(numbers(name, value, 1)[0]));
        } else if (name == "PRIMARIES") {
            const std::vector<double> n = numbers(name, value, 8);
            out.primaries = {{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, {n[6], n[7]}};
        }
    }

    void resolution(const std::string& text, HdrHeader& out) const {
        std::istringstream in(text);
        in.imbue(std::locale::classic());
        std::string slow, fast;
        int rows = 0, columns = 0;
        in >> slow >> rows >> fast >> columns;
        const std::string axes = slow + fast;
        static constexpr std::array<std::string_view, 8> orders{"-Y+X", "-Y-X", "+Y-X", "+Y+X",
                                                                "+X-Y", "-X-Y", "-X+Y", "+X+Y"};
        const auto order = std::find(orders.begin(), orders.end(), axes);
        if (!in || order == orders.end())
            fail(fmt::format("expected a size like \"-Y 512 +X 1024\", got \"{:.40}\"", text));
        out.height = rows;
        out.width = columns;
        out.orientation = static_cast<int>(order - orders.begin()) + 1;
    }

    std::uint8_t byte() {
        if (at_ >= bytes_.size())
            fail("is not a valid HDR image: it ends before its last pixel");
        return static_cast<std::uint8_t>(bytes_[at_++]);
    }

    Pixel pixel() { return {byte(), byte(), byte(), byte()}; }

    void scanline(std::vector<Pixel>& row) {
        const std::size_t width = row.size();
        const Pixel start = pixel();
        const bool by_component =
            start[0] == 2 && start[1] == 2 && start[2] < 128 && width >= 8 && width <= 0x7fff &&
            std::size_t(start[2]) << 8U == (width & 0xff00U) && start[3] == (width & 0xffU);
        if (by_component)
            for (std::size_t c = 0; c < 4; ++c)
                component(row, c);
        else
            by_pixel(row, start);
    }

    void component(std::vector<Pixel>& row, std::size_t c) {
        for (std::size_t x = 0; x < row.size();) {
            const std::size_t code = byte();
            const bool run = code > 128;
            const std::size_t count = run ? code - 128 : code;
            if (count == 0 || x + count > row.size())
                fail("is not a valid HDR image: a run does not fit its line");
            const std::uint8_t repeated = run ? byte() : std::uint8_t{0};
            for (std::size_t i = 0; i < count; ++i)
                row[x++][c] = run ? repeated : byte();
        }
    }

    /// Pixels one by one, or repeated by 1, 1, 1 and how often; more such follow as higher digits.
    void by_pixel(std::vector<Pixel>& row, Pixel next) {
        unsigned shift = 0;
        for (std::size_t x = 0;;) {
            if (next[0] == 1 && next[1] == 1 && next[2] == 1) {
                const std::size_t count = std::size_t(next[3]) << shift;
                if (x == 0 || shift > 24 || x + count > row.size())
                    fail("is not a valid HDR image: a run does not fit its line");
                std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
                x += count;
                shift += 8;
            } else {
                row[x++] = next;
                shift = 0;
            }
            if (x == row.size())
                return;
            next = pixel();
        }
    }

    std::string path_;
    std::string bytes_;
    std::size_t at_ = 0;
};

/// To radiance in Rec. 709.
void to_radiance(Image& image, const HdrHeader& header) {
    const Imath::V3f scale(Imath::V3d(1.0) / header.scale);
    const Imath::M33f scaled(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z);
    // XYZ of files are relative to the equal-energy white, on which Radiance's colours are based.
    if (header.xyz)
        convert_primaries(image, scaled * rec709_from_xyz({1, 1, 1}));
    else
        convert_primaries(image,
                          header.primaries ? scaled * rec709_from(*header.primaries) : scaled);
}

} // namespace

Image read_hdr(const std::string& path, Meaning meaning, const ImageOptions& options) {
    HdrReader reader(path, read_file(path, largest_file));
    const HdrHeader header = reader.header();
    Image image = reader.pixels(header);
    if (meaning == Meaning::color) {
        try {
            to_radiance(image, header);
        } catch (const Error& error) {
            throw Error(path + ": " + error.diagnostics().front().message);
        }
    }
    warn_of_aspect(path, header.aspect, options.warn);
    return upright(std::move(image), header.orientation);
}

} // namespace scree
