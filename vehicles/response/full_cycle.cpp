#include "vehicles/response/full_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>

#include "analysis/numerics/anderson_acceleration.h"
#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/laws/dahl_cycle.h"
#include "vehicles/laws/hydraulic_cycle.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/simulation/findings.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Of the multibody system's states.
constexpr double kMegapascal = 1e6;

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

/// Largest harmonic of a change, relative to that harmonic of the motion or to the first one, whichever is larger.
double RelativeSize(const Eigen::MatrixXcd& change, const Eigen::MatrixXcd& motion) {
  const Eigen::VectorXd sizes = motion.rowwise().norm();
  return change.rowwise().norm().cwiseQuotient(sizes.cwiseMax(sizes[1])).maxCoeff();
}

/// Of sizes that shrink from one iteration to the next.
class Convergence {
 public:
  /// What the next one will be, were it to shrink as this one did.
  double Next(double size) {
    const double before = std::exchange(before_, size);
    return before > 0 ? size * std::min(1.0, size / before) : size;
  }

 private:
  double before_ = 0;
};

}  // namespace

FullCycle::FullCycle(Multibody& multibody, const CondensedModel& model, const std::vector<double>& shape,
                     const FullBalanceOptions& options)
    : multibody_(multibody),
      shape_(shape),
      options_(options),
      full_(multibody, model),
      contact_(model, shape, {.tolerance = options.tolerance}),
      fine_{std::max(options.harmonics, options.fine_harmonics), std::max(options.samples, options.fine_samples)},
      coarse_(cycle().has_friction() ? Sampling{fine_.harmonics / 2, fine_.samples / 2}
                                     : Sampling{options.harmonics, options.samples}) {
  const LinearVehicle linear(model, LinearVehicle::Rates::kCentre);
  stiffness_ = linear.stiffness.diagonal().cwiseAbs();
  mass_ = Eigen::VectorXd::Zero(linear.size());
  mass_.head(linear.mass.rows()) = linear.mass.diagonal();
  coordinates_ = linear.mass.rows();
}

void FullCycle::Take(const Sampling& sampling) {
  transform_ = &CycleTransform::Shared(sampling.harmonics, sampling.samples);
  lacking_.resize(sampling.samples, mass_.size());
  readings_.resize(sampling.samples, sensors_.rows());
  memory_.setZero(sampling.samples,
                  static_cast<Eigen::Index>(2 * full_.hydraulics().size() + full_.frictions().size()));
  const Eigen::MatrixXcd before = std::exchange(added_, Eigen::MatrixXcd::Zero(sampling.harmonics + 1, mass_.size()));
  const Eigen::Index known = std::min(before.rows(), added_.rows());
  added_.topRows(known) = before.topRows(known);
}

bool FullCycle::Solve(double frequency_Hz, double amplitude_m) {
  omega_ = 2 * std::numbers::pi * frequency_Hz;
  const bool has_start = contact_.Solve(frequency_Hz, amplitude_m);
  const SensorHarmonics linearised = sensors_ = cycle().Sensors();
  if (!has_start) return false;
  added_.resize(0, mass_.size());
  Take(coarse_);
  bool converged = TryAt(amplitude_m) || SolveByWayOfLess(frequency_Hz, amplitude_m);
  if (converged && coarse_.samples < fine_.samples && DepartsFrom(linearised, amplitude_m)) {
    Take(fine_);
    converged = TryAt(amplitude_m);
  }
  if (!converged) sensors_ = linearised;
  return converged;
}

/// Whether any sensor does by so much that the share of it that coarse sampling errs by could be seen.
bool FullCycle::DepartsFrom(const SensorHarmonics& linearised, double amplitude_m) const {
  constexpr double kMuch = 0.01;
  // Next to a node less is not seen.
  constexpr double kNode = 0.01;
  const std::vector<Sensor>& sensors = multibody_.vehicle().sensors;
  std::map<Sensor::Type, double> loudest;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    double& size = loudest[sensors[i].type];
    // A unit may be silent as a whole.
    size = std::max({size, amplitude_m, std::abs(linearised(static_cast<Eigen::Index>(i), 1))});
  }
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double size = std::max(std::abs(linearised(row, 1)), kNode * loudest[sensors[i].type]);
    if (std::abs(sensors_(row, 1) - linearised(row, 1)) > kMuch * size) return true;
  }
  return false;
}

/// By way of smaller amplitudes, each from what the one before added.
bool FullCycle::SolveByWayOfLess(double frequency_Hz, double amplitude_m) {
  double before = 1;
  added_.setZero();
  for (const double share : {0.25, 0.45, 0.6, 0.75, 0.9, 1.0}) {
    // Departures are of second order.
    added_ *= std::pow(share / before, 2);
    before = share;
    if (!contact_.Solve(frequency_Hz, share * amplitude_m) || !cycle().SolveWith(added_)) return false;
    if (!TryAt(share * amplitude_m)) return false;
  }
  return true;
}

bool FullCycle::TryAt(double amplitude_m) {
  multibody_.SetPostMotion(SteadySine(shape_, amplitude_m, omega_));
  tension_aliases_.setZero(transform_->harmonics() + 1, cycle().directions().cols());
  try {
    return Iterate();
  } catch (const std::runtime_error&) {
    return false;  // An iterate that cannot be evaluated, or that the loops cannot follow.
  }
}

bool FullCycle::Iterate() {
  // Per coordinate the root of the stiffness and inertia against moving it alone: times these, lengths and angles
  // compare as roots of energies.
  const Eigen::VectorXd weights = (stiffness_ + omega_ * omega_ * mass_).cwiseSqrt();
  const auto weighted = [&weights](const Eigen::MatrixXcd& motion) -> Eigen::MatrixXcd {
    return motion * weights.asDiagonal();
  };
  AndersonAcceleration acceleration(options_.history);
  Eigen::MatrixXcd motion = cycle().Coordinates(transform_->harmonics());
  Convergence of_motion;
  Convergence of_departure;
  for (int iteration = 0; iteration < options_.max_iterations; ++iteration) {
    if (!motion.allFinite()) return false;
    // The first is never the last: its sensors need not be read.
    const Eigen::MatrixXcd step = Departure(motion, iteration > 0);
    const double left = of_departure.Next(RelativeSize(weighted(step), weighted(motion)));
    added_ = Unstacked(acceleration.Next(Stacked(weighted(added_)), Stacked(weighted(step))), added_.rows()) *
             weights.cwiseInverse().asDiagonal();
    if (!cycle().SolveWith(added_)) return false;
    const Eigen::MatrixXcd before = std::exchange(motion, cycle().Coordinates(transform_->harmonics()));
    const double next = of_motion.Next(RelativeSize(weighted(motion - before), weighted(motion)));
    // Acceleration may stand still far from where the two systems agree.
    if (iteration > 0 && next <= options_.tolerance && left <= options_.tolerance) {
      sensors_ = cycle().Sensors() + sensor_departure_;
      return true;
    }
  }
  return false;
}

/// What more must be added for the full system to move as the linearised one does now, from what it lacks to do so.
/// Laws with kinks err by coarse samples; they err alike in both systems, and so not in the difference. How the
/// tensions of elements with a memory err by them is known.
Eigen::MatrixXcd FullCycle::Departure(const Eigen::MatrixXcd& motion, bool read) {
  SampleCycle(motion, read);
  Eigen::MatrixXcd lacking;
  transform_->ToHarmonics(lacking_, lacking);
  const Eigen::MatrixXcd coarse = cycle().RemainderBy(*transform_);
  if (read) {
    Eigen::MatrixXcd readings;
    transform_->ToHarmonics(readings_, readings);
    sensor_departure_ = readings.topRows(3).transpose() - cycle().SensorsBy(coarse);
  }
  Eigen::MatrixXcd aliases = coarse;
  const Eigen::Index known = std::min(coarse.rows(), cycle().remainder().rows());
  aliases.topRows(known) -= cycle().remainder().topRows(known);
  for (const std::vector<std::size_t>& elements : {full_.hydraulics(), full_.frictions()})
    for (const std::size_t j : elements)
      aliases.col(static_cast<Eigen::Index>(j)) = tension_aliases_.col(static_cast<Eigen::Index>(j));
  return cycle().MotionBy(aliases * cycle().directions().transpose() - lacking);
}

void FullCycle::SampleCycle(const Eigen::MatrixXcd& motion, bool read) {
  const Eigen::Index samples = transform_->samples();
  const Eigen::VectorXcd rate = Rates(transform_->harmonics());
  const Eigen::MatrixXcd rates = rate.asDiagonal() * motion;
  Eigen::MatrixXd position;
  Eigen::MatrixXd velocity;
  Eigen::MatrixXd acceleration;
  transform_->ToTime(motion, position);
  transform_->ToTime(rates, velocity);
  transform_->ToTime(rate.asDiagonal() * rates, acceleration);
  if (full_.HasMemory()) FindMemory(position);
  const Eigen::Index n = coordinates_;
  for (Eigen::Index k = 0; k < samples; ++k) {
    const double t = 2 * std::numbers::pi * static_cast<double>(k) / (omega_ * static_cast<double>(samples));
    lacking_.row(k) = full_
                          .At(t, {.position = position.row(k).transpose(),
                                  .rate = velocity.row(k).transpose(),
                                  .acceleration = acceleration.row(k).head(n).transpose(),
                                  .memory = memory_.row(k).transpose()})
                          .transpose();
    if (read) readings_.row(k) = full_.Readings().transpose();
  }
}

void FullCycle::FindMemory(const Eigen::MatrixXd& position) {
  const Eigen::Index samples = transform_->samples();
  std::vector<std::size_t> elements = full_.hydraulics();
  elements.insert(elements.end(), full_.frictions().begin(), full_.frictions().end());
  Eigen::MatrixXd extensions(samples, static_cast<Eigen::Index>(elements.size()));
  for (Eigen::Index k = 0; k < samples; ++k)
    extensions.row(k) = full_.MemoryExtensions(position.row(k).transpose()).transpose();
  Eigen::MatrixXcd full;
  transform_->ToHarmonics(extensions, full);
  const Eigen::MatrixXcd& linearised = cycle().extension();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    Eigen::VectorXcd extension = Eigen::VectorXcd::Zero(std::max(linearised.rows(), full.rows()));
    extension.head(linearised.rows()) = linearised.col(static_cast<Eigen::Index>(elements[i]));
    extension.head(full.rows()) = full.col(static_cast<Eigen::Index>(i));
    const std::size_t oil = full_.hydraulics().size();
    if (i < oil) FindPressures(i, StepsOf(extension));
    else FindFriction(i - oil, StepsOf(extension));
  }
}

/// At least as many steps as the linearised cycle needed, the samples among them.
FullCycle::SteppedCycle FullCycle::StepsOf(const Eigen::VectorXcd& extension) const {
  const Eigen::Index samples = transform_->samples();
  const Eigen::Index highest = extension.size() - 1;
  SteppedCycle cycle{.stride = std::max(this->cycle().steps(), 4 * highest + 4) / samples + 1};
  const CycleTransform& fine =
      CycleTransform::Shared(static_cast<int>(highest), static_cast<int>(cycle.stride * samples));
  fine.ToTime(extension, cycle.extensions);
  fine.ToTime(Rates(highest).asDiagonal() * extension, cycle.rates);
  return cycle;
}

void FullCycle::FindPressures(std::size_t damper, const SteppedCycle& steps) {
  const std::size_t port = full_.hydraulics()[damper];
  const auto& law = std::get<HydraulicRemainder>(cycle().ports()[port].law).law;
  const auto count = static_cast<std::size_t>(steps.extensions.rows());
  const std::optional<HydraulicCycle> cycle = HydraulicCycle::Solve(
      law, 2 * std::numbers::pi / omega_, {steps.extensions.data(), count}, {steps.rates.data(), count});
  if (!cycle) throw SimulationError(kChamberCloses);
  Eigen::MatrixXd tensions(steps.extensions.rows(), 1);
  for (std::size_t k = 0; k < count; ++k) tensions(static_cast<Eigen::Index>(k), 0) = cycle->states()[k].tension;
  for (Eigen::Index k = 0; k < transform_->samples(); ++k) {
    const std::array<double, 2>& pressures = cycle->states()[static_cast<std::size_t>(k * steps.stride)].pressures;
    for (std::size_t c = 0; c < 2; ++c)
      memory_(k, static_cast<Eigen::Index>(2 * damper + c)) = (pressures[c] - law.damper.Rest()[c]) / kMegapascal;
  }
  NoteAliases(port, tensions);
}

void FullCycle::FindFriction(std::size_t friction, const SteppedCycle& steps) {
  const std::size_t port = full_.frictions()[friction];
  const DahlFriction& law = std::get<FrictionRemainder>(cycle().ports()[port].law).law;
  const auto count = static_cast<std::size_t>(steps.extensions.rows());
  const DahlCycle cycle(law, {steps.extensions.data(), count});
  const Eigen::Map<const Eigen::VectorXd> tensions(cycle.forces().data(), steps.extensions.rows());
  const auto column = static_cast<Eigen::Index>(2 * full_.hydraulics().size() + friction);
  for (Eigen::Index k = 0; k < transform_->samples() && law.force > 0; ++k)
    memory_(k, column) = tensions[k * steps.stride] / law.force;
  NoteAliases(port, tensions);
}

/// `tensions`: at the steps of a cycle.
void FullCycle::NoteAliases(std::size_t port, const Eigen::MatrixXd& tensions) {
  const Eigen::Index samples = transform_->samples();
  const Eigen::Index stride = tensions.rows() / samples;
  Eigen::MatrixXd sampled(samples, 1);
  for (Eigen::Index k = 0; k < samples; ++k) sampled(k, 0) = tensions(k * stride, 0);
  Eigen::MatrixXcd of_samples;
  Eigen::MatrixXcd of_steps;
  transform_->ToHarmonics(sampled, of_samples);
  CycleTransform::Shared(transform_->harmonics(), static_cast<int>(tensions.rows())).ToHarmonics(tensions, of_steps);
  tension_aliases_.col(static_cast<Eigen::Index>(port)) = of_samples - of_steps;
}

/// Of the harmonics 0, 1, .. to the highest, by amplitude.
Eigen::VectorXcd FullCycle::Rates(Eigen::Index highest) const {
  return Complex(0, omega_) * Eigen::VectorXd::LinSpaced(highest + 1, 0, static_cast<double>(highest));
}

}  // namespace fourpost
