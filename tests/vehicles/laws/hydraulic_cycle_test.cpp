#include "vehicles/laws/hydraulic_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vehicles/hydraulic_settings.h"

namespace fourpost::hydraulic_cycle_test {
namespace {

/// One cycle of x = mean + X sin(w t) of peak speed V.
struct Sine {
  double frequency_Hz = 0;
  double speed = 0;
  double mean = 0;

  double Omega() const { return 2 * std::numbers::pi * frequency_Hz; }
  double X(double t) const { return mean + speed / Omega() * std::sin(Omega() * t); }
  double V(double t) const { return speed * std::cos(Omega() * t); }
};

struct Cycle {
  Cycle(const Sine& sine, std::size_t samples) : period(1 / sine.frequency_Hz) {
    for (std::size_t k = 0; k < samples; ++k) {
      const double t = static_cast<double>(k) * period / static_cast<double>(samples);
      x.push_back(sine.X(t));
      v.push_back(sine.V(t));
    }
  }
  double period;
  std::vector<double> x;
  std::vector<double> v;
};

std::array<double, 2> Rates(const MountedHydraulicDamper& law, double x, double v, const std::array<double, 2>& p) {
  return law.HasMount() ? law.PressureRates(x, v, p) : law.damper.PressureRates(x, v, p);
}

/// Pressures of the last of these cycles, from where it stands still at the mean, by Runge and Kutta's fourth order.
std::vector<std::array<double, 2>> Marched(const MountedHydraulicDamper& law, const Sine& sine, std::size_t samples,
                                           int cycles) {
  const auto steps = static_cast<std::size_t>(std::ceil(1 / (sine.frequency_Hz * static_cast<double>(samples) * 4e-6)));
  const double h = 1 / (sine.frequency_Hz * static_cast<double>(samples * steps));
  const HydraulicOil oil(law);
  std::array<double, 2> p = oil.Find(sine.mean, 0, 1, 0, oil.Rest()).pressures;
  const auto along = [&](double step, const std::array<double, 2>& rate) {
    return std::array<double, 2>{p[0] + step * rate[0], p[1] + step * rate[1]};
  };
  std::vector<std::array<double, 2>> pressures;
  for (std::size_t k = 0; k < samples * static_cast<std::size_t>(cycles); ++k) {
    if (k >= samples * static_cast<std::size_t>(cycles - 1)) pressures.push_back(p);
    for (std::size_t i = 0; i < steps; ++i) {
      const double t = h * static_cast<double>(k * steps + i);
      const auto rates = [&](double later, const std::array<double, 2>& at) {
        return Rates(law, sine.X(t + later), sine.V(t + later), at);
      };
      const auto k1 = rates(0, p);
      const auto k2 = rates(h / 2, along(h / 2, k1));
      const auto k3 = rates(h / 2, along(h / 2, k2));
      const auto k4 = rates(h, along(h, k3));
      for (std::size_t j = 0; j < 2; ++j) p[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
    }
  }
  return pressures;
}

class HydraulicCycleTest : public testing::TestWithParam<HydraulicSetting> {};

const std::vector<Sine> kSines = {{1, 0.05}, {2, 0.5, 0.02}, {12, 0.3}, {25, 0.8}};

TEST_P(HydraulicCycleTest, IsWhereAMarchOfThePressuresEnds) {
  for (const Sine& sine : kSines) {
    // A mount on soft oil takes some tenths of a second to settle.
    const auto marched = Marched(GetParam().damper, sine, 512, std::max(3, static_cast<int>(sine.frequency_Hz)));
    const auto error = [&](std::size_t samples) {
      const Cycle cycle(sine, samples);
      const auto solved = HydraulicCycle::Solve(GetParam().damper, cycle.period, cycle.x, cycle.v);
      double largest = 0;
      double squares = 0;
      for (std::size_t k = 0; k < samples; ++k) {
        const double expected = GetParam().damper.damper.Force(0, marched[k * 512 / samples]);
        largest = std::max(largest, std::abs(expected));
        squares += std::pow(solved->states()[k].tension - expected, 2);
      }
      return std::sqrt(squares / static_cast<double>(samples)) / largest;
    };
    // Second order in the steps but for kinks of valves and bleed, and the jump where vapour goes.
    EXPECT_LT(error(128), 2e-2) << sine.frequency_Hz << " Hz";
    EXPECT_LT(error(512), 1.5e-3) << sine.frequency_Hz << " Hz";
  }
}

TEST_P(HydraulicCycleTest, LosesInItsValvesTheWorkDoneOnIt) {
  for (const Sine& sine : kSines) {
    const Cycle cycle(sine, 512);
    const auto solved = HydraulicCycle::Solve(GetParam().damper, cycle.period, cycle.x, cycle.v);
    double work = 0;
    double loss = 0;
    for (std::size_t k = 0; k < cycle.x.size(); ++k) {
      work += solved->states()[k].tension * cycle.v[k];
      loss += GetParam().damper.damper.Dissipation(0, solved->states()[k].pressures);
    }
    // What 512 steps leave.
    EXPECT_NEAR(loss / work, 1, 2e-3) << sine.frequency_Hz << " Hz";
  }
}

// The only reasonable check of a derivative: half the change leaves a quarter of what it misses.
TEST_P(HydraulicCycleTest, HasTheChangesOfItsTension) {
  for (const Sine& sine : kSines) {
    const Cycle cycle(sine, 128);
    const auto solved = HydraulicCycle::Solve(GetParam().damper, cycle.period, cycle.x, cycle.v);
    const Sine change{3 * sine.frequency_Hz, 1e-6, 1e-7};
    std::vector<double> dx;
    std::vector<double> dv;
    for (std::size_t k = 0; k < cycle.x.size(); ++k) {
      const double t = static_cast<double>(k) * cycle.period / 128;
      dx.push_back(change.X(t));
      dv.push_back(change.V(t));
    }
    std::vector<double> changes(dx.size());
    solved->Change(dx, dv, changes);
    Cycle changed = cycle;
    Cycle other = cycle;
    for (std::size_t k = 0; k < dx.size(); ++k) {
      changed.x[k] += dx[k];
      changed.v[k] += dv[k];
      other.x[k] -= dx[k];
      other.v[k] -= dv[k];
    }
    const auto more = HydraulicCycle::Solve(GetParam().damper, cycle.period, changed.x, changed.v);
    const auto less = HydraulicCycle::Solve(GetParam().damper, cycle.period, other.x, other.v);
    const double largest = std::abs(*std::max_element(changes.begin(), changes.end(),
                                                      [](double a, double b) { return std::abs(a) < std::abs(b); }));
    for (std::size_t k = 0; k < dx.size(); ++k)
      EXPECT_NEAR(0.5 * (more->states()[k].tension - less->states()[k].tension), changes[k], 1e-3 * largest)
          << sine.frequency_Hz << " Hz, sample " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Settings, HydraulicCycleTest, testing::ValuesIn(HydraulicSettings()));

TEST(HydraulicCycle, RestsAtRest) {
  const std::vector<double> nothing(16, 0.0);
  const auto cycle = HydraulicCycle::Solve({.damper = {}, .mount = {}}, 1, nothing, nothing);
  for (const HydraulicOil::State& state : cycle->states()) EXPECT_NEAR(state.tension, 0, 1e-9);
}

// The gas, pressed by the rod.
TEST(HydraulicCycle, StandsAgainstTheGasWhereNothingMoves) {
  const HydraulicDamper d{.bulk_modulus = 1e14};
  const std::vector<double> pressed(16, -0.05);
  const std::vector<double> still(16, 0.0);
  const auto cycle = HydraulicCycle::Solve({.damper = d, .mount = {}}, 1, pressed, still);
  const double rod = d.piston_area - d.annulus_area;
  const double pressure = d.gas_pressure * std::pow(1 - rod * 0.05 / d.gas_volume, -d.gas_exponent);
  // Oil of 100 TPa gives way by 1e-7 of what the gas does.
  EXPECT_NEAR(cycle->states()[7].tension, -(pressure - d.gas_pressure) * rod, 1e-4);
}

TEST(HydraulicCycle, HasNoneWhereAChamberCloses) {
  const Cycle cycle({.frequency_Hz = 1, .speed = 0.7, .mean = 0}, 64);  // 0.11 m of columns of 0.1 m
  EXPECT_FALSE(HydraulicCycle::Solve({.damper = {}, .mount = {}}, cycle.period, cycle.x, cycle.v).has_value());
  const Cycle lower({.frequency_Hz = 1, .speed = 0.56, .mean = -0.02}, 64);  // from -0.109 to 0.069 m
  EXPECT_FALSE(HydraulicCycle::Solve({.damper = {}, .mount = {}}, lower.period, lower.x, lower.v).has_value());
  std::vector<double> nan = cycle.x;
  nan[3] = std::nan("");
  EXPECT_FALSE(HydraulicCycle::Solve({.damper = {}, .mount = {}}, cycle.period, nan, cycle.v).has_value());
}

}  // namespace
}  // namespace fourpost::hydraulic_cycle_test
