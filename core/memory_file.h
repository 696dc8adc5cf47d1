// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace scree {

/// A file in memory, for libraries that read nothing but files. It goes with the object.
class MemoryFile {
  public:
    /// `name`: in messages. Throws Error (resource) when the system has no memory or file left.
    MemoryFile(const std::string& name, std::string_view bytes);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const std::string& path() const { return path_; }

  private:
    int descriptor_;
    std::string path_;
};

} // namespace scree
