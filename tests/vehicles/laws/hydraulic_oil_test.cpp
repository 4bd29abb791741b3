#include "vehicles/laws/hydraulic_oil.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vehicles/hydraulic_settings.h"

namespace fourpost::hydraulic_oil_test {
namespace {

/// A few states each, the last with vapour in the rebound chamber [m^3].
const std::vector<double> kSurpluses = {-3e-6, -1e-8, 0, 2e-7, 1e-6};

HydraulicOil::State At(const HydraulicOil& oil, double x, double surplus) {
  return oil.Find(x, 1, 0, surplus, oil.Rest());
}

class HydraulicOilTest : public testing::TestWithParam<HydraulicSetting> {
 protected:
  HydraulicOil oil_{GetParam().damper};
};

// What Find() leaves: a step of 1e-8 of the pressure at rest, to the square over the bleed's rounding; in volumes of
// stiff oil.
constexpr double kFound = 1e-9;

TEST_P(HydraulicOilTest, PressuresHoldAllOilAndTheMountsForce) {
  const MountedHydraulicDamper& law = GetParam().damper;
  const HydraulicDamper& d = law.damper;
  for (const double x : {-0.03, 0.0, 0.02})
    for (const double surplus : kSurpluses) {
      const HydraulicOil::State state = At(oil_, x, surplus);
      EXPECT_NEAR(state.surplus, surplus, kFound * d.rebound_volume);
      const double own = law.HasMount() ? x - law.MountExtension(state.pressures) : x;
      const auto oil = [&](double pressure, double volume) {
        return volume * std::exp((pressure - d.gas_pressure) / d.bulk_modulus);
      };
      const double rebound = oil(state.pressures[0], d.rebound_volume - d.annulus_area * own);
      const double compression = oil(state.pressures[1], d.compression_volume + d.piston_area * own + d.gas_volume -
                                                             d.GasVolume(state.pressures[1]));
      EXPECT_NEAR(rebound, d.rebound_volume - d.annulus_area * x + surplus, kFound * d.rebound_volume);
      EXPECT_NEAR(rebound + compression, d.rebound_volume + d.compression_volume, kFound * d.rebound_volume);
      EXPECT_EQ(state.tension, d.Force(0, state.pressures));
    }
}

TEST_P(HydraulicOilTest, ChangesByTheLawOfItsPressures) {
  const MountedHydraulicDamper& law = GetParam().damper;
  constexpr double kStep = 1e-8;  // s
  for (const double x : {-0.03, 0.02})
    for (const double surplus : kSurpluses)
      for (const double v : {-0.4, 0.3}) {
        const HydraulicOil::State state = At(oil_, x, surplus);
        const auto rates =
            law.HasMount() ? law.PressureRates(x, v, state.pressures) : law.damper.PressureRates(x, v, state.pressures);
        const double gain = law.damper.annulus_area * v - state.flow;
        const HydraulicOil::State later = At(oil_, x + kStep * v, surplus + kStep * gain);
        // Differences over 10 ns of what Find() leaves; the valves' rates change at 1e4 / s.
        for (std::size_t i = 0; i < 2; ++i)
          EXPECT_NEAR(later.pressures[i] - state.pressures[i], kStep * rates[i],
                      1e-3 * kStep * std::abs(rates[i]) + 1e-2)
              << x << " " << surplus << " " << v;
      }
}

TEST_P(HydraulicOilTest, HasTheSlopesOfItsStates) {
  for (const double x : {-0.03, 0.02})
    for (const double surplus : kSurpluses) {
      const HydraulicOil::Slopes slopes = oil_.SlopesAt(x, At(oil_, x, surplus));
      // Of columns of 0.1 m; truncation and what Find() leaves are some 1e-6 of the largest slopes.
      constexpr double kLength = 1e-7;
      const double volume = kLength * GetParam().damper.damper.annulus_area;
      const auto more = At(oil_, x, surplus + volume);
      const auto less = At(oil_, x, surplus - volume);
      const auto longer = At(oil_, x + kLength, surplus);
      const auto shorter = At(oil_, x - kLength, surplus);
      const auto expect = [](double slope, double high, double low, double step, double scale) {
        EXPECT_NEAR(slope, (high - low) / (2 * step), 1e-4 * std::abs(slope) + 1e-5 * scale);
      };
      expect(slopes.flow_by_surplus, more.flow, less.flow, volume, 1e3);
      expect(slopes.tension_by_surplus, more.tension, less.tension, volume, 1e9);
      expect(slopes.flow_by_extension, longer.flow, shorter.flow, kLength, 1);
      expect(slopes.tension_by_extension, longer.tension, shorter.tension, kLength, 1e6);
    }
}

TEST_P(HydraulicOilTest, TakesAnImplicitStep) {
  constexpr double kStep = 1e-3;
  const double area = GetParam().damper.damper.annulus_area;
  const HydraulicOil::State from = At(oil_, 0.01, 1e-7);
  const HydraulicOil::State to = oil_.Find(0.0103, 1 / kStep, 1, area * 0.3 + from.surplus / kStep, from);
  const double volume = GetParam().damper.damper.rebound_volume;
  EXPECT_NEAR(to.surplus, from.surplus + kStep * (area * 0.3 - to.flow), kFound * volume);
}

INSTANTIATE_TEST_SUITE_P(Settings, HydraulicOilTest, testing::ValuesIn(HydraulicSettings()));

TEST(HydraulicOil, LinearShareIsGasAboutTheRodAndOilBehindTheValves) {
  const HydraulicDamper d;
  const auto [stiffness, rate, series] = HydraulicOil({.damper = d, .mount = {}}).Linear();
  const double above = d.rebound_volume / d.bulk_modulus;
  const double below = d.compression_volume / d.bulk_modulus + d.gas_volume / (d.gas_exponent * d.gas_pressure);
  const double rod = d.piston_area - d.annulus_area;
  EXPECT_NEAR(stiffness / (rod * rod / (above + below)), 1, 1e-12);
  const double closed = d.annulus_area * d.annulus_area / above + d.piston_area * d.piston_area / below;
  EXPECT_NEAR((series + stiffness) / closed, 1, 1e-12);
  // The oil that the gas takes in makes the area some per cent larger.
  EXPECT_GT(rate, d.MeanRate());
  EXPECT_NEAR(rate / d.MeanRate(), 1, 0.01);
}

TEST(HydraulicOil, MountIsInLineWithTheLinearShare) {
  const MountedHydraulicDamper alone{.damper = {}, .mount = {}};
  const MountedHydraulicDamper mounted{.damper = {}, .mount = {.stiffness = 300e3, .cubic = 1e12, .knees = {}}};
  const auto a = HydraulicOil(alone).Linear();
  const auto b = HydraulicOil(mounted).Linear();
  const auto in_line = [](double stiffness) { return 1 / (1 / stiffness + 1 / 300e3); };
  EXPECT_NEAR(b.stiffness / in_line(a.stiffness), 1, 1e-9);
  EXPECT_NEAR((b.series + b.stiffness) / in_line(a.series + a.stiffness), 1, 1e-9);
}

TEST(HydraulicOil, IsNanWhereAChamberCloses) {
  const HydraulicOil oil({.damper = {}, .mount = {}});
  // Columns of 0.1 m, either way.
  EXPECT_TRUE(std::isnan(At(oil, 0.1001, 0).tension));
  EXPECT_TRUE(std::isnan(At(oil, -0.1001, 0).tension));
  EXPECT_FALSE(std::isnan(At(oil, -0.0999, 0).tension));
  EXPECT_TRUE(std::isnan(At(oil, std::nan(""), 0).tension));
}

}  // namespace
}  // namespace fourpost::hydraulic_oil_test
