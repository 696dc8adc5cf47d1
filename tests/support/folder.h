// SPDX-License-Identifier: GPL-3.0-or-later
// Folders for the files of a test. Tests run side by side, each in a process of its own, so no two
// may share the path of a file.
#pragma once

#include "core/file.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace scree::test {

/// A new temporary folder, which is removed with all that is in it by the destructor.
class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "scree-test-XXXXXX").string();
        if (!mkdtemp(name.data()))
            throw std::runtime_error("no temporary folder " + name);
        path_ = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    const std::filesystem::path& path() const { return path_; }
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const {
        write_file(file(name), bytes);
        return file(name);
    }

  private:
    std::filesystem::path path_;
};

} // namespace scree::test
