// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/svg/svg_document.h"
#include "geometry/plane/svg/svg_viewport.h"

namespace scree {

/// Goes through a drawing's elements and collects what they fill.
class SvgDrawer {
  public:
    /// `root` must outlive this.
    explicit SvgDrawer(const SvgNode& root) : root_(root), styles_(root) {}

    /// All, or the element with the id. Throws Error naming the line.
    SvgDrawing drawn(const std::string& id, const Warn& warn);

  private:
    /// What a walk is for: shapes that are filled, the shapes of a clip, or a bounding box.
    enum class Purpose { fill, clip, measure };

    /// What an element is drawn in.
    struct Place {
        Affine pixel_from_user;
        SvgStyle style;
        Vec2 viewport{0.0}; // of the nearest svg, in its units; 0: not known
        std::vector<std::size_t> within;
        Purpose purpose = Purpose::fill;

        SvgLengths lengths() const { return {viewport, style.font_size}; }
    };

    /// Something left out of the drawing, of which the first is told.
    struct LeftOut {
        const SvgNode* first = nullptr;
        std::size_t count = 0;

        void add(const SvgNode& node) { first = count++ == 0 ? &node : first; }
    };

    void draw(const SvgNode& node, const Place& outer, const SvgProperties* use = nullptr);
    void draw_content(const SvgNode& node, const SvgProperties& properties, const Place& place);
    void draw_children(const SvgNode& node, const Place& place);
    void draw_use(const SvgNode& node, const SvgProperties& properties, Place place);
    void draw_shape(const SvgNode& node, const SvgProperties& properties, const Place& place);
    bool enter_viewport(const SvgNode& node, const SvgProperties& properties,
                        const SvgProperties* use, Place& place);

    /// The place inside the element: its style, transform and clip are applied.
    Place inside(const SvgNode& node, const SvgProperties& properties, const Place& outer);
    Affine transform(const SvgNode& node, const SvgProperties& properties, const Place& place);
    /// The bounds of the element's geometry in its own units.
    Box2 object_box(const SvgNode& node, const SvgProperties& properties, const Place& place);

    void clip(const SvgNode& node, const SvgProperties& properties, Place& place);
    std::size_t clip_of(const SvgNode& clip_path, const Place& clipped, const Box2* box);
    std::size_t add_clip(std::vector<SvgShape> shapes);
    /// The style that an element inherits from those around it.
    SvgStyle style_around(const SvgNode& node) const;

    void note_left_out(const SvgNode& node, const SvgProperties& properties, const Place& place,
                       const BezierPath& path);
    void tell(const Warn& warn) const;

    const SvgNode& root_;
    SvgStyles styles_;
    std::vector<SvgShape>* out_ = nullptr; // where shapes go
    SvgDrawing drawing_;
    std::vector<const SvgNode*> open_; // elements that refer to others, from the outermost
    std::size_t elements_ = 0;
    Box2 page_; // [pixels]; empty: not known
    LeftOut strokes_, markers_, filters_, beyond_;
};

} // namespace scree
