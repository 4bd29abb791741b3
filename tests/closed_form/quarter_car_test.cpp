// The regression of the multibody quarter car against the written-out equations, which know nothing of Simbody.
#include "tests/closed_form/quarter_car.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include <gmock/gmock.h>
#include <Eigen/Eigenvalues>

#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/resting.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/march.h"

namespace fourpost::quarter_car_test {
namespace {

using Complex = std::complex<double>;

/// Joint coordinate of a link, as the only one of its joint.
Eigen::Index CoordinateOf(const Vehicle& vehicle, const std::string& link) {
  for (std::size_t j = 0; j < vehicle.joints.size(); ++j)
    if (vehicle.links[static_cast<std::size_t>(vehicle.joints[j].child)].name == link)
      return static_cast<Eigen::Index>(j);
  ADD_FAILURE() << "no link " << link;
  return 0;
}

/// The multibody quarter car in the order [z_s z_u z_s' z_u' x].
class MultibodyCar {
 public:
  explicit MultibodyCar(const Vehicle& vehicle) : multibody_(Resting(vehicle)) {
    const Eigen::Index sprung = CoordinateOf(vehicle, "sprung");
    const Eigen::Index unsprung = CoordinateOf(vehicle, "unsprung");
    order_ = {sprung, unsprung, 2 + sprung, 2 + unsprung};
    if (multibody_.state_size() == 5) order_.push_back(4);
  }

  Eigen::VectorXd Derivative(const Eigen::VectorXd& state) {
    return FromMultibody(multibody_.StateDerivative(0, ToMultibody(state)));
  }

  /// States at multiples of `step`.
  std::vector<Eigen::VectorXd> Decay(const Eigen::VectorXd& start, double step, int steps, double accuracy) {
    std::vector<Eigen::VectorXd> states;
    multibody_.Integrate(
        ToMultibody(start), 0, step, accuracy,
        [&](double, const Eigen::VectorXd& state, const Eigen::VectorXd&) { states.push_back(FromMultibody(state)); },
        [&] { return static_cast<int>(states.size()) > steps; });
    return states;
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(order_.size()); }

 private:
  Eigen::VectorXd ToMultibody(const Eigen::VectorXd& state) const {
    Eigen::VectorXd out = Eigen::VectorXd::Zero(multibody_.state_size());
    for (Eigen::Index i = 0; i < size(); ++i) out[order_[static_cast<std::size_t>(i)]] = state[i];
    return out;
  }

  Eigen::VectorXd FromMultibody(const Eigen::VectorXd& state) const {
    Eigen::VectorXd out(size());
    for (Eigen::Index i = 0; i < size(); ++i) out[i] = state[order_[static_cast<std::size_t>(i)]];
    return out;
  }

  Multibody multibody_;
  std::vector<Eigen::Index> order_;
};

std::vector<Complex> UpperPoles(const Eigen::MatrixXd& state_matrix) {
  std::vector<Complex> poles;
  for (const Complex pole : Eigen::VectorXcd(state_matrix.eigenvalues()))
    if (pole.imag() > 0) poles.push_back(pole);
  std::sort(poles.begin(), poles.end(), [](Complex a, Complex b) { return std::abs(a) < std::abs(b); });
  return poles;
}

void ExpectThesisPoles(const Eigen::MatrixXd& state_matrix) {
  const std::vector<Complex> poles = UpperPoles(state_matrix);
  ASSERT_EQ(poles.size(), 2u);
  // The digits of specification 1.1.
  constexpr double kDigits = 0.5e-3;
  EXPECT_NEAR(poles[0].real(), -3.439, kDigits);
  EXPECT_NEAR(poles[0].imag(), 7.855, kDigits);
  EXPECT_NEAR(poles[1].real(), -34.402, kDigits);
  EXPECT_NEAR(poles[1].imag(), 97.371, kDigits);
}

/// 0.5 to 30 Hz, each frequency `ratio` times the one before.
Excitation SteppedSine(double ratio) {
  Excitation excitation;
  for (double f = 0.5; f < 30; f *= ratio) {
    excitation.frequency_Hz.push_back(f);
    excitation.amplitude_m.push_back(std::min(0.012, 0.3 / (f * f)));
  }
  excitation.shape = {1};
  return excitation;
}

/// Steady response of the written-out equations: Runge-Kutta of fourth order until the car has settled, then the first
/// harmonic of z_s'' and z_u'' over one cycle, relative to the ground's.
std::array<Complex, 2> MarchedOde(const QuarterCar& car, double frequency_Hz, double amplitude_m) {
  constexpr int kSteps = 2000;  // per cycle
  constexpr double kSettled_s = 12;
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  const double h = 1 / (frequency_Hz * kSteps);
  const auto ground = [&](double t) { return amplitude_m * std::cos(omega * t); };
  using State = Eigen::Matrix<double, 5, 1>;
  State y = State::Zero();
  std::array<Complex, 2> sums{};
  const long settle = static_cast<long>(std::ceil(kSettled_s * frequency_Hz)) * kSteps;
  for (long k = 0; k < settle + kSteps; ++k) {
    const double t = static_cast<double>(k) * h;
    const State k1 = car.Derivative(y, ground(t));
    if (k >= settle)
      for (int i = 0; i < 2; ++i) sums[static_cast<std::size_t>(i)] += k1[2 + i] * std::polar(2.0 / kSteps, -omega * t);
    const State k2 = car.Derivative(y + h / 2 * k1, ground(t + h / 2));
    const State k3 = car.Derivative(y + h / 2 * k2, ground(t + h / 2));
    const State k4 = car.Derivative(y + h * k3, ground(t + h));
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  for (Complex& sum : sums) sum /= -omega * omega * amplitude_m;
  return sums;
}

/// Free decay of the written-out equations by Runge-Kutta of fourth order.
std::vector<Eigen::VectorXd> DecayOfOde(const QuarterCar& car, const Eigen::Matrix<double, 5, 1>& start, double step,
                                        int steps) {
  constexpr int kSubsteps = 200;
  const double h = step / kSubsteps;
  Eigen::Matrix<double, 5, 1> y = start;
  std::vector<Eigen::VectorXd> states = {y};
  for (int k = 0; k < steps * kSubsteps; ++k) {
    const Eigen::Matrix<double, 5, 1> k1 = car.Derivative(y, 0);
    const Eigen::Matrix<double, 5, 1> k2 = car.Derivative(y + h / 2 * k1, 0);
    const Eigen::Matrix<double, 5, 1> k3 = car.Derivative(y + h / 2 * k2, 0);
    const Eigen::Matrix<double, 5, 1> k4 = car.Derivative(y + h * k3, 0);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if ((k + 1) % kSubsteps == 0) states.push_back(y);
  }
  return states;
}

/// Largest difference of the two decays, per state, over the largest value of that state.
double DecayError(const std::vector<Eigen::VectorXd>& multibody, const std::vector<Eigen::VectorXd>& ode) {
  const Eigen::Index size = multibody.front().size();
  Eigen::VectorXd error = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(size);
  for (std::size_t k = 0; k < ode.size(); ++k) {
    error = error.cwiseMax((multibody[k] - ode[k].head(size)).cwiseAbs());
    largest = largest.cwiseMax(ode[k].head(size).cwiseAbs());
  }
  return error.cwiseQuotient(largest).maxCoeff();
}

void ExpectEqualDecay(const QuarterCar& car, const Vehicle& vehicle) {
  Eigen::Matrix<double, 5, 1> start;
  start << 0.03, -0.004, 0.2, -1, 0;
  constexpr double kStep_s = 0.005;
  constexpr int kSteps = 200;
  constexpr double kAccuracy = 1e-9;
  MultibodyCar multibody(vehicle);
  const auto marched = multibody.Decay(start.head(multibody.size()), kStep_s, kSteps, kAccuracy);
  // The integrator holds its accuracy per step relative to 1 m; the decay's smallest state, the series spring's
  // extension, is some millimetres: 1e-9 / 1e-3, times a few hundred steps that partly cancel.
  EXPECT_LT(DecayError(marched, DecayOfOde(car, start, kStep_s, kSteps)), 1e-5);
}

void ExpectBalanceEqualsMarch(const QuarterCar& car, const Vehicle& vehicle) {
  const Excitation excitation{{1.2, 6, 15}, {0.012, 0.005, 0.001}, {1}};
  const FrequencyResponse response =
      SolveHarmonicBalance(CondensedVehicle(vehicle).At(vehicle.ParameterValues()), vehicle.sensors, excitation)
          .response;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    const auto marched = MarchedOde(car, excitation.frequency_Hz[i], excitation.amplitude_m[i]);
    // HarmonicBalanceOptions::error, and as much again for the march.
    EXPECT_LT(std::abs(response.Find("a_sprung")->response[i] / marched[0] - 1.0), 4e-4);
    EXPECT_LT(std::abs(response.Find("a_unsprung")->response[i] / marched[1] - 1.0), 4e-4);
  }
}

TEST(QuarterCar, HasThePolesOfTheThesis) { ExpectThesisPoles(ThesisCar().StateMatrix()); }

TEST(QuarterCar, ResponseSolvesTheStateEquations) {
  const QuarterCar car = ThesisCar();
  for (const double f : {0.5, 1.3, 5.0, 16.0, 30.0}) {
    const Complex iw(0, 2 * std::numbers::pi * f);
    const Eigen::Vector4cd states =
        (iw * Eigen::Matrix4cd::Identity() - car.StateMatrix()).partialPivLu().solve(car.InputVector().cast<Complex>());
    const auto response = car.Response(f);
    // Rounding of a 4 x 4 solve with a condition of about 1e4.
    EXPECT_LT(std::abs(states[0] - response[0]), 1e-12);
    EXPECT_LT(std::abs(states[1] - response[1]), 1e-12);
  }
}

// Specification 1.1: peaks of z_s/z_g and z_u/z_g, not to be confused with the pole frequencies.
TEST(QuarterCar, ResponsePeaksWhereTheThesisHasThem) {
  std::array<double, 2> peak{};
  std::array<double, 2> frequency{};
  for (double f = 0.5; f < 30; f += 0.005) {
    const auto response = ThesisCar().Response(f);
    for (std::size_t i = 0; i < 2; ++i) {
      // The wheel's own peak, above the body's.
      if ((i == 1 && f < 5) || std::abs(response[i]) <= peak[i]) continue;
      peak[i] = std::abs(response[i]);
      frequency[i] = f;
    }
  }
  EXPECT_NEAR(peak[0], 1.70, 0.005);
  EXPECT_NEAR(frequency[0], 1.23, 0.005);
  EXPECT_NEAR(peak[1], 1.56, 0.005);
  EXPECT_NEAR(frequency[1], 14.5, 0.05);
}

TEST(QuarterCar, MultibodyHasTheAnalyticStateMatrix) {
  MultibodyCar multibody(Describe(ThesisCar()));
  ASSERT_EQ(multibody.size(), 4);
  Eigen::Matrix4d matrix;
  // The system is linear: any step serves, and a large one loses fewest digits.
  constexpr double kStep = 1;
  for (Eigen::Index j = 0; j < 4; ++j)
    matrix.col(j) = (multibody.Derivative(kStep * Eigen::Vector4d::Unit(j)) -
                     multibody.Derivative(-kStep * Eigen::Vector4d::Unit(j))) /
                    (2 * kStep);
  const Eigen::Matrix4d analytic = ThesisCar().StateMatrix();
  // Rounding: accelerations of 1e4 m/s^2 on 64-bit numbers.
  EXPECT_LT((matrix - analytic).cwiseAbs().maxCoeff(), 100 * 2.2e-16 * analytic.cwiseAbs().maxCoeff());
  ExpectThesisPoles(matrix);
}

TEST(QuarterCar, CondensedVehicleHasTheAnalyticStateMatrix) {
  const Vehicle vehicle = Describe(ThesisCar());
  const Eigen::MatrixXd condensed = StateMatrix(CondensedVehicle(vehicle).At(vehicle.ParameterValues()));
  const Eigen::Index sprung = CoordinateOf(vehicle, "sprung");
  const Eigen::Index unsprung = CoordinateOf(vehicle, "unsprung");
  const std::array<Eigen::Index, 4> order = {sprung, unsprung, 2 + sprung, 2 + unsprung};
  const Eigen::Matrix4d analytic = ThesisCar().StateMatrix();
  // Second derivatives of lengths by differences leave 1e-12 per metre of weight: 2 kN / 22 kg.
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j < 4; ++j)
      EXPECT_NEAR(condensed(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(j)]), analytic(i, j),
                  1e-9);
}

TEST(QuarterCar, MultibodyRestsInItsDesignPose) {
  MultibodyCar multibody(Describe(ThesisCar()));
  // Rounding of 2 kN on 22 kg.
  EXPECT_LT(multibody.Derivative(Eigen::Vector4d::Zero()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(QuarterCar, HarmonicBalanceEqualsTheClosedResponse) {
  const Vehicle vehicle = Describe(ThesisCar());
  const Excitation excitation = SteppedSine(1.37);
  const FrequencyResponse response =
      SolveHarmonicBalance(CondensedVehicle(vehicle).At(vehicle.ParameterValues()), vehicle.sensors, excitation)
          .response;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    const auto closed = ThesisCar().Response(excitation.frequency_Hz[i]);
    // Linear: only rounding of the solve.
    EXPECT_LT(std::abs(response.Find("a_sprung")->response[i] - closed[0]), 1e-10);
    EXPECT_LT(std::abs(response.Find("a_unsprung")->response[i] - closed[1]), 1e-10);
    EXPECT_LT(std::abs(response.Find("s_strut")->response[i] - (closed[0] - closed[1])), 1e-10);
    const Complex force = ThesisCar().tyre_stiffness * (1.0 - closed[1]);
    EXPECT_LT(std::abs(response.Find("F_tyre")->response[i] - force), 1e-10 * ThesisCar().tyre_stiffness);
  }
}

TEST(QuarterCar, MarchEqualsTheClosedResponse) {
  const Vehicle vehicle = Describe(ThesisCar());
  Multibody multibody = Resting(vehicle);
  const Excitation excitation = SteppedSine(1.88);
  const MarchOptions options;
  const MarchedResponse marched = March(multibody, excitation, options);
  EXPECT_THAT(marched.unsteady, testing::IsEmpty());
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    const auto closed = ThesisCar().Response(excitation.frequency_Hz[i]);
    // What remains of the transient when it changes by less than the tolerance from window to window, and the
    // integrator's accuracy of 1e-8 m on amplitudes down to 0.3 mm.
    const double tolerance = 3 * options.tolerance + 10 * options.accuracy / excitation.amplitude_m[i];
    EXPECT_LT(std::abs(marched.response.Find("z_sprung")->response[i] / closed[0] - 1.0), tolerance);
    EXPECT_LT(std::abs(marched.response.Find("z_unsprung")->response[i] / closed[1] - 1.0), tolerance);
  }
}

TEST(QuarterCar, HarmonicBalanceOfABilinearDamperEqualsTheMarchedEquations) {
  ExpectBalanceEqualsMarch(BilinearCar(), Describe(BilinearCar()));
}

TEST(QuarterCar, HarmonicBalanceOfASeriesDamperEqualsTheMarchedEquations) {
  ExpectBalanceEqualsMarch(SeriesCar(), Describe(SeriesCar()));
}

TEST(QuarterCar, FreeDecayWithABilinearDamperFollowsTheEquations) {
  ExpectEqualDecay(BilinearCar(), Describe(BilinearCar()));
}

TEST(QuarterCar, FreeDecayWithASeriesDamperFollowsTheEquations) {
  ExpectEqualDecay(SeriesCar(), Describe(SeriesCar()));
}

}  // namespace
}  // namespace fourpost::quarter_car_test
