// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace scree {

/// An empty file beside `target`, with a hidden and unpredictable name that begins as that of
/// `target` does and has its extension, by which libraries choose the format. It is removed with
/// this object unless it has become the target. Those that killed programs left beside the same
/// target are removed first. Throws std::filesystem::filesystem_error.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::filesystem::path& target);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    const std::string& path() const { return path_; }

    /// Renames it to `target`, whose permissions it takes on when there is one.
    void become(const std::filesystem::path& target);

  private:
    std::string path_;
    int descriptor_ = -1; // locked: a live program's file
};

/// Removes all temporary files for good: none becomes its target any more, and none can be made.
/// For a program that is about to end without unwinding; any thread may call it.
void abandon_temporary_files() noexcept;

} // namespace scree
