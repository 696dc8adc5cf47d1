// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"

namespace scree {

/// Makes the object of a constructor in a script from its checked parameters.
using MakeObject = SharedObject(const Params& params);

/// All constructors that a scene script can call, by family: "mesh", "generator", ... A new kind of
/// value is a new family. Plug-ins may be added until a script is read.
class Catalog {
  public:
    /// Adds the plug-ins of a table to its family. They make values of type T, or shared pointers
    /// to const T.
    template <class T>
    void add(const Registry<T(const Params& params)>& table) {
        Registry<MakeObject>& family = this->family(table.family());
        for (const auto& plugin : table.plugins())
            family.add(
                {plugin.name, plugin.doc, plugin.params,
                 [make = plugin.make](const Params& params) { return shared(make(params)); }});
    }

    /// The family of this name, created when it does not exist.
    Registry<MakeObject>& family(const std::string& name) {
        for (Registry<MakeObject>& known : families_)
            if (known.family() == name)
                return known;
        return families_.emplace_back(name);
    }

    const Registry<MakeObject>* find(std::string_view name) const {
        for (const Registry<MakeObject>& known : families_)
            if (known.family() == name)
                return &known;
        return nullptr;
    }

    /// The families whose members scripts write as "mesh.banana". A family with a member of its own
    /// name, such as `object`, is not among them.
    std::vector<std::string> constructor_families() const {
        std::vector<std::string> names;
        for (const Registry<MakeObject>& known : families_)
            if (known.find(known.family()) == nullptr)
                names.push_back(known.family());
        return names;
    }

    /// In the order in which they were added.
    const std::vector<Registry<MakeObject>>& families() const { return families_; }

  private:
    template <class T>
    static SharedObject shared(T value) {
        return std::make_shared<const T>(std::move(value));
    }
    template <class T>
    static SharedObject shared(std::shared_ptr<const T> object) {
        return object;
    }

    std::vector<Registry<MakeObject>> families_;
};

} // namespace scree
