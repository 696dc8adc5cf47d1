// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"

#include "core/error.h"
#include "core/text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace scree {

namespace fs = std::filesystem;

namespace {

std::string reason(int code) { return std::strerror(code); }

fs::path folder_of(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

// The data must be synced before the rename, the folder after it.
void sync_path(const fs::path& path, int flags) {
    const int descriptor = open(path.c_str(), flags | O_CLOEXEC);
    if (descriptor < 0)
        throw Error::resource("cannot open " + path.string() + ": " + reason(errno));
    const int failed = fsync(descriptor) != 0 ? errno : 0;
    close(descriptor);
    // Some file systems cannot sync a folder (EINVAL); no data is lost.
    if (failed != 0 && failed != EINVAL && failed != EROFS)
        throw Error::resource("cannot write " + path.string() + ": " + reason(failed));
}

// "did you mean bunny.obj?" for a missing file with a similarly named neighbour.
std::string near_file(const std::string& path) {
    std::vector<std::string> names;
    std::error_code code;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(path), code))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end()); // folders are listed in unspecified order
    return did_you_mean(file_name(path), names);
}

} // namespace

void check_is_file(const std::string& path) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (!fs::exists(status))
        throw Error(Diagnostic{{}, {}, path + ": no such file", near_file(path)});
    if (fs::is_directory(status))
        throw Error(path + ": is a folder, not a file");
}

std::string read_file(const std::string& path, std::uint64_t limit) {
    check_is_file(path);
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw Error(path + ": cannot be read: " + reason(errno));
    std::string bytes;
    std::string block(std::size_t{1} << 16, '\0');
    while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
        bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
        if (bytes.size() > limit)
            throw Error(path + ": is larger than " + std::to_string(limit) + " bytes");
    }
    if (in.bad())
        throw Error(path + ": cannot be read: " + reason(errno));
    return bytes;
}

void check_writable(const std::string& path) {
    if (fs::is_directory(path))
        throw Error::resource("cannot write " + path + ": is a folder");
    const fs::path folder = folder_of(path);
    if (!fs::exists(folder))
        throw Error::resource("cannot write " + path + ": no such folder " + folder.string());
    if (!fs::is_directory(folder))
        throw Error::resource("cannot write " + path + ": " + folder.string() + " is not a folder");
    if (access(folder.c_str(), W_OK) != 0)
        throw Error::resource("cannot write " + path + ": " + reason(errno));
}

void write_atomically(const std::string& path,
                      const std::function<void(const std::string& temporary_path)>& write) {
    check_writable(path);
    // The temporary name keeps the extension, by which image libraries choose the format.
    const fs::path target(path);
    const fs::path temporary =
        folder_of(path) /
        (target.stem().string() + ".tmp." + std::to_string(getpid()) + target.extension().string());
    try {
        write(temporary.string());
        sync_path(temporary, O_RDONLY);
        fs::rename(temporary, target);
    } catch (const fs::filesystem_error& failure) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw Error::resource("cannot write " + path + ": " + failure.code().message());
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
    sync_path(folder_of(path), O_RDONLY | O_DIRECTORY);
}

void write_stream(const std::string& path, const std::function<void(std::ostream& out)>& write) {
    write_atomically(path, [&](const std::string& temporary) {
        errno = 0;
        std::ofstream out(temporary, std::ios::binary);
        if (out)
            write(out);
        out.close();
        if (!out)
            throw Error::resource("cannot write " + path + ": " + reason(errno != 0 ? errno : EIO));
    });
}

void write_file(const std::string& path, std::string_view bytes) {
    write_stream(path, [&](std::ostream& out) {
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
}

std::string extension(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    if (!ending.empty())
        ending.erase(0, 1);
    return lower_case(ending);
}

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

std::string resolve_path(const std::string& path, const std::string& base_file) {
    const fs::path given(path);
    if (given.is_absolute())
        return path;
    return (fs::path(base_file).parent_path() / given).lexically_normal().string();
}

std::uint64_t hash_bytes(std::string_view bytes) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 1099511628211ULL;
    }
    return hash;
}

} // namespace scree
