// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/object_option.h"

#include <fmt/format.h>

#include <charconv>

namespace scree {

int chosen_object(const std::string& given, const std::string& scene, const SceneDraft& draft) {
    std::vector<std::string> names;
    int found = 0;
    for (std::size_t i = 0; i < draft.items.size(); ++i) {
        const std::string& name = draft.items[i]->name;
        if (name.empty())
            continue;
        names.push_back(name);
        if (name != given)
            continue;
        if (found > 0)
            throw Error::usage(fmt::format("--object {}: the objects {} and {} have this name",
                                           given, found, i + 1),
                               "choose one by its number");
        found = static_cast<int>(i) + 1;
    }
    if (found > 0)
        return found;
    int number = 0;
    const auto [end, code] = std::from_chars(given.data(), given.data() + given.size(), number);
    const bool is_number = code == std::errc() && end == given.data() + given.size();
    if (is_number && number >= 1 && std::size_t(number) <= draft.items.size())
        return number;
    throw Error::usage(fmt::format("--object {}: expected the name of an object of {}, or a number "
                                   "from 1 to {}",
                                   given, scene, draft.items.size()),
                       did_you_mean(given, names));
}

void make_only(int object, SceneDraft& draft) {
    const auto nothing = std::make_shared<const SceneItem>(
        SceneItem{"object", [](const Context&, std::uint64_t) { return Aggregate{}; }});
    for (std::size_t i = 0; i < draft.items.size(); ++i)
        if (i + 1 != std::size_t(object))
            draft.items[i] = nothing;
}

} // namespace scree
