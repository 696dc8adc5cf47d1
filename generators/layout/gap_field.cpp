// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/gap_field.h"

#include "generators/layout/gap_field_as_cpp.h"
#include "generators/layout/gap_field_source.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

using std::size_t;

/// Calls visit(index) for the pixels whose centres lie in the rings (even-odd).
template <class Visit>
void for_each_pixel_inside(const std::vector<Ring>& rings, const Vec2& origin, double pixel,
                           int width, int height, const Visit& visit) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Ring& ring : rings) {
        for (const Vec2& v : ring) {
            low = std::min(low, v.y);
            high = std::max(high, v.y);
        }
    }
    const int first = std::max(0, static_cast<int>(std::floor((low - origin.y) / pixel)) - 1);
    const int last =
        std::min(height - 1, static_cast<int>(std::ceil((high - origin.y) / pixel)) + 1);
    std::vector<double> crossings;
    for (int y = first; y <= last; ++y) {
        const double level = origin.y + (y + 0.5) * pixel;
        crossings.clear();
        for (const Ring& ring : rings)
            for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
                if ((ring[j].y > level) != (ring[i].y > level))
                    crossings.push_back(ring[j].x + (level - ring[j].y) / (ring[i].y - ring[j].y) *
                                                        (ring[i].x - ring[j].x));
        std::sort(crossings.begin(), crossings.end());
        for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const double from = std::ceil((crossings[i] - origin.x) / pixel - 0.5);
            const double to = std::ceil((crossings[i + 1] - origin.x) / pixel - 0.5);
            for (int x = std::max(0, static_cast<int>(from));
                 x < std::min(width, static_cast<int>(to)); ++x)
                visit(size_t(y) * size_t(width) + size_t(x));
        }
    }
}

} // namespace

struct GapField::Buffers {
    Device::BufferHandle state, column_distance, stack_column, stack_start, squared, row_maximum,
        marks;
};

GapField::GapField(const DomainTest& domain, int resolution, Device* device) : device_(device) {
    const Vec2 size = domain.box().size();
    pixel_ = std::max(size.x, size.y) / resolution;
    // One more pixel on each side, so that distances to the domain's border are measured. Around a
    // torus lies a quarter of its images on each side, which is wider than any gap once the torus
    // is sparsely filled.
    const Vec2 border = domain.is_torus() ? size / pixel_ / 4.0 : Vec2(1);
    const auto pixels_for = [](double length, double more) {
        return static_cast<int>(std::ceil(length - 1e-9)) + 2 * static_cast<int>(std::ceil(more));
    };
    width_ = pixels_for(size.x / pixel_, border.x);
    height_ = pixels_for(size.y / pixel_, border.y);
    if (domain.is_torus())
        period_ = size;
    origin_ = domain.box().center() - Vec2(width_, height_) * (pixel_ / 2);
    const bool whole = domain.inside() == Inside::whole;
    const size_t pixels = size_t(width_) * size_t(height_);
    state_.assign(pixels, whole ? SCREE_OCCUPIED | SCREE_EXCLUDED : SCREE_EXCLUDED);
    for_each_pixel_inside(domain.region().rings, origin_, pixel_, width_, height_,
                          [&](size_t i) { state_[i] = 0; });
    marks_.resize(pixels);
    squared_.resize(pixels);
    row_maximum_.resize(size_t(height_));
}

GapField::~GapField() = default;

void GapField::occupy(const Region& outline, const FigurePose& pose) {
    changed_ = true;
    for (int y = period_ ? -1 : 0; y <= (period_ ? 1 : 0); ++y) {
        for (int x = period_ ? -1 : 0; x <= (period_ ? 1 : 0); ++x) {
            std::vector<Ring> rings = outline.rings;
            for (Ring& ring : rings)
                for (Vec2& v : ring)
                    v = pose.apply(v) + (period_ ? *period_ * Vec2(x, y) : Vec2(0));
            for_each_pixel_inside(rings, origin_, pixel_, width_, height_,
                                  [&](size_t i) { state_[i] |= SCREE_OCCUPIED | SCREE_EXCLUDED; });
        }
    }
}

void GapField::update_on_device() {
    const size_t pixels = state_.size();
    if (!buffers_) {
        buffers_ = std::make_unique<Buffers>();
        for (auto* buffer : {&buffers_->column_distance, &buffers_->stack_column,
                             &buffers_->stack_start, &buffers_->squared})
            *buffer = device_->allocate(pixels * 4);
        buffers_->state = device_->allocate(pixels);
        buffers_->marks = device_->allocate(pixels);
        buffers_->row_maximum = device_->allocate(size_t(height_) * 4);
    }
    const Buffers& b = *buffers_;
    device_->write(b.state, state_.data(), pixels);
    const size_t columns = size_t(width_), rows = size_t(height_);
    const Device::Argument column_arguments[] = {b.state, width_, height_, b.column_distance};
    device_->run(gap_field_source, "scree_column_distance", {&columns, 1}, column_arguments);
    const Device::Argument row_arguments[] = {b.state,        b.column_distance, width_,
                                              b.stack_column, b.stack_start,     b.squared,
                                              b.row_maximum};
    device_->run(gap_field_source, "scree_row_distance", {&rows, 1}, row_arguments);
    device_->read(b.row_maximum, row_maximum_.data(), rows * 4);
}

void GapField::update_on_host() {
    std::vector<int> column_distance(state_.size()), stack_column(state_.size()),
        stack_start(state_.size());
    kernel_as_cpp::for_each_work_item(size_t(width_), [&] {
        gap_field::scree_column_distance(state_.data(), width_, height_, column_distance.data());
    });
    kernel_as_cpp::for_each_work_item(size_t(height_), [&] {
        gap_field::scree_row_distance(state_.data(), column_distance.data(), width_,
                                      stack_column.data(), stack_start.data(), squared_.data(),
                                      row_maximum_.data());
    });
}

std::vector<Vec2> GapField::candidates(std::uint32_t exponent, std::uint64_t seed,
                                       std::uint64_t round) {
    if (changed_ && device_ != nullptr)
        update_on_device();
    else if (changed_)
        update_on_host();
    changed_ = false;
    const std::uint32_t maximum = *std::max_element(row_maximum_.begin(), row_maximum_.end());
    std::vector<Vec2> points;
    if (maximum == 0)
        return points;
    const size_t pixels = state_.size();
    const std::uint64_t first = round * pixels;
    if (device_ != nullptr) {
        const Device::Argument arguments[] = {
            buffers_->state, buffers_->squared, maximum, exponent, seed, first, buffers_->marks};
        device_->run(gap_field_source, "scree_candidates", {&pixels, 1}, arguments);
        device_->read(buffers_->marks, marks_.data(), pixels);
    } else {
        kernel_as_cpp::for_each_work_item(pixels, [&] {
            gap_field::scree_candidates(state_.data(), squared_.data(), maximum, exponent, seed,
                                        first, marks_.data());
        });
    }
    for (size_t i = 0; i < pixels; ++i) {
        if (marks_[i] == 0)
            continue;
        // The first number of this stream chose the pixel; the next two give the place in it.
        Random random(seed, Purpose::layout_candidate, first + i);
        random.bits();
        const double u = random.uniform_float() - 0.5, v = random.uniform_float() - 0.5;
        const int x = static_cast<int>(i % size_t(width_)),
                  y = static_cast<int>(i / size_t(width_));
        points.push_back(pixel_centre(x, y) + Vec2(u, v) * pixel_);
    }
    return points;
}

const std::vector<std::uint32_t>& GapField::squared_distance() const {
    if (buffers_)
        device_->read(buffers_->squared, squared_.data(), squared_.size() * 4);
    return squared_;
}

} // namespace scree
