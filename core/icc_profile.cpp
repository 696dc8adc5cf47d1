// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/icc_profile.h"

#include "core/chromaticities.h"
#include "core/display_encoding.h"
#include "core/error.h"
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

using Curve = ColorEncoding::Curve;

/// A view of bytes, high byte first.
class BigEndian {
  public:
    explicit BigEndian(std::string_view bytes) : bytes_(bytes) {}

    std::uint32_t integer(std::size_t at, std::size_t size) const {
        const std::string_view part = text(at, size);
        std::uint32_t value = 0;
        for (const char c : part)
            value = value << 8U | static_cast<unsigned char>(c);
        return value;
    }
    double fixed(std::size_t at) const { // s15Fixed16Number
        return static_cast<std::int32_t>(integer(at, 4)) / 65536.0;
    }
    std::string_view text(std::size_t at, std::size_t size) const {
        if (at > bytes_.size() || size > bytes_.size() - at)
            throw Error("its embedded profile is damaged");
        return bytes_.substr(at, size);
    }

  private:
    std::string_view bytes_;
};

Curve table_curve(const BigEndian& data, std::size_t count) {
    std::vector<float> table(count);
    for (std::size_t i = 0; i < count; ++i)
        table[i] = static_cast<float>(data.integer(12 + 2 * i, 2)) / 65535;
    return [table = std::move(table)](float v) {
        const float at = std::clamp(v, 0.0F, 1.0F) * static_cast<float>(table.size() - 1);
        const std::size_t below = std::min(static_cast<std::size_t>(at), table.size() - 2);
        const float share = at - static_cast<float>(below);
        return table[below] + share * (table[below + 1] - table[below]);
    };
}

// Section 10.15, table 65: the parameters are g, a, b, c, d, e, f.
Curve parametric_curve(const BigEndian& data) {
    static constexpr std::array<std::size_t, 5> counts{1, 3, 4, 5, 7};
    const std::uint32_t kind = data.integer(8, 2);
    if (kind >= counts.size())
        throw Error("its embedded profile is damaged");
    std::array<float, 7> p{1, 1, 0, 0, 0, 0, 0};
    for (std::size_t i = 0; i < counts[kind]; ++i)
        p[i] = static_cast<float>(data.fixed(12 + 4 * i));
    const float g = p[0], a = p[1], b = p[2];
    const bool constant_below = kind == 1 || kind == 2; // -b / a
    const float d = !constant_below ? p[4] : a != 0 ? -b / a : 0;
    const float c = constant_below ? 0 : p[3];
    const float e = constant_below ? p[3] : p[5];
    const float f = constant_below ? p[3] : p[6];
    return [=](float v) { return v >= d ? std::pow(std::max(0.0F, a * v + b), g) + e : c * v + f; };
}

Curve curve_of(std::string_view tag) {
    const BigEndian data(tag);
    if (data.text(0, 4) == "para")
        return parametric_curve(data);
    if (data.text(0, 4) != "curv")
        throw Error("its embedded profile is damaged");
    const std::uint32_t count = data.integer(8, 4);
    if (count == 0)
        return [](float v) { return v; };
    if (count > 1) {
        data.text(12, std::size_t{count} * 2); // checks the size
        return table_curve(data, count);
    }
    return power_encoding(data.integer(12, 2) / 256.0).linear[0];
}

class Profile {
  public:
    explicit Profile(std::string_view bytes) : data_(bytes) {
        if (data_.text(36, 4) != "acsp")
            throw Error("its embedded profile is damaged");
    }

    std::string_view space() const { return trimmed(data_.text(16, 4)); }

    std::optional<std::string_view> tag(std::string_view name) const {
        const std::uint32_t count = data_.integer(128, 4);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t entry = 132 + 12 * i;
            if (data_.text(entry, 4) == name)
                return data_.text(data_.integer(entry + 4, 4), data_.integer(entry + 8, 4));
        }
        return {};
    }

  private:
    BigEndian data_;
};

/// The row of a colorant in XYZ relative to D50.
std::array<double, 3> colorant(std::string_view tag) {
    const BigEndian data(tag);
    return {data.fixed(8), data.fixed(12), data.fixed(16)};
}

bool is_srgb(const ColorEncoding& encoding) {
    constexpr float rounding = 0.004F; // of 2.2-step tables and 8-bit colorants of usual profiles
    for (int i = 0; i <= 64; ++i) {
        const float v = static_cast<float>(i) / 64;
        for (const Curve& curve : encoding.linear)
            if (std::abs(curve(v) - linear_from_display(v)) > rounding)
                return false;
    }
    return encoding.rec709_from_primaries->equalWithAbsError(Imath::M33f(), 2 * rounding);
}

} // namespace

ColorEncoding srgb_encoding() {
    const Curve curve = [](float v) { return linear_from_display(v); };
    return {{curve, curve, curve}, {}};
}

ColorEncoding power_encoding(double exponent) {
    const Curve curve = [power = static_cast<float>(exponent)](float v) {
        return std::pow(std::max(0.0F, v), power);
    };
    return {{curve, curve, curve}, {}};
}

ColorEncoding icc_encoding(std::string_view bytes) {
    const Profile profile(bytes);
    if (profile.space() == "GRAY") {
        const auto tone = profile.tag("kTRC");
        if (!tone)
            throw Error("its embedded profile has no curve of grey");
        const Curve curve = curve_of(*tone);
        return {{curve, curve, curve}, {}};
    }
    if (profile.space() != "RGB")
        throw Error(fmt::format("its embedded profile is of {}, expected RGB or GRAY; convert it "
                                "to sRGB",
                                profile.space()));
    static constexpr std::array<std::array<std::string_view, 2>, 3> names{
        {{"rXYZ", "rTRC"}, {"gXYZ", "gTRC"}, {"bXYZ", "bTRC"}}};
    ColorEncoding encoding;
    std::array<std::array<double, 3>, 3> xyz{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto color = profile.tag(names[c][0]);
        const auto tone = profile.tag(names[c][1]);
        if (!color || !tone)
            throw Error("its embedded profile consists of lookup tables, which are not read; "
                        "convert it to sRGB");
        xyz[c] = colorant(*color);
        encoding.linear[c] = curve_of(*tone);
    }
    Imath::M33f matrix;
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned k = 0; k < 3; ++k)
            matrix[i][k] = static_cast<float>(xyz[i][k]);
    encoding.rec709_from_primaries = matrix * rec709_from_xyz(icc_white);
    return is_srgb(encoding) ? srgb_encoding() : encoding;
}

} // namespace scree
