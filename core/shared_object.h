// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <typeinfo>
#include <utility>

namespace scree {

/// What a constructor of a scene script made, such as a mesh: of any one type, shared, never
/// changed afterwards. Equal to another when both are the same object.
class SharedObject {
  public:
    SharedObject() = default;

    template <class T>
    SharedObject(std::shared_ptr<const T> object) // implicit: it is the object
        : type_(object == nullptr ? nullptr : &typeid(T)), object_(std::move(object)) {}

    /// The object, or null when it is of another type or there is none.
    template <class T>
    std::shared_ptr<const T> as() const {
        return type_ != nullptr && *type_ == typeid(T) ? std::static_pointer_cast<const T>(object_)
                                                       : nullptr;
    }

    explicit operator bool() const { return object_ != nullptr; }
    friend bool operator==(const SharedObject& a, const SharedObject& b) {
        return a.object_ == b.object_;
    }

  private:
    const std::type_info* type_ = nullptr;
    std::shared_ptr<const void> object_;
};

} // namespace scree
