// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_container.h"

#include "core/error.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>

namespace scree::gltf {

namespace {

constexpr std::size_t header_size = 12; // the magic, the version, the length of the file
constexpr std::size_t chunk_header = 8; // the length of the content, the kind
constexpr std::uint32_t json_kind = 0x4e4f534a;
constexpr std::uint32_t binary_kind = 0x004e4942;

std::uint32_t number_at(std::string_view bytes, std::size_t offset) {
    static_assert(std::endian::native == std::endian::little);
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

} // namespace

Container container_of(std::string_view bytes) {
    if (!bytes.starts_with("glTF"))
        return {bytes, {}, 0};
    if (bytes.size() < header_size + chunk_header)
        throw Error("it ends too early");
    if (const std::uint32_t version = number_at(bytes, 4); version != 2)
        throw Error(fmt::format("it is of glTF version {}; only version 2 is read", version));
    const std::size_t length = number_at(bytes, 8);
    if (length > bytes.size())
        throw Error(fmt::format("it ends too early: its header promises {} bytes, there are {}",
                                length, bytes.size()));
    Container out;
    out.beyond = bytes.size() - length;
    bytes = bytes.substr(0, length);
    std::size_t at = header_size;
    for (int chunk = 0; at + chunk_header <= bytes.size(); ++chunk) {
        const std::size_t size = number_at(bytes, at);
        const std::uint32_t kind = number_at(bytes, at + 4);
        at += chunk_header;
        if (size > bytes.size() - at)
            throw Error(fmt::format("its chunk {} should be {} bytes long, but there are only {}",
                                    chunk, size, bytes.size() - at));
        if (chunk == 0 && kind != json_kind)
            throw Error("its first chunk is not JSON");
        if (chunk == 0)
            out.json = bytes.substr(at, size);
        else if (kind == binary_kind && out.binary.data() == nullptr)
            out.binary = bytes.substr(at, size);
        at += size;
    }
    return out;
}

} // namespace scree::gltf
