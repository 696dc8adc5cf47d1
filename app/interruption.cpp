// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interruption.h"

#include "core/temporary_file.h"

#include <csignal>
#include <ctime>
#include <poll.h>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace scree {

namespace {

constexpr timespec moment{0, 20'000'000};
constexpr int most_moments = 15; // that computations which do not check are given

std::atomic<int> last_signal = 0;

Cancel& requested_by_signals() {
    static Cancel cancel;
    return cancel;
}

// Another thread may be waiting for a full stderr, and holds its lock then.
[[noreturn]] void end_at_once() {
    abandon_temporary_files();
    constexpr std::string_view text = "cancelled\n";
    pollfd err{STDERR_FILENO, POLLOUT, 0};
    if (poll(&err, 1, 0) > 0)
        static_cast<void>(!write(STDERR_FILENO, text.data(), text.size()));
    _exit(interrupted_exit_code());
}

// The first signal asks, a second one insists.
[[noreturn]] void watch(const sigset_t& signals) {
    int signal = 0;
    while (sigwait(&signals, &signal) != 0) {
    }
    last_signal = signal;
    requested_by_signals().request();
    int moments = 0; // in which nobody kept this waiting
    while (moments < most_moments && sigtimedwait(&signals, nullptr, &moment) < 0)
        moments = requested_by_signals().is_kept_waiting() ? 0 : moments + 1;
    end_at_once();
}

} // namespace

void heed_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
            sigaddset(&signals, signal);
    }
    // Threads inherit the mask, so that only the one that waits takes these signals.
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::thread([signals] { watch(signals); }).detach();
    for (const int signal : {SIGPIPE, SIGXFSZ})
        std::signal(signal, SIG_IGN);
}

const Cancel& interruption() { return requested_by_signals(); }

int interrupted_exit_code() {
    const int signal = last_signal;
    return 128 + (signal != 0 ? signal : SIGINT);
}

} // namespace scree
