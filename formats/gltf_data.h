// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a glTF file's accessors.
#pragma once

#include "formats/gltf_file.h"

#include <cstdint>

namespace scree::gltf {

/// The most elements of an accessor and the most vertices in all: accessors of zeros and nodes that
/// repeat a mesh cost a file no bytes.
inline constexpr std::size_t vertex_limit = 100'000'000;

/// The bytes of a file's buffers, read when they are first asked for. All its Errors (input) name
/// the element: data that reach beyond their buffer, a buffer that is not there, compressed data.
class Data {
  public:
    /// `chunk` holds the binary part of a .glb file, `folder` the other files. Both views must live
    /// as long.
    Data(const File& file, std::string_view chunk, std::string folder);

    std::string_view bytes_of(std::size_t view);

    const std::string& folder() const { return folder_; }

    /// How many elements an accessor has.
    std::size_t elements_in(std::size_t accessor) const { return file_.accessors[accessor].count; }

    /// All numbers of an accessor, element after element; integers as they are, or in [-1, 1] when
    /// they are marked as normalised. Throws when its elements do not have `width` numbers.
    std::vector<double> numbers(std::size_t accessor, std::size_t width);

    /// The whole numbers of an accessor. Throws when they are of another type.
    std::vector<std::uint32_t> indices(std::size_t accessor);

  private:
    std::string_view buffer(std::size_t index);
    /// `count` elements of `element` bytes each, `stride` bytes apart (0: no gaps), for `user`.
    std::string_view range(std::size_t view, std::size_t offset, std::size_t count,
                           std::size_t element, std::size_t stride, const std::string& user);
    void replace_sparse(const Accessor& accessor, const std::string& user,
                        std::vector<double>& numbers);

    const File& file_;
    std::string_view chunk_;
    std::string folder_;
    std::vector<std::optional<std::string>> loaded_; // by buffer
};

} // namespace scree::gltf
