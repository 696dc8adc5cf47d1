// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/bezier_path.h"

#include <algorithm>

namespace scree {

void BezierPath::move_to(const Vec2& to) {
    current_ = to;
    subpaths_.push_back({to, {}});
    open_ = true;
}

void BezierPath::line_to(const Vec2& to) {
    cubic_to(current_ + (to - current_) / 3, to + (current_ - to) / 3, to);
}

void BezierPath::quadratic_to(const Vec2& control, const Vec2& to) {
    cubic_to(current_ + (control - current_) * (2.0 / 3), to + (control - to) * (2.0 / 3), to);
}

void BezierPath::cubic_to(const Vec2& control1, const Vec2& control2, const Vec2& to) {
    if (!open_)
        move_to(current_);
    subpaths_.back().cubics.push_back({control1, control2, to});
    current_ = to;
}

void BezierPath::arc_to(Vec2 radii, double turn, bool large, bool clockwise, const Vec2& to) {
    radii = {std::abs(radii.x), std::abs(radii.y)};
    if (to == current_)
        return;
    if (radii.x == 0 || radii.y == 0)
        return line_to(to);
    // In the frame where the ellipse is the unit circle (F.6.5; F.6.6 for radii too small).
    const auto to_circle = [&](const Vec2& v) { return rotate(v, -turn) / radii; };
    Vec2 half = to_circle((current_ - to) / 2);
    const double length = half.length();
    if (length > 1) {
        radii *= length;
        half /= length;
    }
    const double distance = std::sqrt(std::max(0.0, 1 - half.length2()));
    const double side = large == clockwise ? -1 : 1;
    const Vec2 across = length > 0 ? Vec2(half.y, -half.x) / half.length() : Vec2(0.0);
    const Vec2 centre = across * (side * distance); // from the middle of the chord
    const Vec2 first = half - centre;
    const Vec2 last = -half - centre;
    double sweep = std::atan2(cross(first, last), first.dot(last));
    if (clockwise && sweep < 0)
        sweep += 2 * pi;
    else if (!clockwise && sweep > 0)
        sweep -= 2 * pi;
    const auto from_circle = [&](const Vec2& v) { return rotate(v * radii, turn); };
    const Vec2 middle = (current_ + to) / 2 + from_circle(centre);
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (pi / 4) - 1e-9)));
    const double step = sweep / pieces;
    const double handle = 4.0 / 3 * std::tan(step / 4);
    for (int i = 0; i < pieces; ++i) {
        const Vec2 a = rotate(first, step * i);
        const Vec2 b = rotate(first, step * (i + 1));
        const Vec2 end = i + 1 == pieces ? to : middle + from_circle(b);
        cubic_to(middle + from_circle(a + Vec2(-a.y, a.x) * handle),
                 middle + from_circle(b - Vec2(-b.y, b.x) * handle), end);
    }
}

void BezierPath::close() {
    if (!subpaths_.empty())
        current_ = subpaths_.back().start;
    open_ = false;
}

void BezierPath::transform(const Affine& matrix) {
    const auto apply = [&](Vec2& v) { v = v * matrix; };
    for (Subpath& subpath : subpaths_) {
        apply(subpath.start);
        for (Cubic& cubic : subpath.cubics) {
            apply(cubic.control1);
            apply(cubic.control2);
            apply(cubic.to);
        }
    }
    apply(current_);
}

void BezierPath::append(const BezierPath& other) {
    subpaths_.insert(subpaths_.end(), other.subpaths_.begin(), other.subpaths_.end());
    current_ = other.current_;
    open_ = other.open_;
}

std::vector<Ring> BezierPath::flatten(double tolerance, std::size_t& points,
                                      std::size_t most) const {
    std::vector<Ring> rings;
    for (const Subpath& subpath : subpaths_) {
        Ring ring{subpath.start};
        for (const Cubic& cubic : subpath.cubics) {
            const Vec2 from = ring.back();
            // The chords of n equal steps of the parameter are no farther off than 6 L / (8 n^2),
            // L the longest second difference (Wang 1984; Goldman 2003, on flattening).
            const double bend = std::max((from - cubic.control1 * 2 + cubic.control2).length(),
                                         (cubic.control1 - cubic.control2 * 2 + cubic.to).length());
            const double pieces = std::ceil(std::sqrt(0.75 * bend / tolerance) - 1e-6);
            const int count = static_cast<int>(std::clamp(pieces, 1.0, 1e6));
            points += static_cast<std::size_t>(count);
            if (points > most)
                return rings;
            for (int i = 1; i < count; ++i) {
                const double t = double(i) / count, s = 1 - t;
                ring.push_back(from * (s * s * s) + cubic.control1 * (3 * s * s * t) +
                               cubic.control2 * (3 * s * t * t) + cubic.to * (t * t * t));
            }
            ring.push_back(cubic.to);
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

Box2 BezierPath::control_box() const {
    Box2 box;
    for (const Subpath& subpath : subpaths_) {
        box.extendBy(subpath.start);
        for (const Cubic& cubic : subpath.cubics) {
            box.extendBy(cubic.control1);
            box.extendBy(cubic.control2);
            box.extendBy(cubic.to);
        }
    }
    return box;
}

} // namespace scree
