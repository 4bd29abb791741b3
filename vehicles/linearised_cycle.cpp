#include "vehicles/linearised_cycle.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Harmonics and samples of level 0, 1, ...: 5 and 32, 9 and 60, 17 and 116, ... Samples of one level are not among
/// those of the next: a kink that falls on one of both would be wrong alike in both.
int HarmonicsOf(std::size_t level) { return (4 << level) + 1; }
int SamplesOf(std::size_t level) { return (28 << level) + 4; }

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
  // From less, and where the motion of less has come to its end, from more.
  solved_before_ =
      TrySolve() ||
      (!ports_.empty() && (SolveByWayOf({0.1, 0.2, 0.35, 0.5, 0.7, 0.85}) || SolveByWayOf({4, 3, 2, 1.5, 1.2})));
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
  // Two below what the last frequency needed, so that fewer may do again.
  std::size_t level = level_ > 2 ? level_ - 2 : 0;
  if (ports_.empty()) return SolveLevel(level, start, options_.tolerance);
  // No need to know better what more harmonics will change.
  const double rough = std::max(options_.tolerance, options_.error);
  if (!SolveLevel(level, start, rough)) return false;
  while (HarmonicsOf(level + 1) <= options_.most_harmonics) {
    const Eigen::VectorXcd before = SensorsAt(1);
    if (!SolveLevel(++level, cycle().extension(), options_.tolerance)) return false;
    // What kinks leave falls with the square of the samples: a third of this change is left.
    if (SensorChange(before) <= 3 * options_.error && cycle().ResolvesSteps()) return true;
  }
  return false;
}

/// By way of other amplitudes, each from the solution of the one before.
bool LinearisedCycle::SolveByWayOf(const std::vector<double>& shares) {
  const double amplitude = amplitude_;
  const bool memory = std::exchange(has_memory_, true);
  solved_before_ = false;
  for (const double share : shares) {
    SetAmplitude(share * amplitude);
    solved_before_ = TrySolve();
  }
  SetAmplitude(amplitude);
  solved_before_ = TrySolve();
  has_memory_ = memory;
  return solved_before_;
}

bool LinearisedCycle::SolveLevel(std::size_t level, const Eigen::MatrixXcd& start, double tolerance) {
  // Held by value: the start may be this level's own.
  const Eigen::MatrixXcd from = start;
  while (levels_.size() <= level)
    levels_.push_back(
        std::make_unique<PortCycle>(ports_, receptance_, HarmonicsOf(levels_.size()), SamplesOf(levels_.size())));
  level_ = level;
  const bool converged = levels_[level]->Solve(omega_, driven_, from, tolerance, options_.max_iterations);
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
/// relative to 3 % of what it would read if all of the motion's kinetic energy were in what it sees.
double LinearisedCycle::SensorChange(const Eigen::VectorXcd& before) const {
  constexpr double kNode = 0.03;
  const Eigen::VectorXd roots = model_.mass.diagonal().cwiseSqrt();
  const double motion = Coordinates(1).head(roots.size()).cwiseProduct(roots).norm();
  const Eigen::MatrixXd rows = model_.on_position.cwiseAbs() + omega_ * model_.on_velocity.cwiseAbs() +
                               omega_ * omega_ * model_.on_acceleration.cwiseAbs();
  const Eigen::VectorXd most = motion * (rows * roots.cwiseInverse().asDiagonal()).rowwise().norm();
  const Eigen::VectorXcd now = SensorsAt(1);
  double largest = 0;
  for (Eigen::Index i = 0; i < now.size(); ++i) {
    const double size = std::max(std::abs(now[i]), kNode * most[i]);
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
