#include "vehicles/linearised_cycle.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Harmonics and samples of level 0, 1, ...: 5 and 32, 9 and 64, 17 and 128, ...
int HarmonicsOf(std::size_t level) { return (4 << level) + 1; }
int SamplesOf(std::size_t level) { return 32 << level; }

}  // namespace

LinearisedCycle::LinearisedCycle(const CondensedModel& model, const std::vector<double>& shape,
                                 const HarmonicBalanceOptions& options)
    : model_(model),
      shape_(Eigen::Map<const Eigen::VectorXd>(shape.data(), static_cast<Eigen::Index>(shape.size()))),
      options_(options),
      ports_(PortsOf(model)),
      receptance_(model, ports_, shape),
      has_memory_(std::any_of(ports_.begin(), ports_.end(), [](const Port& port) { return UsesExtension(port.law); })) {
}

bool LinearisedCycle::Solve(double frequency_Hz, double amplitude_m) {
  omega_ = 2 * std::numbers::pi * frequency_Hz;
  unit_driven_ = receptance_.Driven(omega_);
  iterations_ = 0;
  SetAmplitude(amplitude_m);
  solved_before_ = TrySolve() || SolveRisingAmplitude(amplitude_m);
  return solved_before_;
}

void LinearisedCycle::SetAmplitude(double amplitude_m) {
  amplitude_ = amplitude_m;
  driven_ = amplitude_m * unit_driven_;
}

/// From few harmonics to as many as the error needs.
bool LinearisedCycle::TrySolve() {
  Eigen::MatrixXcd start(2, driven_.size());
  start << Eigen::VectorXcd::Zero(driven_.size()).transpose(), driven_.transpose();
  if (has_memory_ && solved_before_) start = cycle().extension();
  std::size_t level = level_ > 0 ? level_ - 1 : 0;
  if (!SolveLevel(level, start)) return false;
  if (ports_.empty()) return true;
  while (HarmonicsOf(level + 1) <= options_.most_harmonics) {
    const Eigen::VectorXcd before = SensorsAt(1);
    if (!SolveLevel(++level, cycle().extension())) return false;
    // What kinks leave falls with the square of the samples: a third of this change is left.
    if (SensorChange(before) <= 3 * options_.error) return true;
  }
  return false;
}

/// Up to the amplitude in steps, each from the solution of the one before.
bool LinearisedCycle::SolveRisingAmplitude(double amplitude_m) {
  constexpr int kSteps = 8;
  if (ports_.empty()) return false;
  solved_before_ = false;
  for (int i = 1; i <= kSteps; ++i) {
    SetAmplitude(amplitude_m * i / kSteps);
    const bool memory = has_memory_;
    has_memory_ = true;
    solved_before_ = TrySolve();
    has_memory_ = memory;
  }
  return solved_before_;
}

bool LinearisedCycle::SolveLevel(std::size_t level, const Eigen::MatrixXcd& start) {
  // Held by value: the start may be this level's own.
  const Eigen::MatrixXcd from = start;
  while (levels_.size() <= level)
    levels_.push_back(
        std::make_unique<PortCycle>(ports_, receptance_, HarmonicsOf(levels_.size()), SamplesOf(levels_.size())));
  level_ = level;
  const bool converged = levels_[level]->Solve(omega_, driven_, from, options_.tolerance, options_.max_iterations);
  iterations_ += levels_[level]->iterations();
  return converged;
}

Eigen::VectorXcd LinearisedCycle::Coordinates(int h) const {
  Eigen::VectorXcd tensions = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(ports_.size()));
  if (h <= harmonics()) tensions = cycle().remainder().row(h).transpose();
  return receptance_.Motion(h * omega_, tensions, h == 1 ? amplitude_ : 0);
}

Eigen::VectorXcd LinearisedCycle::SensorsAt(int h) const {
  const Complex iw(0, h * omega_);
  const Eigen::VectorXcd motion = Coordinates(h).head(model_.mass.rows());
  Eigen::VectorXcd readings =
      model_.on_position * motion + iw * (model_.on_velocity * motion) + iw * iw * (model_.on_acceleration * motion);
  if (h == 1)
    readings += amplitude_ * (model_.on_post_height * shape_ + iw * (model_.on_post_velocity * shape_) +
                              iw * iw * (model_.on_post_acceleration * shape_));
  for (std::size_t j = 0; j < ports_.size(); ++j)
    if (ports_[j].liftoff >= 0)
      for (const int sensor : model_.liftoffs[static_cast<std::size_t>(ports_[j].liftoff)].load_cells)
        readings[sensor] += cycle().remainder()(h, static_cast<Eigen::Index>(j));
  return readings;
}

/// Largest change of a first harmonic, relative to it. Where a sensor is next to a node, or silent by symmetry, it is
/// relative to a thousandth of the terms that cancel each other there.
double LinearisedCycle::SensorChange(const Eigen::VectorXcd& before) const {
  constexpr double kNode = 1e-3;
  const Eigen::VectorXd motion = Coordinates(1).head(model_.mass.rows()).cwiseAbs();
  const Eigen::VectorXcd now = SensorsAt(1);
  const Eigen::VectorXd terms = model_.on_position.cwiseAbs() * motion +
                                omega_ * (model_.on_velocity.cwiseAbs() * motion) +
                                omega_ * omega_ * (model_.on_acceleration.cwiseAbs() * motion);
  double largest = 0;
  for (Eigen::Index i = 0; i < now.size(); ++i) {
    const double size = std::max(std::abs(now[i]), kNode * terms[i]);
    if (size > 0) largest = std::max(largest, std::abs(now[i] - before[i]) / size);
  }
  return largest;
}

SensorHarmonics LinearisedCycle::Sensors() const {
  SensorHarmonics out(model_.on_position.rows(), 3);
  for (int h = 0; h <= 2; ++h) out.col(h) = SensorsAt(h);
  return out;
}

Eigen::MatrixXcd LinearisedCycle::Motion(int harmonics) const {
  Eigen::MatrixXcd motion(harmonics + 1, model_.mass.rows());
  for (int h = 0; h <= harmonics; ++h) motion.row(h) = Coordinates(h).head(motion.cols()).transpose();
  return motion;
}

Eigen::MatrixXcd LinearisedCycle::SeriesExtensions(int harmonics) const {
  const auto count = static_cast<Eigen::Index>(model_.SeriesDampers().size());
  Eigen::MatrixXcd extensions(harmonics + 1, count);
  for (int h = 0; h <= harmonics; ++h) extensions.row(h) = Coordinates(h).tail(count).transpose();
  return extensions;
}

}  // namespace fourpost
