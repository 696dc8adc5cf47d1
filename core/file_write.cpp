// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/file.h"
#include "core/temporary_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace scree {

namespace fs = std::filesystem;

namespace {

Error cannot_write(const std::string& path, const std::string& reason) {
    return Error::resource("cannot write " + path + ": " + reason);
}

Error cannot_write(const std::string& path, int code) {
    return cannot_write(path, std::string(std::strerror(code)));
}

/// Where the bytes of an output go.
struct Destination {
    fs::path path;        // behind symbolic links
    bool is_plain = true; // a file that can be replaced, or none yet; not a pipe or a device
    fs::path folder() const { return folder_of(path.string()); }
};

// What a link in /proc leads to, as /dev/stdout does, is an open file: it is written, not replaced.
Destination destination_of(const std::string& path) {
    Destination to{path};
    std::error_code code;
    for (int links = 0; fs::is_symlink(fs::symlink_status(to.path, code)) &&
                        !is_made_by_the_kernel(to.folder().string());
         ++links) {
        if (links == 40)
            throw cannot_write(path, ELOOP);
        const fs::path next = fs::read_symlink(to.path, code);
        if (code)
            throw cannot_write(path, code.message());
        to.path = to.folder() / next; // `next` alone when it is absolute
    }
    if (is_made_by_the_kernel(to.folder().string()))
        return {path, false};
    const fs::file_status status = fs::status(to.path, code);
    to.is_plain = !fs::exists(status) || fs::is_regular_file(status);
    return to;
}

void check_destination(const std::string& path, const Destination& to) {
    std::error_code code;
    if (fs::is_directory(to.path, code))
        throw cannot_write(path, "is a folder");
    if (fs::exists(to.path, code) && access(to.path.c_str(), W_OK) != 0)
        throw cannot_write(path, errno);
    if (!to.is_plain)
        return;
    const fs::path folder = to.folder();
    if (!fs::exists(folder, code))
        throw cannot_write(path, "no such folder " + folder.string());
    if (!fs::is_directory(folder, code))
        throw cannot_write(path, folder.string() + " is not a folder");
    if (access(folder.c_str(), W_OK) != 0)
        throw cannot_write(path, errno);
}

// The data must be synced before the rename, the folder after it.
void sync_path(const std::string& path, const fs::path& synced, int flags) {
    const int descriptor = open(synced.c_str(), flags | O_CLOEXEC);
    if (descriptor < 0)
        throw cannot_write(path, errno);
    int failed = fsync(descriptor) != 0 ? errno : 0;
    // Some file systems cannot sync a folder (EINVAL); no data is lost.
    if (failed == EINVAL || failed == EROFS)
        failed = 0;
    if (close(descriptor) != 0 && failed == 0)
        failed = errno;
    if (failed != 0)
        throw cannot_write(path, failed);
}

void write_all(const std::string& path, int descriptor, const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t written = ::write(descriptor, bytes, count);
        if (written < 0 && errno != EINTR)
            throw cannot_write(path, errno);
        if (written > 0) {
            bytes += written;
            count -= static_cast<std::size_t>(written);
        }
    }
}

// Writers need a file in which they can seek, so that a pipe or a device gets a copy of one.
void write_through(const std::string& path,
                   const std::function<void(const std::string& temporary_path)>& write) {
    const TemporaryFile file(fs::temp_directory_path() / fs::path(path).filename());
    write(file.path());
    std::ifstream in(file.path(), std::ios::binary);
    if (!in)
        throw cannot_write(path, errno);
    const int descriptor = open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (descriptor < 0)
        throw cannot_write(path, errno);
    try {
        std::array<char, std::size_t{1} << 16> block;
        while (in.read(block.data(), block.size()) || in.gcount() > 0)
            write_all(path, descriptor, block.data(), static_cast<std::size_t>(in.gcount()));
        if (in.bad())
            throw cannot_write(path, "its temporary copy cannot be read");
    } catch (...) {
        close(descriptor);
        throw;
    }
    if (close(descriptor) != 0)
        throw cannot_write(path, errno);
}

} // namespace

void check_writable(const std::string& path) { check_destination(path, destination_of(path)); }

void write_atomically(const std::string& path,
                      const std::function<void(const std::string& temporary_path)>& write) {
    const Destination to = destination_of(path);
    check_destination(path, to);
    try {
        if (!to.is_plain)
            return write_through(path, write);
        TemporaryFile file(to.path);
        write(file.path());
        sync_path(path, file.path(), O_RDONLY);
        file.become(to.path);
    } catch (const fs::filesystem_error& failure) {
        throw cannot_write(path, failure.code().message());
    }
    sync_path(path, to.folder(), O_RDONLY | O_DIRECTORY);
}

void write_stream(const std::string& path, const std::function<void(std::ostream& out)>& write) {
    write_atomically(path, [&](const std::string& temporary) {
        errno = 0;
        std::ofstream out(temporary, std::ios::binary);
        if (out)
            write(out);
        out.close();
        if (!out)
            throw cannot_write(path, errno != 0 ? errno : EIO);
    });
}

void write_file(const std::string& path, std::string_view bytes) {
    write_stream(path, [&](std::ostream& out) {
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
}

} // namespace scree
