// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/muted_stderr.h"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace scree {

namespace {

std::mutex& mutex() {
    static std::mutex shared;
    return shared;
}

} // namespace

MutedStderr::MutedStderr()
    : alone_(mutex()), kept_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)) {
    const int nowhere = kept_ < 0 ? -1 : ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0)
        return;
    std::fflush(stderr);
    ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
}

MutedStderr::~MutedStderr() {
    if (kept_ < 0)
        return;
    std::fflush(stderr);
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
}

} // namespace scree
