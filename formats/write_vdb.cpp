// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/write_vdb.h"

#include "core/error.h"
#include "core/file.h"

#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Prune.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace scree {

namespace {

/// openvdb::io::File does not check its stream and reports success on a full disk. This archive
/// writes to a given stream, which is checked.
class CheckedArchive final : public openvdb::io::Archive {
  public:
    using openvdb::io::Archive::write;

    void write_file(const std::string& path, const openvdb::GridCPtrVec& grids,
                    const openvdb::MetaMap& metadata, const std::string& id) const {
        std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out | std::ios::trunc);
        constexpr bool seekable = true; // includes the grids' offsets, so that readers can skip
        if (file)
            write(file, grids, seekable, metadata);
        // The file's UUID follows the magic number, three versions and a flag. OpenVDB's is random;
        // it is replaced by a hash of the content.
        file.seekp(8 + 3 * 4 + 1);
        file.write(id.data(), std::streamsize(id.size()));
        file.close();
        if (!file)
            throw Error::resource(std::strerror(errno != 0 ? errno : EIO));
    }
};

// A hash of the metadata and the grid as a UUID of version 8 (RFC 9562).
std::string identity(const Metadata& metadata, const openvdb::FloatGrid& grid) {
    std::string all = fmt::format("{}", grid.activeVoxelCount());
    const openvdb::Mat4R matrix = grid.transform().baseMap()->getAffineMap()->getMat4();
    for (int i = 0; i < 16; ++i)
        all += fmt::format(" {}", matrix.asPointer()[i]);
    for (const auto& [name, value] : metadata)
        all += name + "=" + value + "\n";
    const std::uint64_t a = hash_bytes(all), b = hash_bytes(all + "2");
    return fmt::format("{:08x}-{:04x}-8{:03x}-a{:03x}-{:012x}", a >> 32, a >> 16 & 0xffff,
                       a & 0xfff, b >> 48 & 0xfff, b & 0xffffffffffffULL);
}

} // namespace

struct VdbFile::Grids {
    openvdb::FloatGrid::Ptr density;
    openvdb::Vec3SGrid::Ptr color;
    openvdb::FloatGrid::Accessor density_at;
    openvdb::Vec3SGrid::Accessor color_at;

    Grids()
        : density(openvdb::FloatGrid::create(0)),
          color(openvdb::Vec3SGrid::create(openvdb::Vec3s(0, 0, 0))),
          density_at(density->getAccessor()), color_at(color->getAccessor()) {}
};

VdbFile::VdbFile(const Imath::M44d& world_from_index) {
    openvdb::initialize(); // does nothing after the first call
    grids_ = std::make_unique<Grids>();
    // OpenVDB and Imath both multiply row vectors.
    const openvdb::math::Mat4d matrix(&world_from_index.x[0][0]);
    const auto transform = openvdb::math::Transform::createLinearTransform(matrix);
    grids_->density->setName("density");
    grids_->density->setGridClass(openvdb::GRID_FOG_VOLUME);
    grids_->density->setTransform(transform);
    grids_->color->setName("color");
    grids_->color->setVectorType(openvdb::VEC_INVARIANT);
    grids_->color->setTransform(transform->copy());
}

VdbFile::~VdbFile() = default;

void VdbFile::set(int i, int j, int k, float density, const Color& color) {
    grids_->density_at.setValueOn({i, j, k}, density);
    grids_->color_at.setValueOn({i, j, k}, {color.x, color.y, color.z});
    densest_ = std::max(densest_, density);
}

void VdbFile::write(const std::string& path, const Metadata& metadata) {
    openvdb::tools::prune(grids_->density->tree());
    openvdb::tools::prune(grids_->color->tree());
    openvdb::MetaMap texts;
    for (const auto& [name, value] : metadata)
        texts.insertMeta(name, openvdb::StringMetadata(value));
    write_atomically(path, [&](const std::string& temporary) {
        try {
            CheckedArchive().write_file(temporary, {grids_->density, grids_->color}, texts,
                                        identity(metadata, *grids_->density));
        } catch (const std::exception& failure) { // OpenVDB's or CheckedArchive's
            throw Error::resource("cannot write " + path + ": " + failure.what());
        }
    });
}

} // namespace scree
