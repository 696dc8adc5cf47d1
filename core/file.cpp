// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"

#include "core/error.h"
#include "core/text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <linux/magic.h>
#include <sys/vfs.h>

namespace scree {

namespace fs = std::filesystem;

namespace {

std::string reason(int code) { return std::strerror(code); }

// "did you mean bunny.obj?" for a missing file with a similarly named neighbour.
std::string near_file(const std::string& path) {
    std::vector<std::string> names;
    std::error_code code;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(path), code))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end()); // folders are listed in unspecified order
    return did_you_mean(file_name(path), names);
}

const char* kind_in_words(fs::file_type type) {
    switch (type) {
    case fs::file_type::directory:
        return "a folder";
    case fs::file_type::fifo:
        return "a pipe";
    case fs::file_type::socket:
        return "a socket";
    default:
        return "a device";
    }
}

} // namespace

bool is_made_by_the_kernel(const std::string& path) {
    struct statfs system {};
    return statfs(path.c_str(), &system) == 0 &&
           (system.f_type == PROC_SUPER_MAGIC || system.f_type == SYSFS_MAGIC);
}

void check_is_file(const std::string& path) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (!fs::exists(status))
        throw Error(Diagnostic{{}, {}, path + ": no such file", near_file(path)});
    if (!fs::is_regular_file(status))
        throw Error(path + ": is " + kind_in_words(status.type()) + ", not a file");
    if (is_made_by_the_kernel(path))
        throw Error(path + ": is made by the kernel, not a file on a disk");
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

std::string extension(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    if (!ending.empty())
        ending.erase(0, 1);
    return lower_case(ending);
}

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

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
