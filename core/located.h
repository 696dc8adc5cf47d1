// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree {

/// What `make` returns. Input errors that it throws are located at `place`, as far as they have no
/// place of their own; errors of other kinds, such as running out of memory, keep their kind and
/// text.
template <class Make>
auto located(const ParamPlace& place, const Make& make) {
    try {
        return make();
    } catch (const Error& error) {
        if (error.fault() != Fault::input)
            throw;
        throw error.located(place.where, place.path);
    }
}

/// The same, located at the parameter `name`.
template <class Make>
auto located(const Params& params, const std::string& name, const Make& make) {
    return located(params.place(name), make);
}

/// The same, located at the table of the parameters.
template <class Make>
auto located(const Params& params, const Make& make) {
    return located(ParamPlace{params.where(), params.path()}, make);
}

} // namespace scree
