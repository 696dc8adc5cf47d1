// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/write_3mf.h"

#include "core/error.h"
#include "core/file.h"
#include "core/version.h"
#include "formats/printer_frame.h"

#include <Common/NMR_ErrorConst.h>
#include <Model/COM/NMR_DLLInterfaces.h>

#include <fmt/format.h>

#include <limits>
#include <memory>
#include <ostream>

namespace scree {

namespace {

// In lib3mf's C interface all objects have one type.
using Handle = NMR::PLib3MFBase*;

struct Release {
    void operator()(Handle handle) const { NMR::lib3mf_release(handle); }
};
using Owner = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

class Document {
  public:
    explicit Document(const std::string& path) : path_(path) {
        model_ = made([](Handle* out) { return NMR::lib3mf_createmodel(out); }, nullptr);
        check(NMR::lib3mf_model_setunit(model_.get(), NMR::MODELUNIT_MILLIMETER), model_.get());
        check(
            NMR::lib3mf_model_addmetadatautf8(model_.get(), "Application", "Scree " SCREE_VERSION),
            model_.get());
    }

    void add(const Mesh& mesh, const std::string& title) {
        std::vector<NMR::MODELMESHVERTEX> vertices(mesh.positions.size());
        std::vector<NMR::MODELMESHTRIANGLE> triangles(mesh.triangles.size());
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            const Vec3 p = printer_position(mesh.positions[v]);
            vertices[v] = {{p.x, p.y, p.z}};
        }
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const Mesh::Triangle& c = mesh.triangles[t];
            triangles[t] = {{c[0], c[1], c[2]}};
        }
        const std::uint64_t hash = hash_bytes({reinterpret_cast<const char*>(vertices.data()),
                                               vertices.size() * sizeof(NMR::MODELMESHVERTEX)}) ^
                                   hash_bytes({reinterpret_cast<const char*>(triangles.data()),
                                               triangles.size() * sizeof(NMR::MODELMESHTRIANGLE)});
        const Owner object =
            made([&](Handle* out) { return NMR::lib3mf_model_addmeshobject(model_.get(), out); },
                 model_.get());
        check(NMR::lib3mf_object_setnameutf8(object.get(), title.c_str()), object.get());
        check(NMR::lib3mf_meshobject_setgeometry(object.get(), vertices.data(),
                                                 DWORD(vertices.size()), triangles.data(),
                                                 DWORD(triangles.size())),
              object.get());
        const Owner item = made(
            [&](Handle* out) {
                return NMR::lib3mf_model_addbuilditem(model_.get(), object.get(), nullptr, out);
            },
            model_.get());
        // The library's UUIDs are random; these are hashes of the content.
        check(NMR::lib3mf_object_setuuidutf8(object.get(), uuid(hash, 1).c_str()), object.get());
        check(NMR::lib3mf_builditem_setuuidutf8(item.get(), uuid(hash, 2).c_str()), item.get());
        check(NMR::lib3mf_model_setbuilduuidutf8(model_.get(), uuid(hash, 3).c_str()),
              model_.get());
    }

    void write(std::ostream& out) const {
        const Owner writer = made(
            [&](Handle* made) { return NMR::lib3mf_model_querywriter(model_.get(), "3mf", made); },
            model_.get());
        check(NMR::lib3mf_writer_writetocallback(writer.get(), reinterpret_cast<void*>(put),
                                                 reinterpret_cast<void*>(seek), &out),
              writer.get());
    }

  private:
    static unsigned put(unsigned char* bytes, unsigned count, void* stream) {
        auto& out = *static_cast<std::ostream*>(stream);
        out.write(reinterpret_cast<const char*>(bytes), std::streamsize(count));
        return NMR_SUCCESS; // errors are kept in the stream's state
    }
    static unsigned seek(std::uint64_t position, void* stream) {
        static_cast<std::ostream*>(stream)->seekp(std::streamoff(position));
        return NMR_SUCCESS;
    }

    // The hash as a UUID of version 8 (RFC 9562).
    static std::string uuid(std::uint64_t hash, int number) {
        return fmt::format("{:08x}-{:04x}-8{:03x}-a000-{:012x}", hash >> 32, hash >> 16 & 0xffff,
                           hash & 0xfff, number);
    }

    template <class Make>
    Owner made(const Make& make, Handle from) const {
        Handle handle = nullptr;
        check(make(&handle), from);
        return Owner(handle);
    }

    void check(int result, Handle of) const {
        if (result == LIB3MF_OK)
            return;
        DWORD code = 0;
        const char* message = nullptr;
        if (of != nullptr)
            NMR::lib3mf_getlasterror(of, &code, &message);
        throw Error::resource(fmt::format("cannot write {}: lib3mf: {}", path_,
                                          message != nullptr ? message : "unknown error"));
    }

    const std::string& path_;
    Owner model_;
};

} // namespace

void write_3mf(const std::string& path, const Mesh& mesh, const std::string& title) {
    constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
    if (mesh.positions.size() > most || mesh.triangles.size() > most)
        throw Error::resource("cannot write " + path + ": it has more than 2^31 triangles");
    Document document(path);
    document.add(mesh, title);
    write_stream(path, [&](std::ostream& out) { document.write(out); });
}

} // namespace scree
