// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace scree::rocks {

/// Rocks of about one size: `radius` as in Sakurai & Miyata, whose cells are about 1.2 of it wide,
/// and their share of the ground.
struct SizeClass {
    double radius = 0; // [m]
    double share = 0;
};

/// The usual fill of a disk set, c_d of Sakurai & Miyata's eq. 1.
inline constexpr double disk_fill = 0.7;

/// The mean area of a cell of the class [m^2].
double cell_area(const SizeClass& size);

/// Longest axes of rocks of which as many are longer than D as N(>D) = C (D^-q - largest^-q) says
/// (Turcotte 1986), at stratified quantiles.
std::vector<double> power_sizes(double smallest, double largest, double exponent, std::size_t count,
                                std::uint64_t seed);

/// The mean square of these axes [m^2].
double power_mean_square(double smallest, double largest, double exponent);

/// Longest axes for the cumulative fractional area F(>D) = k exp(-q D), q = 1.79 + 0.152 / k with D
/// in metres (Golombek & Rapp 1997), for ground of an area [m^2] and rocks that cover `fill` D^2.
std::vector<double> area_sizes(double k, double smallest, double largest, double area, double fill,
                               std::uint64_t seed);

/// How many rocks `area_sizes` gives.
double area_count(double k, double smallest, double largest, double area, double fill);

/// Longest axes for classes that cover their shares of an area, each rock's varied by 30%.
std::vector<double> class_sizes(std::span<const SizeClass> classes, double cover, double area,
                                double fill, std::uint64_t seed);

} // namespace scree::rocks
