// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/isotropic_cells.h"

namespace scree {

IsotropicCells::IsotropicCells(const CellGrid& grid, bool torus)
    : grid_(grid), torus_(torus), stride_(std::uint32_t(grid.columns + 2 * margin)) {
    const std::size_t all = std::size_t(stride_) * std::size_t(grid_.rows + 2 * margin);
    time_.assign(all, never);
    sample_.resize(all);
    has_sample_.assign(all / 8 + 9, 0); // a word may be read from any byte
    if (torus) {
        has_images_.assign(all, true);
        for (int row = margin; row < grid_.rows - margin; ++row)
            for (int column = margin; column < grid_.columns - margin; ++column)
                has_images_[index(column, row)] = false;
    }
    std::size_t k = 0;
    for (int row = -margin; row <= margin; ++row)
        for (int column = -margin; column <= margin; ++column, ++k) {
            shift_[k] = Vec2(column, row) * grid_.cell;
            offset_[k] = std::uint32_t(row) * stride_ + std::uint32_t(column);
        }
}

} // namespace scree
