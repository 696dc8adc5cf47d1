// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "session/watcher.h"

#include <chrono>
#include <string>

namespace scree {

/// Progress on stderr: a bar on a terminal, plain lines otherwise, nothing when quiet.
class Console final : public Watcher {
  public:
    explicit Console(bool quiet);
    ~Console() override;
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    void say(const std::string& line) override;
    void warn(const std::string& text) override;
    void progress(const std::string& what, double fraction, const std::string& detail) override;

    /// Shows a picture (see terminal_picture) where the terminal says that it has 24-bit colours
    /// ($COLORTERM), in place of the one before unless a line was said since.
    void picture(const Image& shown);

    /// Removes the bar.
    void clear();

    /// How many warnings there were so far.
    std::size_t warnings() const { return warnings_; }

  private:
    bool quiet_;
    std::size_t warnings_ = 0;
    bool terminal_;
    bool bar_shown_ = false;
    int picture_rows_ = 0; // of the picture above the cursor, if any
    std::string last_what_;
    double first_fraction_ = 0;
    std::chrono::steady_clock::time_point last_shown_;
    std::chrono::steady_clock::time_point started_;
};

/// "1.2 s", "3 min 20 s".
std::string format_duration(double seconds);

} // namespace scree
