// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace scree {

/// Throws Error (input) when the file is missing, with a neighbour of a similar name as hint, or is
/// a folder, a pipe, a device, or one of /proc and /sys.
void check_is_file(const std::string& path);

/// Whether a file or folder is one of /proc or /sys, which the kernel makes up while it is read: its
/// size says nothing, and it may never end.
bool is_made_by_the_kernel(const std::string& path);

/// The whole file as bytes. Throws Error (input) as check_is_file, and when it is unreadable or
/// larger than `limit` bytes.
std::string read_file(const std::string& path, std::uint64_t limit = std::uint64_t{4} << 30);

/// Lets `write` fill a file under a temporary name in the same folder (see TemporaryFile), syncs it
/// and renames it to `path`, or to what symbolic links there lead to, so that a failed write leaves
/// an old file intact. Pipes and devices are not replaced: they get a copy of the bytes. Throws
/// Error (resource) when that is not possible.
void write_atomically(const std::string& path,
                      const std::function<void(const std::string& temporary_path)>& write);

/// The same for what `write` puts into a binary, seekable stream. `write` need not check the
/// stream's state: it is checked at the end.
void write_stream(const std::string& path, const std::function<void(std::ostream& out)>& write);

/// The same for given bytes.
void write_file(const std::string& path, std::string_view bytes);

/// Throws the Error that write_atomically would throw for this folder: to be called before work
/// that takes hours.
void check_writable(const std::string& path);

/// The extension of the file name in lower case without its dot: "exr"; "" when there is none.
std::string extension(const std::string& path);

/// The last part of the path: "toys.lua".
std::string file_name(const std::string& path);

/// The folder that the path names a file of: "." for a bare name.
std::string folder_of(const std::string& path);

/// `path` itself when absolute, otherwise relative to the folder of `base_file`.
std::string resolve_path(const std::string& path, const std::string& base_file);

/// 64-bit FNV-1a hash (Fowler, Noll & Vo 1991); not cryptographic.
std::uint64_t hash_bytes(std::string_view bytes);

} // namespace scree
