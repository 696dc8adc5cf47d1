// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture_output.h"

#include "core/error.h"

namespace scree {

void check_picture_output(const std::string& path) {
    if (extension(path) != "exr")
        throw Error::usage(path + ": expected a name that ends in .exr",
                           "the PNG to look at is written beside it");
    check_writable(path);
}

std::string beside(const std::string& exr, const std::string& ending) {
    return exr.substr(0, exr.size() - 3) + ending;
}

} // namespace scree
