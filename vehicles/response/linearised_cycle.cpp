#include "vehicles/response/linearised_cycle.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Of level 0, 1, ...: 5, 9, 17, ...
int HarmonicsOf(std::size_t level) { return (4 << level) + 1; }

/// As few as slopes with twice the harmonics allow: with kinks mended, see CycleRemainders, more change nothing. Steps
/// have to be resolved; samples of one level are then not among those of the next, so that no step falls between those
/// of both.
int SamplesOf(std::size_t level, bool has_steps) { return has_steps ? (28 << level) + 4 : 4 * HarmonicsOf(level) + 4; }

bool HasFriction(const std::vector<Port>& ports) {
  return std::any_of(ports.begin(), ports.end(), [](const Port& port) {
    return std::isfinite(StepOfRate(port.law)) || std::holds_alternative<FrictionRemainder>(port.law);
  });
}

/// Friction does, and vapour that collapses in a hydraulic damper.
bool HasSteps(const std::vector<Port>& ports) {
  return HasFriction(ports) ||
         std::any_of(ports.begin(), ports.end(), [](const Port& port) { return HasMemory(port.law); });
}

/// See HarmonicBalanceOptions::few_harmonics.
constexpr int kFew = 9;
constexpr int kFewWithFriction = 17;
/// Level that has these.
constexpr std::size_t kFewLevel = 1;
constexpr std::size_t kFewLevelWithFriction = 2;

}  // namespace

LinearisedCycle::LinearisedCycle(const CondensedModel& model, const std::vector<double>& shape,
                                 const HarmonicBalanceOptions& options, std::vector<Port> ports)
    : model_(model),
      shape_(Eigen::Map<const Eigen::VectorXd>(shape.data(), static_cast<Eigen::Index>(shape.size()))),
      options_(options),
      ports_(std::move(ports)),
      receptance_(model, ports_, shape),
      has_memory_(std::any_of(ports_.begin(), ports_.end(), [](const Port& port) { return UsesExtension(port.law); })),
      has_friction_(HasFriction(ports_)),
      has_steps_(HasSteps(ports_)),
      left_(has_steps_ ? 1 : 0.5),
      root_mass_(model.mass.diagonal().cwiseSqrt()) {
  sensors_.resize(3 * model.on_position.rows(), model.mass.rows());
  sensors_ << model.on_position, model.on_velocity, model.on_acceleration;
  const Eigen::VectorXd inverse = root_mass_.cwiseInverse();
  const auto norm = [&](const Eigen::MatrixXd& rows) -> Eigen::VectorXd {
    return (rows * inverse.asDiagonal()).rowwise().norm();
  };
  position_norm_ = norm(model.on_position);
  velocity_norm_ = norm(model.on_velocity);
  acceleration_norm_ = norm(model.on_acceleration);
}

bool LinearisedCycle::Solve(double frequency_Hz, double amplitude_m, const Eigen::MatrixXcd& start) {
  omega_ = 2 * std::numbers::pi * frequency_Hz;
  NoteUnits();
  iterations_ = 0;
  SetAmplitude(amplitude_m);
  // From less, and where the motion of less has come to its end, from more.
  solved_before_ =
      TrySolve(start) ||
      (!ports_.empty() && (SolveByWayOf({0.1, 0.2, 0.35, 0.5, 0.7, 0.85}) || SolveByWayOf({4, 3, 2, 1.5, 1.2})));
  return solved_before_;
}

void LinearisedCycle::NoteUnits() {
  unit_motion_ = receptance_.UnitMotions(omega_);
  unit_driven_ = receptance_.Driven(unit_motion_.rightCols(1));
  post_readings_.resize(model_.on_post_height.rows());
  post_readings_.real() = (model_.on_post_height - omega_ * omega_ * model_.on_post_acceleration) * shape_;
  post_readings_.imag() = omega_ * (model_.on_post_velocity * shape_);
  unit_readings_ = ReadingsOf(Eigen::RowVectorXd::Constant(unit_motion_.cols(), omega_), unit_motion_);
  unit_readings_.rightCols(1) += post_readings_;
}

void LinearisedCycle::SetAmplitude(double amplitude_m) {
  amplitude_ = amplitude_m;
  driven_.setZero(2, unit_driven_.size());
  driven_.row(1) = amplitude_m * unit_driven_.transpose();
  added_.resize(0, 0);
}

bool LinearisedCycle::SolveWith(const Eigen::MatrixXcd& added) {
  SetAmplitude(amplitude_);
  const Eigen::MatrixXcd through_posts = driven_;
  driven_.setZero(std::max<Eigen::Index>(2, added.rows()), unit_driven_.size());
  driven_.topRows(2) = through_posts;
  for (std::size_t j = 0; j < ports_.size(); ++j)
    driven_.col(static_cast<Eigen::Index>(j)).head(added.rows()) += added * ports_[j].direction;
  added_ = added;
  // What did not converge is no start for the next frequency.
  solved_before_ = SolveLevel(level_, cycle().extension(), options_.tolerance);
  return solved_before_;
}

/// From few harmonics to as many as the error needs.
bool LinearisedCycle::TrySolve(const Eigen::MatrixXcd& given) {
  Eigen::MatrixXcd start = driven_;
  if (given.size() > 0) start = given;
  else if (has_memory_ && solved_before_) start = cycle().extension();
  if (ports_.empty()) return SolveLevel(0, start, options_.tolerance);
  if (options_.few_harmonics) return SolveWithFew(start);
  // Two below what the last frequency needed, so that fewer may do again.
  std::size_t level = level_ > 2 ? level_ - 2 : 0;
  // No need to know better what more harmonics will change.
  const double rough = std::max(options_.tolerance, options_.error);
  if (!SolveLevel(level, start, rough)) return false;
  First now = FirstHarmonic();
  while (HarmonicsOf(level + 1) <= options_.most_harmonics) {
    if (!SolveLevel(++level, cycle().extension(), options_.tolerance)) return false;
    const First before = std::exchange(now, FirstHarmonic());
    if (left_ * Change(before, now) <= options_.error && cycle().ResolvesSteps()) return true;
  }
  return false;
}

/// With samples that resolve friction at this amplitude. That takes a rough solution only.
bool LinearisedCycle::SolveWithFew(const Eigen::MatrixXcd& start) {
  if (!has_friction_) return SolveLevel(kFewLevel, start, options_.tolerance);
  constexpr double kRough = 0.05;
  // Whatever the last frequency needed: a change of samples would look like a slope.
  std::size_t level = kFewLevelWithFriction;
  if (!SolveLevel(level, start, kRough)) return false;
  while (true) {
    while (!cycle().ResolvesSteps()) {
      if (HarmonicsOf(level + 1) > options_.most_harmonics) return false;
      if (!SolveLevel(++level, cycle().extension(), kRough)) return false;
    }
    if (!SolveLevel(level, cycle().extension(), options_.tolerance)) return false;
    if (cycle().ResolvesSteps()) return true;
  }
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

int LinearisedCycle::MostHarmonicsOf(std::size_t level) const {
  if (!options_.few_harmonics) return HarmonicsOf(level);
  return std::min(HarmonicsOf(level), has_friction_ ? kFewWithFriction : kFew);
}

bool LinearisedCycle::SolveLevel(std::size_t level, const Eigen::MatrixXcd& start, double tolerance) {
  while (levels_.size() <= level)
    levels_.push_back(std::make_unique<PortCycle>(ports_, receptance_, MostHarmonicsOf(levels_.size()),
                                                  SamplesOf(levels_.size(), has_steps_)));
  level_ = level;
  const bool converged =
      levels_[level]->Solve(omega_, driven_, start, tolerance, options_.max_iterations, options_.deadline);
  iterations_ += levels_[level]->iterations();
  return converged;
}

Eigen::VectorXcd LinearisedCycle::CoordinatesOf(int h) const {
  const Eigen::Index count = unit_driven_.size();
  Eigen::VectorXcd tensions = Eigen::VectorXcd::Zero(count);
  if (h <= harmonics()) tensions = cycle().remainder().row(h).transpose();
  Eigen::VectorXcd coordinates;
  if (h == 1) coordinates = unit_motion_.leftCols(count) * tensions + amplitude_ * unit_motion_.col(count);
  else coordinates = receptance_.Motion(h * omega_, tensions, 0);
  if (h < added_.rows()) coordinates += added_.row(h).transpose();
  return coordinates;
}

// Rows are real: position and acceleration act on one part of the motion, velocity turns it.
Eigen::MatrixXcd LinearisedCycle::ReadingsOf(const Eigen::RowVectorXd& w, const Eigen::MatrixXcd& coordinates) const {
  const Eigen::Index n = model_.mass.rows();
  const Eigen::Index columns = coordinates.cols();
  const Eigen::Index sensors = sensors_.rows() / 3;
  Eigen::MatrixXd parts(n, 2 * columns);
  parts << coordinates.topRows(n).real(), coordinates.topRows(n).imag();
  const Eigen::MatrixXd read = sensors_.lazyProduct(parts);
  Eigen::MatrixXcd readings(sensors, columns);
  for (Eigen::Index j = 0; j < columns; ++j)
    for (Eigen::Index i = 0; i < sensors; ++i) {
      const auto on = [&](Eigen::Index derivative) {
        const Eigen::Index row = derivative * sensors + i;
        return Complex(read(row, j), read(row, columns + j));
      };
      readings(i, j) = on(0) + Complex(0, w[j]) * on(1) - w[j] * w[j] * on(2);
    }
  return readings;
}

void LinearisedCycle::AddTyreForces(int h, const Eigen::MatrixXcd& remainder,
                                    Eigen::Ref<Eigen::VectorXcd> readings) const {
  for (std::size_t j = 0; j < ports_.size(); ++j)
    for (const int sensor : ports_[j].load_cells) readings[sensor] += remainder(h, static_cast<Eigen::Index>(j));
}

LinearisedCycle::First LinearisedCycle::FirstHarmonic() const {
  const Eigen::Index count = unit_driven_.size();
  Eigen::VectorXcd causes(count + 1);
  causes << cycle().remainder().row(1).transpose(), amplitude_;
  First first;
  first.motion = unit_motion_.topRows(root_mass_.size()).lazyProduct(causes).cwiseProduct(root_mass_).norm();
  first.readings = unit_readings_.lazyProduct(causes);
  AddTyreForces(1, cycle().remainder(), first.readings);
  return first;
}

/// Largest change of a first harmonic, relative to it. Where a sensor is next to a node, or silent by symmetry, it is
/// relative to 3 % of what it would read if all of the motion's kinetic energy were in what it sees.
double LinearisedCycle::Change(const First& before, const First& now) const {
  constexpr double kNode = 0.03;
  double largest = 0;
  for (Eigen::Index i = 0; i < now.readings.size(); ++i) {
    const double most =
        now.motion * (position_norm_[i] + omega_ * velocity_norm_[i] + omega_ * omega_ * acceleration_norm_[i]);
    const double size = std::max(std::sqrt(std::norm(now.readings[i])), kNode * most);
    if (size > 0) largest = std::max(largest, std::sqrt(std::norm(now.readings[i] - before.readings[i])) / size);
  }
  return largest;
}

SensorHarmonics LinearisedCycle::SensorsBy(const Eigen::MatrixXcd& remainder) const {
  SensorHarmonics out = ReadingsOf(Eigen::RowVector3d(0, omega_, 2 * omega_), Coordinates(2).transpose());
  out.col(1) += amplitude_ * post_readings_;
  for (int h = 0; h <= 2; ++h) AddTyreForces(h, remainder, out.col(h));
  return out;
}

Eigen::MatrixXcd LinearisedCycle::Coordinates(int harmonics) const {
  Eigen::MatrixXcd coordinates(harmonics + 1, receptance_.size());
  for (int h = 0; h <= harmonics; ++h) coordinates.row(h) = CoordinatesOf(h).transpose();
  return coordinates;
}

}  // namespace fourpost
