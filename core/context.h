// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/progress.h"

namespace scree {

class Device;

/// What a long computation is given beside its own parameters. The seed is not here: it is a
/// parameter of each generator.
struct Context {
    Device* device = nullptr;       // null: kernels run as C++ on the host
    const Cancel* cancel = nullptr; // null: cannot be cancelled
    Progress progress{};            // empty: not reported

    void check_cancel() const {
        if (cancel != nullptr)
            cancel->check();
    }
    void report(std::string_view what, double fraction) const {
        if (progress)
            progress(what, fraction);
    }
};

} // namespace scree
