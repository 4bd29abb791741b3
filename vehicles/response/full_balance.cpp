#include "vehicles/response/full_balance.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "analysis/option_check.h"
#include "vehicles/laws/count_check.h"
#include "vehicles/response/anderson_acceleration.h"
#include "vehicles/response/cycle_transform.h"
#include "vehicles/response/linearised_cycle.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Derivative of the harmonics at `omega` of Multibody::Residual by those of [s z], about the design pose and with the
/// centre rate c of each dashpot of direction b. A series damper with its spring k:
///   on s:  k b z,   on its own row:  k z - i w c (b . s - z).
Eigen::MatrixXcd MeanImpedance(const CondensedModel& model, double omega) {
  const std::vector<const CondensedModel::Dashpot*> series = model.SeriesDampers();
  const Complex iw(0, omega);
  const Eigen::Index n = model.mass.rows();
  const Eigen::Index size = n + static_cast<Eigen::Index>(series.size());
  Eigen::MatrixXcd impedance = Eigen::MatrixXcd::Zero(size, size);
  impedance.topLeftCorner(n, n) = model.stiffness + iw * model.damping + iw * iw * model.mass;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots)
    if (!dashpot.HasSeries())
      impedance.topLeftCorner(n, n) += iw * dashpot.CentreRate() * dashpot.direction * dashpot.direction.transpose();
  for (std::size_t j = 0; j < series.size(); ++j) {
    const Eigen::Index row = n + static_cast<Eigen::Index>(j);
    const Complex resistance = iw * series[j]->CentreRate();
    impedance.col(row).head(n) = series[j]->series.stiffness * series[j]->direction;
    impedance.row(row).head(n) = -resistance * series[j]->direction.transpose();
    impedance(row, row) = series[j]->series.stiffness + resistance;
  }
  return impedance;
}

/// Per unknown the root of the stiffness and inertia against moving it alone [sqrt(N/m), sqrt(N m)]: times these,
/// lengths and angles compare as roots of energies.
Eigen::VectorXd EnergyWeights(const CondensedModel& model, double omega) {
  const std::vector<const CondensedModel::Dashpot*> series = model.SeriesDampers();
  const Eigen::Index n = model.mass.rows();
  Eigen::VectorXd weights(n + static_cast<Eigen::Index>(series.size()));
  weights.head(n) = model.stiffness.diagonal().cwiseAbs() + omega * omega * model.mass.diagonal();
  for (std::size_t j = 0; j < series.size(); ++j)
    weights[n + static_cast<Eigen::Index>(j)] = series[j]->series.stiffness;
  return weights.cwiseSqrt();
}

/// Posts that move as Re(shape amplitude exp(i w t)).
PostMotion SteadySine(const std::vector<double>& shape, double amplitude, double omega) {
  return [=](double t, std::span<PostState> posts) {
    const double z = amplitude * std::cos(omega * t);
    const double v = -amplitude * omega * std::sin(omega * t);
    for (std::size_t p = 0; p < shape.size(); ++p)
      posts[p] = {shape[p] * z, shape[p] * v, -omega * omega * shape[p] * z};
  };
}

/// Real and imaginary parts as one vector, and back.
Eigen::VectorXd Stacked(const Eigen::MatrixXcd& harmonics) {
  Eigen::VectorXd stacked(2 * harmonics.size());
  stacked << harmonics.real().reshaped(), harmonics.imag().reshaped();
  return stacked;
}
Eigen::MatrixXcd Unstacked(const Eigen::VectorXd& stacked, Eigen::Index rows) {
  const Eigen::Index half = stacked.size() / 2;
  Eigen::MatrixXcd harmonics(rows, half / rows);
  harmonics.real() = stacked.head(half).reshaped(rows, half / rows);
  harmonics.imag() = stacked.tail(half).reshaped(rows, half / rows);
  return harmonics;
}

/// Largest step of a harmonic, relative to that harmonic or to the first one, whichever is larger.
double RelativeStep(const Eigen::MatrixXcd& step, const Eigen::MatrixXcd& harmonics) {
  const Eigen::VectorXd sizes = harmonics.rowwise().norm();
  return step.rowwise().norm().cwiseQuotient(sizes.cwiseMax(sizes[1])).maxCoeff();
}

/// One frequency at a time. Harmonics of [s z] in rows, one unknown per column.
class FullCycle {
 public:
  FullCycle(Multibody& multibody, const CondensedModel& model, const FullBalanceOptions& options)
      : multibody_(multibody),
        model_(model),
        options_(options),
        transform_(options.harmonics, options.samples),
        impedance_(static_cast<std::size_t>(options.harmonics + 1)) {}

  /// Harmonics of the sensors, sensors x (H + 1); nothing where the iteration does not converge.
  /// Throws std::runtime_error when an iterate cannot be evaluated.
  std::optional<SensorHarmonics> Solve(double frequency_Hz, Eigen::MatrixXcd harmonics) {
    omega_ = 2 * std::numbers::pi * frequency_Hz;
    for (int h = 0; h <= options_.harmonics; ++h)
      impedance_[static_cast<std::size_t>(h)].compute(MeanImpedance(model_, h * omega_));
    const Eigen::VectorXd weights = EnergyWeights(model_, omega_);
    AndersonAcceleration acceleration(options_.history);
    for (int iteration = 0; iteration < options_.max_iterations; ++iteration) {
      if (!harmonics.allFinite()) return {};
      const Eigen::MatrixXcd scaled = harmonics * weights.asDiagonal();
      const Eigen::MatrixXcd step = Correction(harmonics) * weights.asDiagonal();
      const Eigen::VectorXd next = acceleration.Next(Stacked(scaled), Stacked(step));
      harmonics = Unstacked(next, harmonics.rows()) * weights.cwiseInverse().asDiagonal();
      if (RelativeStep(step, scaled) <= options_.tolerance) return Sensors(harmonics);
    }
    return {};
  }

 private:
  /// [q u z] at each sample of the cycle and its derivative, samples in columns.
  struct Motion {
    Eigen::MatrixXd state;
    Eigen::MatrixXd derivative;
  };

  double Time(Eigen::Index sample) const {
    return 2 * std::numbers::pi * static_cast<double>(sample) / (omega_ * options_.samples);
  }

  Motion MotionOf(const Eigen::MatrixXcd& harmonics) const {
    const Eigen::Index n = multibody_.coordinate_count();
    const Eigen::Index series = harmonics.cols() - n;
    const Eigen::VectorXcd rates =
        Complex(0, omega_) * Eigen::VectorXd::LinSpaced(harmonics.rows(), 0, options_.harmonics);
    Eigen::MatrixXd position;
    Eigen::MatrixXd velocity;
    Eigen::MatrixXd acceleration;
    transform_.ToTime(harmonics, position);
    transform_.ToTime(rates.asDiagonal() * harmonics, velocity);
    transform_.ToTime(rates.cwiseAbs2().asDiagonal() * -harmonics, acceleration);
    Motion motion;
    motion.state.resize(2 * n + series, options_.samples);
    motion.derivative.resize(2 * n + series, options_.samples);
    motion.state << (position.leftCols(n).rowwise() + multibody_.design_pose().transpose()).transpose(),
        velocity.leftCols(n).transpose(), position.rightCols(series).transpose();
    motion.derivative << velocity.leftCols(n).transpose(), acceleration.leftCols(n).transpose(),
        velocity.rightCols(series).transpose();
    return motion;
  }

  /// - impedance^-1 times the residual, per harmonic.
  Eigen::MatrixXcd Correction(const Eigen::MatrixXcd& harmonics) const {
    const Motion motion = MotionOf(harmonics);
    Eigen::MatrixXd residual(options_.samples, harmonics.cols());
    for (Eigen::Index k = 0; k < options_.samples; ++k)
      residual.row(k) = multibody_.Residual(Time(k), motion.state.col(k), motion.derivative.col(k)).transpose();
    Eigen::MatrixXcd correction;
    transform_.ToHarmonics(residual, correction);
    for (Eigen::Index h = 0; h < correction.rows(); ++h)
      correction.row(h) =
          -impedance_[static_cast<std::size_t>(h)].solve(correction.row(h).transpose().eval()).transpose();
    return correction;
  }

  /// Accelerations are those that the forces in each sampled state cause.
  SensorHarmonics Sensors(const Eigen::MatrixXcd& harmonics) const {
    const Motion motion = MotionOf(harmonics);
    Eigen::MatrixXd readings(options_.samples, static_cast<Eigen::Index>(multibody_.vehicle().sensors.size()));
    for (Eigen::Index k = 0; k < options_.samples; ++k)
      readings.row(k) = multibody_.Readings(Time(k), motion.state.col(k)).transpose();
    Eigen::MatrixXcd sensors;
    transform_.ToHarmonics(readings, sensors);
    return sensors.transpose();
  }

  Multibody& multibody_;
  const CondensedModel& model_;
  const FullBalanceOptions& options_;
  CycleTransform transform_;
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXcd>> impedance_;
  double omega_ = 0;
};

Eigen::MatrixXcd Start(const LinearisedCycle& linearised, int harmonics) {
  const Eigen::MatrixXcd motion = linearised.Motion(harmonics);
  const Eigen::MatrixXcd series = linearised.SeriesExtensions(harmonics);
  Eigen::MatrixXcd start(motion.rows(), motion.cols() + series.cols());
  start << motion, series;
  return start;
}

/// Nothing also when an iterate leaves what can be evaluated.
std::optional<SensorHarmonics> TrySolve(FullCycle& cycle, double frequency_Hz, const Eigen::MatrixXcd& start) {
  try {
    return cycle.Solve(frequency_Hz, start);
  } catch (const std::runtime_error&) {
    return {};
  }
}

void CheckFit(const Vehicle& vehicle, const CondensedModel& model, const Excitation& excitation) {
  if (vehicle.HasLoops())
    throw std::invalid_argument("vehicle '" + vehicle.name +
                                "': loop closures (fp:rod, fp:ball, fp:weld, fp:hinge) are not supported by this "
                                "engine; use march");
  for (const Damper& damper : vehicle.dampers)
    if (damper.hydraulic)
      throw std::invalid_argument("vehicle '" + vehicle.name + "': fp:damper '" + damper.name +
                                  "' is hydraulic, which this engine does not support; use march");
  excitation.Validate(vehicle.posts.size());
  const auto count = [](Eigen::Index n) { return static_cast<std::size_t>(n); };
  RequireCount("SolveFullBalance: model", "posts", vehicle.posts.size(), count(model.post_stiffness.cols()));
  RequireCount("SolveFullBalance: model", "sensors", vehicle.sensors.size(), count(model.on_position.rows()));
}

}  // namespace

void FullBalanceOptions::Validate() const {
  RequireOption(harmonics >= 2, "harmonics", harmonics, "at least 2");
  RequireOption(samples % 4 == 0 && samples > 2 * harmonics, "samples", samples,
                "a multiple of 4 and more than twice the harmonics");
  RequireOption(tolerance > 0, "tolerance", tolerance, "positive");
  RequireOption(max_iterations >= 1, "max_iterations", max_iterations, "at least 1");
  RequireOption(history >= 0, "history", history, "at least 0");
}

PeriodicResponse SolveFullBalance(Multibody& multibody, const CondensedModel& model, const Excitation& excitation,
                                  const FullBalanceOptions& options) {
  options.Validate();
  const Vehicle& vehicle = multibody.vehicle();
  CheckFit(vehicle, model, excitation);
  LinearisedCycle linearised(model, excitation.shape, {.tolerance = options.tolerance});
  FullCycle cycle(multibody, model, options);
  ResponseRecorder recorder(vehicle.sensors, excitation);
  PeriodicResponse out;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    const double frequency = excitation.frequency_Hz[i];
    const double amplitude = excitation.amplitude_m[i];
    // An unconverged start is a start too.
    linearised.Solve(frequency, amplitude);
    multibody.SetPostMotion(SteadySine(excitation.shape, amplitude, 2 * std::numbers::pi * frequency));
    const std::optional<SensorHarmonics> sensors = TrySolve(cycle, frequency, Start(linearised, options.harmonics));
    if (!sensors) out.unconverged_Hz.push_back(frequency);
    recorder.Record(i, sensors ? *sensors : linearised.Sensors());
  }
  multibody.SetPostMotion(nullptr);
  out.response = recorder.Take();
  return out;
}

}  // namespace fourpost
