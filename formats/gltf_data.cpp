// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_data.h"

#include "core/error.h"
#include "core/file.h"
#include "formats/uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace scree::gltf {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint64_t largest_buffer = std::uint64_t{1} << 32; // [bytes]

template <class T>
double read_as(const char* from, bool normalized) {
    T value{};
    std::memcpy(&value, from, sizeof value);
    const auto number = static_cast<double>(value);
    // -128 and -127 both stand for -1.
    return normalized ? std::max(number / double(std::numeric_limits<T>::max()), -1.0) : number;
}

double read_number(const char* from, Component component, bool normalized) {
    switch (component) {
    case Component::int8:
        return read_as<std::int8_t>(from, normalized);
    case Component::uint8:
        return read_as<std::uint8_t>(from, normalized);
    case Component::int16:
        return read_as<std::int16_t>(from, normalized);
    case Component::uint16:
        return read_as<std::uint16_t>(from, normalized);
    case Component::uint32:
        return read_as<std::uint32_t>(from, normalized);
    default:
        return read_as<float>(from, false);
    }
}

std::string name_of(std::size_t accessor) { return fmt::format("accessors[{}]", accessor); }

} // namespace

Data::Data(const File& file, std::string_view chunk, std::string folder)
    : file_(file), chunk_(chunk), folder_(std::move(folder)), loaded_(file.buffers.size()) {}

std::string_view Data::buffer(std::size_t index) {
    const Buffer& buffer = file_.buffers[index];
    const std::string name = fmt::format("buffers[{}]", index);
    std::string_view bytes;
    if (buffer.uri) {
        std::optional<std::string>& loaded = loaded_[index];
        if (!loaded) {
            try {
                loaded = data_of_uri(*buffer.uri);
                if (!loaded)
                    loaded = read_file(file_of_uri(*buffer.uri, folder_), largest_buffer);
            } catch (const Error& problem) {
                throw Error(name + ": " + problem.diagnostics().front().message);
            }
        }
        bytes = *loaded;
    } else if (index == 0 && chunk_.data() != nullptr) {
        bytes = chunk_;
    } else {
        throw Error(name + " has no data");
    }
    if (bytes.size() < buffer.length)
        throw Error(fmt::format("{} should be {} bytes long, but there are only {}", name,
                                buffer.length, bytes.size()));
    return bytes.substr(0, buffer.length);
}

std::string_view Data::bytes_of(std::size_t index) {
    const BufferView& view = file_.views[index];
    const std::string name = fmt::format("bufferViews[{}]", index);
    if (!view.compression.empty() && !file_.buffers[view.buffer].uri &&
        !(view.buffer == 0 && chunk_.data() != nullptr))
        throw Error(fmt::format("{} is compressed by {}, which is not read; export it without",
                                name, view.compression));
    const std::string_view bytes = buffer(view.buffer);
    if (view.offset > bytes.size() || view.length > bytes.size() - view.offset)
        throw Error(fmt::format("{} reaches beyond its buffer of {} bytes", name, bytes.size()));
    return bytes.substr(view.offset, view.length);
}

std::string_view Data::range(std::size_t view, std::size_t offset, std::size_t count,
                             std::size_t element, std::size_t stride, const std::string& user) {
    const std::string_view bytes = bytes_of(view);
    const std::size_t step = stride == 0 ? element : stride;
    if (count == 0)
        return {};
    if (offset > bytes.size() || element > bytes.size() - offset ||
        count - 1 > (bytes.size() - offset - element) / step)
        throw Error(fmt::format("{} reaches beyond bufferViews[{}], which has {} bytes", user, view,
                                bytes.size()));
    return bytes.substr(offset);
}

void Data::replace_sparse(const Accessor& accessor, const std::string& user,
                          std::vector<double>& numbers) {
    const Sparse& sparse = *accessor.sparse;
    const std::size_t size = size_of(accessor.component);
    const std::size_t index_size = size_of(sparse.indices_component);
    if (sparse.indices_component == Component::float32)
        throw Error(user + ".sparse.indices must be whole numbers");
    const std::string_view indices = range(sparse.indices_view, sparse.indices_offset, sparse.count,
                                           index_size, 0, user + ".sparse.indices");
    const std::string_view values = range(sparse.values_view, sparse.values_offset, sparse.count,
                                          size * accessor.width, 0, user + ".sparse.values");
    for (std::size_t i = 0; i < sparse.count; ++i) {
        const double index =
            read_number(indices.data() + i * index_size, sparse.indices_component, false);
        if (!(index >= 0 && index < double(accessor.count)))
            throw Error(fmt::format("{}.sparse.indices names element {} of {}", user, index,
                                    accessor.count));
        for (std::size_t k = 0; k < accessor.width; ++k)
            numbers[std::size_t(index) * accessor.width + k] =
                read_number(values.data() + (i * accessor.width + k) * size, accessor.component,
                            accessor.normalized);
    }
}

std::vector<double> Data::numbers(std::size_t index, std::size_t width) {
    const Accessor& accessor = file_.accessors[index];
    const std::string name = name_of(index);
    if (accessor.width != width)
        throw Error(fmt::format("{} has {} numbers in an element where {} are needed", name,
                                accessor.width, width));
    if (accessor.count > vertex_limit)
        throw Error(fmt::format("{} counts {} elements; at most {} are read", name, accessor.count,
                                vertex_limit));
    const std::size_t size = size_of(accessor.component);
    std::string_view bytes;
    std::size_t stride = size * width;
    if (accessor.view) { // looked at first, so that a forged count asks for no memory
        if (const std::size_t given = file_.views[*accessor.view].stride; given != 0)
            stride = given;
        bytes = range(*accessor.view, accessor.offset, accessor.count, size * width, stride, name);
    }
    std::vector<double> out(accessor.count * width);
    if (accessor.view)
        for (std::size_t i = 0; i < accessor.count; ++i)
            for (std::size_t k = 0; k < width; ++k)
                out[i * width + k] = read_number(bytes.data() + i * stride + k * size,
                                                 accessor.component, accessor.normalized);
    if (accessor.sparse)
        replace_sparse(accessor, name, out);
    return out;
}

std::vector<std::uint32_t> Data::indices(std::size_t index) {
    const Accessor& accessor = file_.accessors[index];
    if (accessor.component == Component::float32 || accessor.normalized)
        throw Error(name_of(index) + " must hold whole numbers");
    std::vector<std::uint32_t> out;
    for (const double number : numbers(index, 1)) {
        if (number < 0)
            throw Error(fmt::format("{} holds the negative number {}", name_of(index), number));
        out.push_back(static_cast<std::uint32_t>(number));
    }
    return out;
}

} // namespace scree::gltf
