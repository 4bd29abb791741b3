// Hydraulic dampers in the harmonic balance, against the march of the multibody.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <Eigen/Eigenvalues>

#include "tests/vehicles/hydraulic_cars.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/resting.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost::hydraulic_balance_test {
namespace {

/// What the march's windows repeat within, and what harmonics and steps leave.
constexpr double kGain_dB = 0.02;
constexpr double kPhase_deg = 0.1;

struct DamperCase {
  const char* name;
  HydraulicDescription oil;
  double mount = 0;
  std::vector<std::pair<double, double>> heights;  // Hz, m
};

std::ostream& operator<<(std::ostream& out, const DamperCase& damper) { return out << damper.name; }

/// Its valves tear the oil.
const DamperCase kBoilingOnAMount{"BoilingOnAMount", Oil(0.05e-6, 1e7, 4e7), 400e3, {{3, 0.01}, {12, 0.006}}};

class HydraulicBalance : public testing::TestWithParam<DamperCase> {};

TEST_P(HydraulicBalance, AgreesWithTheMarch) {
  Prepared prepared(QuarterCarOnOil(GetParam().oil, GetParam().mount));
  Excitation excitation{.shape = {1}};
  for (const auto& [frequency_Hz, height] : GetParam().heights) {
    excitation.frequency_Hz.push_back(frequency_Hz);
    excitation.amplitude_m.push_back(height);
  }
  const PeriodicResponse balanced = prepared.Linearised(excitation);
  EXPECT_THAT(balanced.unconverged_Hz, testing::IsEmpty());
  const FrequencyResponse marched = prepared.Marched(excitation, 512);
  ExpectAgreement(balanced.response, marched, kGain_dB, kPhase_deg);
  const ChannelResponse& strut = *balanced.response.Find("s_strut");
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i)
    EXPECT_NEAR(strut.mean[i], marched.Find("s_strut")->mean[i],
                1e-3 * std::abs(strut.response[i]) * excitation.amplitude_m[i])
        << excitation.frequency_Hz[i] << " Hz";
}

INSTANTIATE_TEST_SUITE_P(
    Dampers, HydraulicBalance,
    testing::Values(DamperCase{"Usual", Oil(0.6e-6, 1e7, 2.6e6), 0, {{1.2, 0.005}, {1.2, 0.04}, {6, 0.01}, {12, 3e-3}}},
                    DamperCase{"SoftOil", Oil(0.6e-6, 3e7, 2.6e6, 100e6), 0, {{1.2, 0.02}, {12, 0.0005}, {12, 0.006}}},
                    DamperCase{"Boiling", Oil(0.05e-6, 1e7, 4e7), 0, {{1.2, 0.02}, {6, 0.01}, {12, 0.006}}},
                    DamperCase{"OnAMount", Oil(0.6e-6, 1e7, 2.6e6), 400e3, {{1.2, 0.02}, {12, 3e-3}}},
                    DamperCase{"SoftOilOnASoftMount", Oil(0.6e-6, 3e7, 2.6e6, 100e6), 100e3, {{1.2, 0.02}, {6, 0.01}}},
                    kBoilingOnAMount),
    [](const auto& damper) { return damper.param.name; });

TEST(HydraulicBalance, TakesFrictionBetweenTheEndsOfDamperAndMount) {
  Vehicle vehicle = QuarterCarOnOil(Oil(0.6e-6, 1e7, 2.6e6), 400e3);
  vehicle.dampers[0].law.friction = DashpotDescription::Friction{{40}, {0.02}};
  Prepared prepared(vehicle);
  const Excitation excitation{{1.2, 12}, {0.01, 0.002}, {1}};
  const PeriodicResponse balanced = prepared.Linearised(excitation);
  EXPECT_THAT(balanced.unconverged_Hz, testing::IsEmpty());
  ExpectAgreement(balanced.response, prepared.Marched(excitation, 512), kGain_dB, kPhase_deg);
}

// A wide bleed's shut piston meets its end at the body's resonance.
TEST(HydraulicBalance, TellsWhereAChamberCloses) {
  HydraulicDescription oil = Oil(20e-6, 1e5, 1e5);
  oil.rebound_column = oil.compression_column = {0.05};
  const PeriodicResponse balanced = Prepared(QuarterCarOnOil(oil)).Linearised({{0.2, 1.3}, {0.01, 0.04}, {1}});
  EXPECT_THAT(balanced.unconverged_Hz, testing::ElementsAre(1.3));
}

/// How far the balance of linear kinematics is from a march that the full balance agrees with [dB].
double LinearisedFromMarch(Prepared& prepared, const Excitation& excitation) {
  const PeriodicResponse balanced = prepared.Full(excitation);
  EXPECT_THAT(balanced.unconverged_Hz, testing::IsEmpty());
  const FrequencyResponse marched = prepared.Marched(excitation, 256);
  ExpectAgreement(balanced.response, marched, kGain_dB, kPhase_deg);
  const FrequencyResponse linearised = prepared.Linearised(excitation).response;
  double apart = 0;
  for (std::size_t c = 0; c < marched.channels.size(); ++c)
    apart = std::max(apart, LargestDeviation(linearised.channels[c], marched.channels[c]).gain_dB);
  return apart;
}

TEST(HydraulicFullBalance, AgreesWithTheMarchWhereLinearKinematicsDoNot) {
  Prepared prepared(LinkageCarOnOil());
  EXPECT_LT(LinearisedFromMarch(prepared, {{1.2, 9.45}, {0.005, 0.0005}, {1, 1}}), 0.05);
  EXPECT_GT(LinearisedFromMarch(prepared, {{1.2, 9.45}, {0.05, 0.005}, {1, -1}}), 2 * kGain_dB);
}

TEST(HydraulicFullBalance, TellsStatesOfMixedDampersApart) {
  Prepared prepared(LinkageCarOnMixedDampers());
  LinearisedFromMarch(prepared, {{1.2, 9.45}, {0.03, 0.003}, {1, 0.5}});
}

// Its kinematics are linear: both balances solve the same equations.
TEST(HydraulicFullBalance, IsTheLinearisedBalanceOfAQuarterCar) {
  for (const DamperCase& damper : {DamperCase{"Usual", Oil(0.6e-6, 1e7, 2.6e6)}, kBoilingOnAMount}) {
    Prepared prepared(QuarterCarOnOil(damper.oil, damper.mount));
    const Excitation excitation{{1.2, 6, 12}, {0.02, 0.01, 0.006}, {1}};
    const PeriodicResponse full = prepared.Full(excitation);
    EXPECT_THAT(full.unconverged_Hz, testing::IsEmpty());
    // Steps in time of two grids, of the second order each.
    ExpectAgreement(full.response, prepared.Linearised(excitation).response, 0.005, 0.03);
  }
}

TEST(HydraulicFullBalance, TellsWhereAChamberCloses) {
  HydraulicDescription oil = Oil(20e-6, 1e5, 1e5);
  oil.rebound_column = oil.compression_column = {0.05};
  const PeriodicResponse balanced = Prepared(QuarterCarOnOil(oil)).Full({{0.2, 1.3}, {0.01, 0.04}, {1}});
  EXPECT_THAT(balanced.unconverged_Hz, testing::ElementsAre(1.3));
}

/// Of the multibody's state rates about rest, by central differences.
Eigen::VectorXcd SimbodyPoles(const Vehicle& vehicle) {
  Multibody multibody = Resting(vehicle);
  const Eigen::VectorXd rest = multibody.RestState();
  constexpr double kStep = 1e-5;  // m, m/s, MPa
  Eigen::MatrixXd matrix(rest.size(), rest.size());
  for (Eigen::Index j = 0; j < rest.size(); ++j) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(rest.size(), j);
    matrix.col(j) =
        (multibody.StateDerivative(0, rest + step) - multibody.StateDerivative(0, rest - step)) / (2 * kStep);
  }
  return matrix.eigenvalues();
}

// With laminar valves, alike both ways, the mean rate is that of small motion.
TEST(HydraulicBalance, LinearModelHasThePolesOfSimbody) {
  for (const double mount : {0.0, 200e3}) {
    const Vehicle vehicle = QuarterCarOnOil(Oil(1e-17, 1e7, 1e7), mount);
    const Eigen::VectorXcd simbody = SimbodyPoles(vehicle);
    const Eigen::VectorXcd condensed =
        StateMatrix(CondensedVehicle(vehicle).At(vehicle.ParameterValues())).eigenvalues();
    // Four of the bodies and that of the oil; Simbody's other pressure only tells how much oil there is.
    ASSERT_EQ(condensed.size(), 5);
    ASSERT_EQ(simbody.size(), 6);
    for (const std::complex<double>& pole : condensed) {
      const double nearest = (simbody.array() - pole).abs().minCoeff();
      // The steady force looks at stiff oil of constant density: the flow of 1e7 Pa s/kg at 0.1 m/s is the same.
      EXPECT_LT(nearest, 1e-6 * std::abs(pole)) << pole << " on a mount of " << mount << " N/m";
    }
    EXPECT_LT(simbody.cwiseAbs().minCoeff(), 1e-4);
  }
}

}  // namespace
}  // namespace fourpost::hydraulic_balance_test
