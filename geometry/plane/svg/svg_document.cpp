// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/svg_document.h"

#include "core/error.h"
#include "core/file.h"
#include "geometry/plane/svg/svg_drawer.h"

namespace scree {

namespace {

constexpr std::uint64_t largest_file = std::uint64_t{64} << 20;

} // namespace

SvgDrawing read_svg_text(const std::string& bytes, const std::string& element, const Warn& warn) {
    const std::unique_ptr<SvgNode> root = parse_svg_tree(bytes);
    return SvgDrawer(*root).drawn(element, warn);
}

SvgDrawing read_svg(const std::string& path, const std::string& element, const Warn& warn) {
    const std::string bytes = read_file(path, largest_file);
    try {
        return read_svg_text(bytes, element,
                             [&](const std::string& message) { warn(path + ": " + message); });
    } catch (const Error& error) {
        const Diagnostic& first = error.diagnostics().front();
        throw Error(Diagnostic{{}, {}, path + ": " + first.message, first.hint});
    }
}

} // namespace scree
