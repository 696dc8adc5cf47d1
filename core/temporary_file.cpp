// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/temporary_file.h"

#include "core/file.h"

#include <cerrno>
#include <climits>
#include <fcntl.h>
#include <mutex>
#include <random>
#include <set>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace scree {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t key_length = 12;
constexpr std::string_view key_letters = "abcdefghijklmnopqrstuvwxyz234567";

/// Those of this program. Making, renaming and removing hold the lock.
struct LiveFiles {
    std::mutex lock;
    std::set<std::string> paths;
};

LiveFiles& live_files() {
    static LiveFiles files;
    return files;
}

/// The names of the temporary files of one target: the key is between.
struct Names {
    std::string front, back;

    explicit Names(const fs::path& target) {
        constexpr std::string_view mark = ".part-";
        const std::string ending = target.extension().string();
        back = ending.size() <= 16 ? ending : ""; // no format has a longer one
        const std::string name = target.filename().string();
        const std::size_t room = NAME_MAX - 1 - mark.size() - key_length - back.size();
        front = "." + name.substr(0, room) + std::string(mark);
    }

    std::string with(std::string_view key) const { return front + std::string(key) + back; }

    bool are_those_of(std::string_view name) const {
        if (name.size() != front.size() + key_length + back.size() || !name.starts_with(front) ||
            !name.ends_with(back))
            return false;
        const std::string_view key = name.substr(front.size(), key_length);
        return key.find_first_not_of(key_letters) == std::string_view::npos;
    }
};

std::string random_key() {
    std::random_device entropy;
    std::string key;
    while (key.size() < key_length)
        key += key_letters[entropy() % key_letters.size()];
    return key;
}

// A file that nobody has locked belongs to no live program. File systems without locks keep all.
void remove_left_overs(const fs::path& folder, const Names& names) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        if (!names.are_those_of(entry.path().filename().string()))
            continue;
        const int descriptor =
            open(entry.path().c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0)
            continue;
        if (flock(descriptor, LOCK_EX | LOCK_NB) == 0)
            fs::remove(entry.path(), ignored);
        close(descriptor);
    }
}

// Another program that cleans up may see the file before it is locked, and take it away.
bool is_locked_in_place(int descriptor) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0)
        return errno != EWOULDBLOCK;
    struct stat status {};
    return fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

} // namespace

TemporaryFile::TemporaryFile(const fs::path& target) {
    const fs::path folder = folder_of(target.string());
    const Names names(target);
    LiveFiles& live = live_files();
    const std::lock_guard hold(live.lock);
    remove_left_overs(folder, names);
    while (descriptor_ < 0) {
        path_ = (folder / names.with(random_key())).string();
        descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST)
            throw fs::filesystem_error("open", path_, {errno, std::generic_category()});
        if (descriptor_ >= 0 && !is_locked_in_place(descriptor_)) {
            close(descriptor_);
            descriptor_ = -1;
        }
    }
    live.paths.insert(path_);
}

TemporaryFile::~TemporaryFile() {
    LiveFiles& live = live_files();
    const std::lock_guard hold(live.lock);
    if (live.paths.erase(path_) > 0)
        unlink(path_.c_str());
    close(descriptor_);
}

void TemporaryFile::become(const fs::path& target) {
    struct stat old {};
    if (stat(target.c_str(), &old) == 0)
        static_cast<void>(fchmod(descriptor_, old.st_mode & 0777)); // not every system has them
    LiveFiles& live = live_files();
    const std::lock_guard hold(live.lock);
    fs::rename(path_, target);
    live.paths.erase(path_);
}

void abandon_temporary_files() noexcept {
    LiveFiles& live = live_files();
    live.lock.lock(); // and never unlocked
    for (const std::string& path : live.paths)
        unlink(path.c_str());
}

} // namespace scree
