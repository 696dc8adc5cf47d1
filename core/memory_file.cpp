// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory_file.h"

#include "core/error.h"

#include <cerrno>
#include <cstring>
#include <sys/mman.h>
#include <unistd.h>

namespace scree {

MemoryFile::MemoryFile(const std::string& name, std::string_view bytes)
    : descriptor_(memfd_create("scree", MFD_CLOEXEC)) {
    const auto failure = [&] {
        return Error::resource(name + ": cannot be held in memory: " + std::strerror(errno));
    };
    if (descriptor_ < 0)
        throw failure();
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0) {
            const Error error = failure();
            ::close(descriptor_);
            throw error;
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    path_ = "/proc/self/fd/" + std::to_string(descriptor_);
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

} // namespace scree
