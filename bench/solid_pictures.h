// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace scree::bench {

/// Root mean square errors of one answer a pixel: at a point, with the fractal's fine levels left
/// out, and filtered; against 576 points a pixel.
void print_antialiasing();

/// The far end of a marble floor through the renderer, 4 samples a pixel against 1,024.
void print_floor();

/// What a texture adds to the CPU time of rendering a ball that fills the picture.
void print_shading();

/// Okada et al.'s (1987) table 1 and our times for the same figures.
void print_table_1();

} // namespace scree::bench
