// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree {

/// What `make` returns; the user's mistakes that it throws are located at the parameter that they
/// come from, as far as they have no place of their own. Errors of other kinds, such as a full
/// memory, stay what they are.
template <class Make>
auto located(const Params& params, const std::string& name, const Make& make) {
    try {
        return make();
    } catch (const Error& error) {
        if (error.fault() != Fault::input)
            throw;
        throw error.located(params.where(name), params.path() + "." + name);
    }
}

/// The same, located at the table of the parameters.
template <class Make>
auto located(const Params& params, const Make& make) {
    try {
        return make();
    } catch (const Error& error) {
        if (error.fault() != Fault::input)
            throw;
        throw error.located(params.where(), params.path());
    }
}

} // namespace scree
