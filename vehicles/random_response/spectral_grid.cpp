#include "vehicles/random_response/spectral_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// Of the positive half of [-1, 1].
constexpr std::array<double, 4> kNodes = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                          0.9602898564975363};
constexpr std::array<double, 4> kShares = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                           0.1012285362903763};

/// Width of a panel in ln f over the damping ratio, which is the distance of a pole from the real axis of ln f: eight
/// points then leave 1e-4 of what lies on the panel.
constexpr double kWidthPerDamping = 3.5;
constexpr double kWidest = 0.5;
constexpr double kNarrowest = 0.02;
/// Turn of the delay's phase over a panel, of which eight points leave 1e-5.
constexpr double kTurn = 8;

void AddPanel(double from, double to, SpectralGrid& grid) {
  const auto add = [&](double u, double share) {
    const double frequency = std::exp(0.5 * (from + to) + 0.5 * (to - from) * u);
    grid.frequency_Hz.push_back(frequency);
    grid.share_Hz.push_back(0.5 * (to - from) * share * frequency);
  };
  for (std::size_t i = kNodes.size(); i-- > 0;) add(-kNodes[i], kShares[i]);
  for (std::size_t i = 0; i < kNodes.size(); ++i) add(kNodes[i], kShares[i]);
}

}  // namespace

SpectralGrid SpectralGrid::For(double lower_Hz, double upper_Hz, double longest_delay_s, double least_damping_ratio,
                               double refinement) {
  RequirePositive("SpectralGrid: lower_Hz", lower_Hz);
  RequireOption(upper_Hz > lower_Hz && std::isfinite(upper_Hz), "SpectralGrid: upper_Hz", upper_Hz,
                "above lower_Hz and finite");
  RequireOption(longest_delay_s >= 0 && std::isfinite(longest_delay_s), "SpectralGrid: longest_delay_s",
                longest_delay_s, "zero or more and finite");
  RequirePositive("SpectralGrid: refinement", refinement);
  const double widest = std::clamp(kWidthPerDamping * least_damping_ratio, kNarrowest, kWidest) / refinement;
  const double turn = kTurn / refinement;
  SpectralGrid grid;
  for (double lower = lower_Hz; lower < upper_Hz * (1 - 1e-9);) {
    const double left = std::log(upper_Hz / lower);
    // Panels of one width up to the end rather than a narrow last one.
    double width = left / std::ceil(left / widest);
    if (longest_delay_s > 0)
      width = std::min(width, std::log1p(turn / (2 * std::numbers::pi * longest_delay_s * lower)));
    const double upper = std::min(upper_Hz, lower * std::exp(width));
    AddPanel(std::log(lower), std::log(upper), grid);
    lower = upper;
  }
  return grid;
}

}  // namespace fourpost
