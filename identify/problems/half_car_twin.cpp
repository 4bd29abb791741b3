#include "identify/problems/half_car_twin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <ceres/jet.h>

#include "identify/search/draws.h"
#include "vehicles/closed_form/half_car.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost {
namespace {

constexpr double kFrontLength_m = 1.2;
constexpr double kRearLength_m = 1.4;
constexpr double kVelocity_mps = 0.15;
constexpr double kNoise = 0.01;
constexpr int kChannels = 6;

constexpr std::array<const char*, 12> kNames = {"ms",  "Is",  "mf",  "mr",  "kf",  "kr",
                                                "ktf", "ktr", "dfb", "dfr", "drb", "drr"};
// Both sides together: kg, kg m^2, kg, N/m, N s/m.
constexpr std::array<double, 12> kTruth = {1650, 2600, 240, 260, 62000, 84000, 560000, 600000, 2900, 6400, 3300, 7200};

constexpr double kOutOfBoundsTarget = 4.44983e7;

HalfCar Car(const Eigen::VectorXd& p) {
  return {.sprung_mass = p[0],
          .pitch_inertia = p[1],
          .front_mass = p[2],
          .rear_mass = p[3],
          .front_stiffness = p[4],
          .rear_stiffness = p[5],
          .front_tyre_stiffness = p[6],
          .rear_tyre_stiffness = p[7],
          .front_damper = DashpotLaw(p[8], p[9]),
          .rear_damper = DashpotLaw(p[10], p[11]),
          .front_length = kFrontLength_m,
          .rear_length = kRearLength_m};
}

// A fifth to four times the truth, at the precisions of the thesis (ch. 5).
Lattice Space() {
  std::vector<LatticeAxis> axes;
  for (std::size_t j = 0; j < kTruth.size(); ++j) {
    const double precision = j < 4 ? 0.1 : j < 8 ? 10 : 1;
    axes.push_back({.name = kNames[j], .lower = 0.2 * kTruth[j], .upper = 4 * kTruth[j], .precision = precision});
  }
  return Lattice(axes);
}

// Too little inertia, too stiff a tyre in front, too much bump damping at the rear.
Lattice WrongSpace() {
  std::vector<LatticeAxis> axes = Space().axes();
  axes[1].upper = 0.35 * kTruth[1];
  axes[6].lower = 1.66 * kTruth[6];
  axes[10].lower = 1.81 * kTruth[10];
  return Lattice(axes);
}

double Noise(std::int64_t sample, std::size_t channel) {
  Draws draws(12, DrawPurpose::kNoise, sample, channel);
  return draws.Normal();
}

// ---- time

constexpr double kStep_s = 0.005;
constexpr int kSteps = 1200;

// Heights (front, rear) whose velocity is a sine of 0.15 m/s with a frequency that sweeps.
struct Sweep {
  // Phases at each half step.
  std::vector<Eigen::Vector2d> height;

  Sweep() {
    const double duration = kSteps * kStep_s;
    Eigen::Vector2d z = Eigen::Vector2d::Zero();
    constexpr int kFine = 8;
    const double h = kStep_s / 2 / kFine;
    for (int i = 0; i <= 2 * kSteps; ++i) {
      height.push_back(z);
      for (int k = 0; k < kFine; ++k) {
        const double t = i * kStep_s / 2 + (k + 0.5) * h;
        const double ratio = std::log(14 / 0.5);
        const double front = 2 * std::numbers::pi * 0.5 * duration / ratio * std::expm1(t / duration * ratio);
        const double rear = 2 * std::numbers::pi * (7 * t + (11 - 7) * t * t / 2 / duration);
        z += h * kVelocity_mps * Eigen::Vector2d(std::cos(front), std::cos(rear));
      }
    }
  }
};

using Jet = ceres::Jet<double, kTruth.size()>;

template <typename T>
using SignalsOf = Eigen::Matrix<T, Eigen::Dynamic, kChannels>;
using Signals = SignalsOf<double>;

template <typename T>
using Vector4 = Eigen::Vector<T, 4>;

template <typename T>
struct BilinearDamper {
  T compression;
  T rebound;
  T Force(const T& rate) const { return (rate > T(0) ? rebound : compression) * rate; }
};

// A HalfCar of numbers that may carry derivatives.
template <typename T>
struct MovingCar {
  T sprung_mass, pitch_inertia, front_mass, rear_mass, front_stiffness, rear_stiffness;
  T front_tyre_stiffness, rear_tyre_stiffness;
  BilinearDamper<T> front_damper, rear_damper;
  double front_length = kFrontLength_m, rear_length = kRearLength_m;

  // In the order of kNames.
  explicit MovingCar(const std::array<T, kTruth.size()>& p)
      : sprung_mass(p[0]),
        pitch_inertia(p[1]),
        front_mass(p[2]),
        rear_mass(p[3]),
        front_stiffness(p[4]),
        rear_stiffness(p[5]),
        front_tyre_stiffness(p[6]),
        rear_tyre_stiffness(p[7]),
        front_damper{p[8], p[9]},
        rear_damper{p[10], p[11]} {}

  Vector4<T> Acceleration(const Vector4<T>& q, const Vector4<T>& rate, const Eigen::Vector2d& ground) const {
    return HalfCarAcceleration<T>(*this, q, rate, ground);
  }
};

// Body over the front and rear axle, both axles, both tyre forces.
template <typename T>
Eigen::Matrix<T, 1, kChannels> Read(const MovingCar<T>& car, const Vector4<T>& q, const Vector4<T>& a,
                                    const Eigen::Vector2d& ground) {
  Eigen::Matrix<T, 1, kChannels> y;
  y << a[0] - car.front_length * a[1], a[0] + car.rear_length * a[1], a[2], a[3],
      car.front_tyre_stiffness * (ground[0] - q[2]), car.rear_tyre_stiffness * (ground[1] - q[3]);
  return y;
}

template <typename T>
SignalsOf<T> Simulate(const MovingCar<T>& car, const Sweep& sweep) {
  SignalsOf<T> signals(kSteps + 1, kChannels);
  Vector4<T> q = Vector4<T>::Zero(), v = Vector4<T>::Zero();
  const T h(kStep_s);
  for (int i = 0;; ++i) {
    const std::size_t k = 2 * static_cast<std::size_t>(i);
    const Vector4<T> a1 = car.Acceleration(q, v, sweep.height[k]);
    signals.row(i) = Read(car, q, a1, sweep.height[k]);
    if (i == kSteps) return signals;
    const Vector4<T> v2 = v + h / 2.0 * a1;
    const Vector4<T> a2 = car.Acceleration(q + h / 2.0 * v, v2, sweep.height[k + 1]);
    const Vector4<T> v3 = v + h / 2.0 * a2;
    const Vector4<T> a3 = car.Acceleration(q + h / 2.0 * v2, v3, sweep.height[k + 1]);
    const Vector4<T> v4 = v + h * a3;
    const Vector4<T> a4 = car.Acceleration(q + h * v3, v4, sweep.height[k + 2]);
    q += h / 6.0 * (v + T(2) * v2 + T(2) * v3 + v4);
    v += h / 6.0 * (a1 + T(2) * a2 + T(2) * a3 + a4);
  }
}

MovingCar<double> Moving(const Eigen::VectorXd& values) {
  std::array<double, kTruth.size()> p;
  std::copy(values.begin(), values.end(), p.begin());
  return MovingCar<double>(p);
}

MovingCar<Jet> Differentiated(const Eigen::VectorXd& values) {
  std::array<Jet, kTruth.size()> p;
  for (int j = 0; j < values.size(); ++j) p[static_cast<std::size_t>(j)] = Jet(values[j], j);
  return MovingCar<Jet>(p);
}

struct TimeRecording {
  Sweep sweep;
  Signals signals;
  Eigen::Matrix<double, 1, kChannels> sd;

  TimeRecording() : signals(Simulate(Moving(HalfCarTruth()), sweep)) {
    sd = kNoise * (signals.colwise().squaredNorm() / static_cast<double>(signals.rows())).cwiseSqrt();
    for (Eigen::Index i = 0; i < signals.rows(); ++i)
      for (Eigen::Index c = 0; c < kChannels; ++c) signals(i, c) += sd[c] * Noise(i, static_cast<std::size_t>(c));
  }

  Eigen::VectorXd Residuals(const Eigen::VectorXd& values) const {
    const Signals scaled = (Simulate(Moving(values), sweep) - signals).array().rowwise() / sd.array();
    return scaled.reshaped();
  }

  Eigen::MatrixXd Jacobian(const Eigen::VectorXd& values) const {
    const SignalsOf<Jet> modelled = Simulate(Differentiated(values), sweep);
    Eigen::MatrixXd jacobian(modelled.size(), values.size());
    for (Eigen::Index c = 0; c < kChannels; ++c)
      for (Eigen::Index i = 0; i < modelled.rows(); ++i)
        jacobian.row(c * modelled.rows() + i) = modelled(i, c).v.transpose() / sd[c];
    return jacobian;
  }
};

// ---- frequency

constexpr int kFrequencies = 30;

std::vector<Sensor> Sensors() {
  std::vector<Sensor> sensors(kChannels);
  for (std::size_t c = 0; c < kChannels; ++c) {
    sensors[c].name = "channel " + std::to_string(c);
    sensors[c].type = c < 4 ? Sensor::Type::kAccelerometer : Sensor::Type::kLoadCell;
  }
  return sensors;
}

CondensedModel Measured(const HalfCar& car) {
  CondensedModel model = car.Model();
  for (Eigen::MatrixXd* rows : {&model.on_position, &model.on_velocity, &model.on_acceleration})
    *rows = Eigen::MatrixXd::Zero(kChannels, 4);
  for (Eigen::MatrixXd* rows : {&model.on_post_height, &model.on_post_velocity, &model.on_post_acceleration})
    *rows = Eigen::MatrixXd::Zero(kChannels, 2);
  model.on_acceleration.row(0) << 1, -car.front_length, 0, 0;
  model.on_acceleration.row(1) << 1, car.rear_length, 0, 0;
  model.on_acceleration(2, 2) = model.on_acceleration(3, 3) = 1;
  model.on_position(4, 2) = -car.front_tyre_stiffness;
  model.on_position(5, 3) = -car.rear_tyre_stiffness;
  model.on_post_height(4, 0) = car.front_tyre_stiffness;
  model.on_post_height(5, 1) = car.rear_tyre_stiffness;
  return model;
}

std::vector<Excitation> BounceAndPitch() {
  Excitation bounce;
  for (int i = 0; i < kFrequencies; ++i) {
    bounce.frequency_Hz.push_back(0.5 * std::pow(14 / 0.5, i / (kFrequencies - 1.0)));
    bounce.amplitude_m.push_back(kVelocity_mps / (2 * std::numbers::pi * bounce.frequency_Hz.back()));
  }
  Excitation pitch = bounce;
  bounce.shape = {1, 1};
  pitch.shape = {1, -1};
  return {bounce, pitch};
}

using Phasors = std::vector<std::complex<double>>;

// Nothing when the balance does not converge.
Phasors Respond(const HalfCar& car, const std::vector<Excitation>& excitations) {
  // The error of gains it leaves is a fiftieth of the noise.
  static const HarmonicBalanceOptions options;
  const CondensedModel model = Measured(car);
  const std::vector<Sensor> sensors = Sensors();
  Phasors phasors;
  for (const Excitation& excitation : excitations) {
    const PeriodicResponse response = SolveHarmonicBalance(model, sensors, excitation, options);
    if (!response.unconverged_Hz.empty()) return {};
    for (const ChannelResponse& channel : response.response.channels)
      phasors.insert(phasors.end(), channel.response.begin(), channel.response.end());
  }
  return phasors;
}

struct FrequencyRecording {
  std::vector<Excitation> excitations = BounceAndPitch();
  Phasors measured = Respond(Car(HalfCarTruth()), excitations);

  FrequencyRecording() {
    for (std::size_t i = 0; i < measured.size(); ++i) {
      const auto sample = static_cast<std::int64_t>(i);
      measured[i] *= 1.0 + kNoise * std::complex<double>(Noise(sample, kChannels), Noise(sample, kChannels + 1));
    }
  }

  Evaluation Residuals(const Eigen::VectorXd& values) const {
    const Phasors modelled = Respond(Car(values), excitations);
    if (modelled.empty()) return Failed(Failure::kNotConverged, "the harmonic balance did not converge");
    Evaluation evaluation;
    evaluation.residuals.resize(static_cast<Eigen::Index>(2 * measured.size()));
    for (std::size_t i = 0; i < measured.size(); ++i) {
      // ln(gain) and phase [rad] of the ratio: 1 % of either is 0.086 dB or 0.57 degrees.
      const std::complex<double> error = std::log(modelled[i] / measured[i]) / kNoise;
      evaluation.residuals.segment<2>(static_cast<Eigen::Index>(2 * i)) << error.real(), error.imag();
    }
    return evaluation;
  }
};

TestProblem Twin(std::function<Evaluation(const Eigen::VectorXd&)> evaluate) {
  const Evaluation truth = evaluate(HalfCarTruth());
  return {{Space(), std::move(evaluate), truth.residuals.size()}, 1.02 * truth.cost()};
}

}  // namespace

Eigen::VectorXd HalfCarTruth() { return Eigen::Map<const Eigen::VectorXd>(kTruth.data(), kTruth.size()); }

TestProblem HalfCarInTime() {
  const auto recording = std::make_shared<const TimeRecording>();
  TestProblem twin = Twin([recording](const Eigen::VectorXd& values) {
    Evaluation evaluation;
    evaluation.residuals = recording->Residuals(values);
    return evaluation;
  });
  twin.problem.differentiate = [recording](const Eigen::VectorXd& values) { return recording->Jacobian(values); };
  return twin;
}

TestProblem HalfCarOutOfBounds() {
  TestProblem twin = HalfCarInTime();
  twin.problem.lattice = WrongSpace();
  twin.target_cost = kOutOfBoundsTarget;
  return twin;
}

TestProblem HalfCarInFrequency() {
  const auto recording = std::make_shared<const FrequencyRecording>();
  return Twin([recording](const Eigen::VectorXd& values) { return recording->Residuals(values); });
}

}  // namespace fourpost
