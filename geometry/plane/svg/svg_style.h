// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region_tools.h"
#include "geometry/plane/svg/css_sheet.h"

#include <optional>
#include <unordered_map>

namespace scree {

/// What an element has of the properties that decide what is filled; the children inherit it.
struct SvgStyle {
    CssProperties custom;      // --name
    double font_size = 16;     // [pixels]; not a number where it cannot be told
    double color_alpha = 1;    // of `color`
    double fill_alpha = 1;     // of `fill`; 0 for none
    bool fill_current = false; // `fill` is currentColor
    std::string fill_unread;   // why `fill` is not read; empty where it is
    double fill_opacity = 1;
    bool stroked = false; // there is a stroke that can be seen
    FillRule fill_rule = FillRule::nonzero;
    FillRule clip_rule = FillRule::nonzero;
    bool visible = true;
    double opacity = 1; // of the element and all around it

    bool fills() const {
        return visible && opacity * fill_opacity * (fill_current ? color_alpha : fill_alpha) > 0;
    }
};

/// The properties that an element itself declares, in style sheets, its attribute `style` or as
/// presentation attributes, the first of these that it has.
class SvgProperties {
  public:
    SvgProperties(const SvgNode& node, CssProperties declared, const CssProperties& custom);

    /// The value with var() replaced; none when it is not declared or is to be inherited. `initial`
    /// gives that value. Throws Error naming the property.
    std::optional<std::string> get(const std::string& name, const std::string& initial) const;

    /// The same in lower case, `otherwise` for none.
    std::string keyword(const std::string& name, const std::string& initial) const;

    /// Declared in style sheets or the attribute `style`, and not as an attribute of its own.
    std::optional<std::string> css(const std::string& name) const;

    const CssProperties& custom() const { return custom_; } // with the inherited ones

  private:
    std::string resolved(const std::string& name, std::string value, int depth = 0) const;

    const SvgNode& node_;
    CssProperties declared_;
    CssProperties custom_;
};

/// Computes styles. All throw Error naming the line.
class SvgStyles {
  public:
    /// Collects the document's style sheets and ids; `root` must outlive this.
    explicit SvgStyles(const SvgNode& root);

    SvgProperties properties(const SvgNode& node, const SvgStyle& outer) const;

    /// The style of an element inside one of the style `outer`.
    SvgStyle computed(const SvgNode& node, const SvgProperties& properties,
                      const SvgStyle& outer) const;

    /// The element with an id, or null.
    const SvgNode* find(const std::string& id) const;
    std::vector<std::string> ids() const;

  private:
    struct Paint {
        double alpha = 1;
        bool current = false;
    };
    Paint paint(const std::string& value) const;
    double gradient_alpha(const SvgNode& gradient, int depth) const;
    double color_of(const SvgNode& node) const;

    CssSheet sheet_;
    std::unordered_map<std::string, const SvgNode*> by_id_;
    std::vector<std::string> ids_;
};

} // namespace scree
