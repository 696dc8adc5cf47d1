// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/standard_streams.h"

#include "core/error.h"
#include "core/utf8.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace scree {

namespace {

[[noreturn]] void fail() {
    const int code = errno != 0 ? errno : EIO;
    throw Error::resource(std::string("cannot write to stdout: ") + std::strerror(code));
}

} // namespace

void fill_closed_streams() noexcept {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) // the lowest free number is this one
            static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

void control_terminal(std::string_view text) noexcept {
    std::fwrite(text.data(), 1, text.size(), stderr); // not buffered
}

void tell(std::string_view text) noexcept {
    try {
        control_terminal(visible(text));
    } catch (const std::exception&) { // out of memory
        control_terminal(text);
    }
}

void print_result(std::string_view text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        fail();
}

void finish_results() {
    errno = 0;
    if (std::fflush(stdout) != 0)
        fail();
}

} // namespace scree
