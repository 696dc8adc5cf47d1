// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"

#include <functional>
#include <stdexcept>

namespace scree {

/// One plug-in: its name, its parameters and the function that makes its object.
template <class Make>
struct Plugin {
    std::string name; // "layout"
    std::string doc;  // one sentence
    std::vector<ParamSpec> params;
    std::function<Make> make;
};

/// Plug-ins by name, in the order in which they were added. A duplicate name is an error.
template <class Make>
class Registry {
  public:
    explicit Registry(std::string family) : family_(std::move(family)) {}

    void add(Plugin<Make> plugin) {
        if (find(plugin.name) != nullptr)
            throw std::logic_error(family_ + "." + plugin.name + " is registered twice");
        plugins_.push_back(std::move(plugin));
    }

    const Plugin<Make>* find(std::string_view name) const {
        for (const Plugin<Make>& plugin : plugins_)
            if (plugin.name == name)
                return &plugin;
        return nullptr;
    }

    const std::string& family() const { return family_; } // "generator"
    const std::vector<Plugin<Make>>& plugins() const { return plugins_; }

  private:
    std::string family_;
    std::vector<Plugin<Make>> plugins_;
};

} // namespace scree
