// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree {

/// What `make` returns; what it throws is located at the parameter that it comes from.
template <class Make>
auto located(const Params& params, const std::string& name, const Make& make) {
    try {
        return make();
    } catch (const Error& error) {
        const Diagnostic& first = error.diagnostics().front();
        throw params.error(name, first.message, first.hint);
    }
}

} // namespace scree
