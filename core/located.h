// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

namespace scree {

/// Where a parameter was written, for settings that outlive their Params: mistakes in its value may
/// be found only later.
struct ParamPlace {
    Location where;
    std::string path; // "generator.pile.target"
};

inline ParamPlace place_of(const Params& params, const std::string& name) {
    return {params.where(name), params.path() + "." + name};
}

/// What `make` returns; the user's mistakes that it throws are located at the parameter that they
/// come from, as far as they have no place of their own. Errors of other kinds, such as a full
/// memory, stay what they are.
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

/// The same, for one of the parameters.
template <class Make>
auto located(const Params& params, const std::string& name, const Make& make) {
    return located(place_of(params, name), make);
}

/// The same, located at the table of the parameters.
template <class Make>
auto located(const Params& params, const Make& make) {
    return located(ParamPlace{params.where(), params.path()}, make);
}

} // namespace scree
