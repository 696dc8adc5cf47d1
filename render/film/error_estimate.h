// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/film/film.h"

namespace scree {

/// Estimates how far a film is from the picture with endless samples: the root mean square over
/// pixels of the error of luminance over (luminance + 0.18), mid-grey, so that dark pixels count
/// as they are seen.
///
/// A pixel's samples are points of one sequence, so its error is less than their variance S / n
/// says: later samples lie in the gaps of earlier ones. The variance of the mean is taken to be
/// V(n) = S / n^p. The means of two halves of n samples differ by 4 (V(n/2) - V(n)) on average,
/// which gives p, as do those of the halves of the first half; of both the mean is taken.
class ErrorEstimate {
  public:
    /// Takes in a rectangle of pixels, by itself: the luminance about a pixel is that of its
    /// neighbours in the rectangle.
    void add(const Film& film, int x0, int y0, int x1, int y1);

    /// Infinite without pixels, and where any has fewer than two samples.
    double value() const;

    /// The same, were the samples independent: too large, but more certain, since it comes from all
    /// samples and not from two halves.
    double independent() const;

  private:
    // Sums over pixels, over their squared luminances; m is the number of samples in the first
    // half.
    double samples_ = 0;   // S / n
    double first_ = 0;     // S / m
    double halves_ = 0;    // V(n/2) - V(n)
    double quarters_ = 0;  // V(m/2) - V(m)
    double log_count_ = 0; // sum of the logarithms of n
    double log_first_ = 0; // of m
    double pixels_ = 0;
    bool unknown_ = false;
};

} // namespace scree
