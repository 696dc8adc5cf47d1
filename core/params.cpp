// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/params.h"

#include <cassert>
#include <stdexcept>

namespace scree {

void Params::set(const std::string& name, Value value, Location where) {
    entries_[name] = Entry{std::move(value), std::move(where)};
}

bool Params::has(const std::string& name) const {
    const auto entry = entries_.find(name);
    return entry != entries_.end() && !std::holds_alternative<std::monostate>(entry->second.value);
}

template <class T>
const T& Params::get(const std::string& name) const {
    const auto entry = entries_.find(name);
    const T* value = entry == entries_.end() ? nullptr : std::get_if<T>(&entry->second.value);
    if (value == nullptr)
        throw std::logic_error(path_ + "." + name + ": read with a type it was not declared with");
    return *value;
}

bool Params::flag(const std::string& name) const { return get<bool>(name); }
std::int64_t Params::integer(const std::string& name) const { return get<std::int64_t>(name); }
double Params::number(const std::string& name) const { return get<double>(name); }
const std::string& Params::text(const std::string& name) const { return get<std::string>(name); }
const Vec2& Params::vector2(const std::string& name) const { return get<Vec2>(name); }
const Vec3& Params::vector3(const std::string& name) const { return get<Vec3>(name); }
const Color& Params::color(const std::string& name) const { return get<Color>(name); }
const Texture& Params::texture(const std::string& name) const { return get<Texture>(name); }
const Range& Params::range(const std::string& name) const { return get<Range>(name); }

const std::vector<Vec2>& Params::points(const std::string& name) const {
    return get<std::vector<Vec2>>(name);
}

std::shared_ptr<const Mesh> Params::mesh(const std::string& name) const {
    return get<std::shared_ptr<const Mesh>>(name);
}

std::shared_ptr<const Region> Params::region(const std::string& name) const {
    return get<std::shared_ptr<const Region>>(name);
}

std::shared_ptr<const Field> Params::field(const std::string& name) const {
    return get<std::shared_ptr<const Field>>(name);
}

bool Params::is_mesh(const std::string& name) const {
    const auto entry = entries_.find(name);
    return entry != entries_.end() &&
           std::holds_alternative<std::shared_ptr<const Mesh>>(entry->second.value);
}

MaterialId Params::material(const std::string& name) const { return get<MaterialId>(name); }

const std::vector<Params>& Params::list(const std::string& name) const {
    return *get<std::shared_ptr<const std::vector<Params>>>(name);
}

const Params& Params::record(const std::string& name) const {
    assert(list(name).size() == 1);
    return list(name).front();
}

Location Params::where(const std::string& name) const {
    const auto entry = entries_.find(name);
    return entry == entries_.end() || entry->second.where.line == 0 ? where_ : entry->second.where;
}

Error Params::error(const std::string& name, std::string message, std::string hint) const {
    return Error(Diagnostic{where(name), path_ + "." + name, std::move(message), std::move(hint)});
}

} // namespace scree
