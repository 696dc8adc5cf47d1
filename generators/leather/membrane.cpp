// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/membrane.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>

namespace scree {

namespace {

// Below this share of a pixel the groove counts as passing through the pixel's centre; shorter legs
// only make the system stiff.
constexpr float shortest_leg = 0.05F;

/// The equation of one pixel: u = (1 + sum of weight * neighbour) / (1 + sum of weight).
class Stencil {
  public:
    Stencil(const GrooveNetwork& network, float squared_shoulder)
        : network_(network), squared_shoulder_(squared_shoulder) {}

    float solve(const std::vector<float>& u, int x, int y) const {
        const int n = network_.resolution;
        const std::size_t here = network_.index(x, y);
        const std::array<std::size_t, 4> neighbour{
            network_.index(x == 0 ? n - 1 : x - 1, y), network_.index(x == n - 1 ? 0 : x + 1, y),
            network_.index(x, y == 0 ? n - 1 : y - 1), network_.index(x, y == n - 1 ? 0 : y + 1)};
        const std::uint32_t owner = network_.owner[here];
        std::array<float, 4> leg{1, 1, 1, 1}, value{};
        for (std::size_t k = 0; k < 4; ++k) {
            if (network_.owner[neighbour[k]] == owner) {
                value[k] = u[neighbour[k]];
            } else { // the groove, where u = 0, lies between
                const float d = network_.distance[here];
                leg[k] = std::max(shortest_leg, d / (d + network_.distance[neighbour[k]] + 1e-30F));
            }
        }
        float weights = 0, sum = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const float weight = 2 * squared_shoulder_ / (leg[k] * (leg[k] + leg[k ^ 1U]));
            weights += weight;
            sum += weight * value[k];
        }
        return (1 + sum) / (1 + weights);
    }

  private:
    const GrooveNetwork& network_;
    float squared_shoulder_; // [pixels^2]
};

} // namespace

std::vector<float> membrane(const GrooveNetwork& network, double shoulder, const Context& context) {
    const int n = network.resolution;
    const double pixels = shoulder / network.pixel;
    std::vector<float> u(network.distance.size());
    float reach = 0; // the widest distance from a groove
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = -std::expm1(-network.distance[i] / static_cast<float>(shoulder));
        reach = std::max(reach, network.distance[i]);
    }
    // The best over-relaxation for the error that decays slowest, which fades over the shoulder and
    // is 0 on the grooves of the widest cell (Young 1954). This many sweeps reduce it below a
    // thousandth.
    const double radius = std::max(1.0, double(reach) / network.pixel);
    const double rate = std::sqrt(0.5 / (pixels * pixels) + pi * pi / 4 / (radius * radius));
    const auto relaxation = static_cast<float>(2 / (1 + rate));
    const int sweeps = static_cast<int>(std::ceil(6 / rate)) + 8;
    const Stencil stencil(network, static_cast<float>(pixels * pixels));
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        context.check_cancel();
        context.report("swelling cells", double(sweep) / sweeps);
        for (int color = 0; color < 2; ++color)
            parallel_for(std::size_t(n), 16, [&](std::size_t row) {
                const int y = static_cast<int>(row);
                for (int x = (y + color) & 1; x < n; x += 2) {
                    float& value = u[network.index(x, y)];
                    value += relaxation * (stencil.solve(u, x, y) - value);
                }
            });
    }
    for (float& value : u)
        value = std::clamp(value, 0.0F, 1.0F);
    return u;
}

} // namespace scree
