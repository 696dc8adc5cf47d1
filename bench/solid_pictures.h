// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace scree::bench {

/// Root mean square errors of one evaluation per pixel, compared with 576 points per pixel:
/// unfiltered, with the fine levels of the fractal left out, and filtered.
void print_antialiasing();

/// The renderer's error at the far end of a marble floor: 4 samples per pixel compared with 1,024.
void print_floor();

/// The CPU time that a texture adds to rendering a ball that fills the picture.
void print_shading();

/// Okada et al.'s (1987) table 1 and our times for the same figures.
void print_table_1();

} // namespace scree::bench
