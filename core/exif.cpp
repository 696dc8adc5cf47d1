// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exif.h"

#include <cstdint>
#include <optional>

namespace scree {

namespace {

constexpr std::uint32_t orientation_tag = 0x112;
constexpr std::uint32_t color_space_tag = 0xa001;
constexpr std::uint32_t exif_directory_tag = 0x8769;

class Tiff {
  public:
    explicit Tiff(std::string_view bytes) : bytes_(bytes), low_first_(bytes.starts_with("II")) {}

    std::uint32_t first_directory() const { return integer(4, 4); }

    /// The value of a tag that holds one 16-bit or 32-bit integer (TIFF 6.0, section 2).
    std::optional<std::uint32_t> value(std::uint32_t directory, std::uint32_t tag) const {
        const std::uint32_t count = integer(directory, 2);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::size_t entry = std::size_t{directory} + 2 + 12 * std::size_t{i};
            if (entry + 12 > bytes_.size())
                return {};
            if (integer(entry, 2) == tag)
                return integer(entry + 8, integer(entry + 2, 2) == 3 ? 2 : 4);
        }
        return {};
    }

  private:
    std::uint32_t integer(std::size_t at, std::size_t size) const {
        std::uint32_t out = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t from = at + (low_first_ ? size - 1 - i : i);
            out =
                out << 8U | (from < bytes_.size() ? static_cast<unsigned char>(bytes_[from]) : 0U);
        }
        return out;
    }

    std::string_view bytes_;
    bool low_first_;
};

} // namespace

ExifFacts exif_facts(std::string_view bytes) {
    ExifFacts facts;
    if (!bytes.starts_with("II") && !bytes.starts_with("MM"))
        return facts;
    const Tiff tiff(bytes);
    const std::uint32_t first = tiff.first_directory();
    if (const auto orientation = tiff.value(first, orientation_tag);
        orientation && *orientation >= 1 && *orientation <= 8)
        facts.orientation = static_cast<int>(*orientation);
    if (const auto inner = tiff.value(first, exif_directory_tag))
        if (const auto space = tiff.value(*inner, color_space_tag))
            facts.color_space = static_cast<int>(*space & 0xffffU);
    return facts;
}

} // namespace scree
