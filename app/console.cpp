// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"

#include "app/standard_streams.h"
#include "app/terminal_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>

namespace scree {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double bar_interval_s = 0.1;
constexpr double line_interval_s = 5;        // between lines when not on a terminal, or
constexpr double line_interval_growth = 0.2; // this share of the elapsed time if that is more
constexpr int bar_width = 24;

bool shows_true_color() {
    const char* colors = std::getenv("COLORTERM");
    return colors != nullptr &&
           (std::string_view(colors) == "truecolor" || std::string_view(colors) == "24bit");
}

struct TerminalSize {
    int columns, rows;
};

TerminalSize terminal_size() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
        return {80, 24};
    return {size.ws_col, size.ws_row};
}

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

Console::Console(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Console::~Console() { clear(); }

void Console::warn(const std::string& text) {
    ++warnings_;
    Watcher::warn(text);
}

void Console::say(const std::string& line) {
    if (quiet_)
        return;
    clear();
    picture_rows_ = 0;
    tell(line + "\n");
}

void Console::progress(const std::string& what, double fraction, const std::string& detail) {
    if (quiet_)
        return;
    if (what != last_what_) {
        last_what_ = what;
        first_fraction_ = fraction;
        started_ = Clock::now();
        last_shown_ = Clock::now();
        if (!terminal_)
            return; // a short stage needs no line
    } else {
        const double interval =
            terminal_ ? bar_interval_s
                      : std::max(line_interval_s, line_interval_growth * seconds_since(started_));
        if (seconds_since(last_shown_) < interval)
            return;
    }
    last_shown_ = Clock::now();
    fraction = std::clamp(fraction, 0.0, 1.0);
    const double elapsed = seconds_since(started_);
    const double done = fraction - first_fraction_; // a resumed render does not begin at 0
    const std::string left = done > 0.01 && fraction < 1
                                 ? ", " + format_duration(elapsed * (1 - fraction) / done) + " left"
                                 : std::string();
    if (!terminal_) {
        tell(fmt::format("{} {:.0f}%{}{}\n", what, 100 * fraction, detail, left));
        return;
    }
    const int full = static_cast<int>(fraction * bar_width);
    control_terminal("\r\x1b[K");
    tell(fmt::format("{} [{}{}] {:3.0f}%{}{}", what, std::string(full, '#'),
                     std::string(bar_width - full, '.'), 100 * fraction, detail, left));
    bar_shown_ = true;
}

void Console::picture(const Image& shown) {
    if (quiet_ || !terminal_ || !shows_true_color())
        return;
    clear();
    const auto [columns, rows] = terminal_size();
    constexpr int widest = 96; // characters; larger ones scroll slowly
    const TerminalPicture picture = terminal_picture(shown, std::min(columns, widest), rows - 2);
    if (picture_rows_ > 0)
        control_terminal(fmt::format("\x1b[{}A", picture_rows_));
    control_terminal(picture.text);
    picture_rows_ = picture.rows;
}

void Console::clear() {
    if (bar_shown_)
        control_terminal("\r\x1b[K");
    bar_shown_ = false;
}

std::string format_duration(double seconds) {
    if (seconds < 60)
        return fmt::format("{:.1f} s", seconds);
    const long whole = std::lround(seconds);
    if (whole < 3600)
        return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

} // namespace scree
