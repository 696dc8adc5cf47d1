// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <typeinfo>
#include <utility>

namespace scree {

/// An immutable, shared object of any type, such as a mesh, made by a constructor of a scene
/// script. Two are equal when they are the same object.
class SharedObject {
  public:
    SharedObject() = default;

    template <class T>
    SharedObject(std::shared_ptr<const T> object) // implicit on purpose
        : type_(object == nullptr ? nullptr : &typeid(T)), object_(std::move(object)) {}

    /// The object, or null when it is empty or its type is not T.
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
