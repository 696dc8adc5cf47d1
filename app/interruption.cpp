// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interruption.h"

#include "app/standard_streams.h"
#include "core/temporary_file.h"

#include <csignal>
#include <ctime>
#include <thread>
#include <unistd.h>

namespace scree {

namespace {

constexpr timespec patience{0, 300'000'000}; // with computations that do not check
constexpr timespec moment{0, 20'000'000};

std::atomic<int> last_signal = 0;

Cancel& requested_by_signals() {
    static Cancel cancel;
    return cancel;
}

[[noreturn]] void end_at_once() {
    abandon_temporary_files();
    tell("cancelled\n");
    _exit(interrupted_exit_code());
}

// The first signal asks, a second one insists.
[[noreturn]] void watch(const sigset_t& signals) {
    int signal = 0;
    while (sigwait(&signals, &signal) != 0) {
    }
    last_signal = signal;
    requested_by_signals().request();
    timespec wait = patience;
    do {
        if (sigtimedwait(&signals, nullptr, &wait) > 0)
            break;
        wait = moment;
    } while (requested_by_signals().is_kept_waiting());
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
