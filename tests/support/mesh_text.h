// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of mesh files make of given bytes: for tables of tests.
#pragma once

#include "core/error.h"
#include "formats/read_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

namespace scree::tests {

/// The surface area of a file's mesh; `name` ends as its format does.
inline double file_area(const std::string& name, std::string_view bytes) {
    return area(read_mesh_bytes(name, bytes));
}

/// "2 triangles", followed by the warnings, each after "; ".
inline std::string file_facts(const std::string& name, std::string_view bytes) {
    const FileMesh mesh = read_file_mesh_bytes(name, bytes);
    std::string out = fmt::format("{} triangles", mesh.triangles.size());
    for (const std::string& warning : mesh.warnings)
        out += "; " + warning;
    return out;
}

/// The error of a file, or "no error".
inline std::string file_problem(const std::string& name, std::string_view bytes) {
    try {
        read_mesh_bytes(name, bytes);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

} // namespace scree::tests
