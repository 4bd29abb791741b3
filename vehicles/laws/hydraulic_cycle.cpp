#include "vehicles/laws/hydraulic_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fourpost {
namespace {

/// The last two surpluses, the earlier one first.
using Pair = std::array<double, 2>;

/// Where x = map x + shift: 2 x 2, by columns.
Pair FixedPoint(const std::array<Pair, 2>& map, const Pair& shift) {
  const double a = 1 - map[0][0];
  const double b = -map[1][0];
  const double c = -map[0][1];
  const double d = 1 - map[1][1];
  const double determinant = a * d - b * c;
  return {(d * shift[0] - b * shift[1]) / determinant, (a * shift[1] - c * shift[0]) / determinant};
}

/// What the backward difference has of the steps before, times h.
double Past(const Pair& last) { return 2 * last[1] - 0.5 * last[0]; }

void Advance(Pair& last, double surplus) { last = {last[1], surplus}; }

}  // namespace

std::optional<HydraulicCycle> HydraulicCycle::Solve(const MountedHydraulicDamper& damper, double period,
                                                    std::span<const double> extension, std::span<const double> rate) {
  // By Newton's method on the map from one period to the next, whose slope lies between 0 and 1.
  constexpr int kMostPeriods = 50;
  // Of the chamber, as Find() leaves it.
  const double close = 1e-12 * damper.damper.rebound_volume;
  const std::size_t n = extension.size();
  HydraulicCycle cycle(damper);
  const HydraulicOil& oil = cycle.oil_;
  cycle.step_ = period / static_cast<double>(n);
  const double h = cycle.step_;
  cycle.slopes_.resize(n);
  Pair start{};
  for (int i = 0; i < kMostPeriods; ++i) {
    Pair last = start;
    std::array<Pair, 2> by_start = {Pair{1, 0}, Pair{0, 1}};
    const bool is_first = cycle.states_.empty();
    if (is_first) cycle.states_.assign(n, oil.Rest());
    HydraulicOil::State near = cycle.states_.back();
    int repeated = 0;
    for (std::size_t k = 0; k < n && repeated < 2; ++k) {
      const double inflow = damper.damper.annulus_area * rate[k] + Past(last) / h;
      const HydraulicOil::State state = oil.Find(extension[k], 1.5 / h, 1, inflow, is_first ? near : cycle.states_[k]);
      if (!std::isfinite(state.tension) || !std::isfinite(state.surplus)) return {};
      repeated = !is_first && std::abs(state.surplus - cycle.states_[k].surplus) <= close ? repeated + 1 : 0;
      near = cycle.states_[k] = state;
      cycle.slopes_[k] = oil.SlopesAt(extension[k], state);
      for (Pair& by : by_start) Advance(by, Past(by) / (1.5 + h * cycle.slopes_[k].flow_by_surplus));
      Advance(last, state.surplus);
    }
    if (repeated == 2) return cycle;
    const Pair change = FixedPoint(by_start, {last[0] - start[0], last[1] - start[1]});
    for (std::size_t j = 0; j < 2; ++j) start[j] += change[j];
  }
  return {};
}

void HydraulicCycle::Change(std::span<const double> extension, std::span<const double> rate,
                            std::span<double> tension) const {
  const double area = oil_.law().damper.annulus_area;
  const auto past_to_now = [&](std::size_t k) { return 1 / (1.5 + step_ * slopes_[k].flow_by_surplus); };
  const auto run = [&](Pair last, double share, const auto& hear) {
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const double inflow = share * (area * rate[k] - slopes_[k].flow_by_extension * extension[k]);
      Advance(last, (step_ * inflow + Past(last)) * past_to_now(k));
      hear(k, last[1]);
    }
    return last;
  };
  const auto nothing = [](std::size_t, double) {};
  const Pair start = FixedPoint({run({1, 0}, 0, nothing), run({0, 1}, 0, nothing)}, run({0, 0}, 1, nothing));
  run(start, 1, [&](std::size_t k, double surplus) {
    tension[k] = slopes_[k].tension_by_surplus * surplus + slopes_[k].tension_by_extension * extension[k];
  });
}

}  // namespace fourpost
