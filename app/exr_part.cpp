// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exr_part.h"

#include "core/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scree {

namespace {

std::vector<std::string> names_of(const ExrFile& file) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < file.parts.size(); ++i)
        names.push_back(file.parts[i].name.empty() ? fmt::format("part {}", i + 1)
                                                   : file.parts[i].name);
    return names;
}

} // namespace

const ImagePart& named_part(const ExrFile& file, const std::string& path, const std::string& name) {
    const std::vector<std::string> names = names_of(file);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name)
            return file.parts[i];
    throw Error(Diagnostic{
        {},
        {},
        fmt::format("{}: has no part {}; there are: {}", path, name, fmt::join(names, ", ")),
        did_you_mean(name, names)});
}

std::string part_names(const ExrFile& file) {
    return fmt::format("{}", fmt::join(names_of(file), ", "));
}

} // namespace scree
