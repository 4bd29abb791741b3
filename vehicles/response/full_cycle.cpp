#include "vehicles/response/full_cycle.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/diagnostics.h"
#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/response/anderson_acceleration.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

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

/// Largest change of a harmonic, relative to that harmonic or to the first one, whichever is larger.
double RelativeChange(const Eigen::MatrixXcd& before, const Eigen::MatrixXcd& now) {
  const Eigen::VectorXd sizes = now.rowwise().norm();
  return (now - before).rowwise().norm().cwiseQuotient(sizes.cwiseMax(sizes[1])).maxCoeff();
}

Eigen::MatrixXd SeriesDirections(const CondensedModel& model) {
  const std::vector<const CondensedModel::Dashpot*> dampers = model.SeriesDampers();
  Eigen::MatrixXd directions(model.mass.rows(), static_cast<Eigen::Index>(dampers.size()));
  for (std::size_t j = 0; j < dampers.size(); ++j) directions.col(static_cast<Eigen::Index>(j)) = dampers[j]->direction;
  return directions;
}

Eigen::MatrixXd PortDirections(const std::vector<Port>& ports, Eigen::Index size) {
  Eigen::MatrixXd directions(size, static_cast<Eigen::Index>(ports.size()));
  for (std::size_t j = 0; j < ports.size(); ++j) directions.col(static_cast<Eigen::Index>(j)) = ports[j].direction;
  return directions;
}

}  // namespace

FullCycle::FullCycle(Multibody& multibody, const CondensedModel& model, const std::vector<double>& shape,
                     const FullBalanceOptions& options)
    : multibody_(multibody),
      shape_(shape),
      options_(options),
      transform_(CycleTransform::Shared(options.harmonics, options.samples)),
      chart_(multibody),
      linearised_(model, shape, {.tolerance = options.tolerance}),
      series_directions_(SeriesDirections(model)) {
  const LinearVehicle linear(model, LinearVehicle::Rates::kCentre);
  port_directions_ = PortDirections(linearised_.ports(), linear.size());
  stiffness_ = linear.stiffness.diagonal().cwiseAbs();
  mass_ = Eigen::VectorXd::Zero(linear.size());
  mass_.head(linear.mass.rows()) = linear.mass.diagonal();
  lacking_.resize(options.samples, linear.size());
  readings_.resize(options.samples, model.on_position.rows());
}

bool FullCycle::Solve(double frequency_Hz, double amplitude_m) {
  omega_ = 2 * std::numbers::pi * frequency_Hz;
  multibody_.SetPostMotion(SteadySine(shape_, amplitude_m, omega_));
  // An unconverged start is a start too.
  linearised_.Solve(frequency_Hz, amplitude_m);
  sensors_ = linearised_.Sensors();
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
  // Motion that the forces which linear kinematics leave out would cause in the linear vehicle.
  Eigen::MatrixXcd added = Eigen::MatrixXcd::Zero(options_.harmonics + 1, weights.size());
  Eigen::MatrixXcd motion = linearised_.Coordinates(options_.harmonics);
  double earlier = 0;
  for (int iteration = 0; iteration < options_.max_iterations; ++iteration) {
    if (!motion.allFinite()) return false;
    // The first is never the last: its sensors need not be read.
    const Eigen::MatrixXcd step = Departure(motion, iteration > 0);
    added = Unstacked(acceleration.Next(Stacked(weighted(added)), Stacked(weighted(step))), added.rows()) *
            weights.cwiseInverse().asDiagonal();
    if (!linearised_.SolveWith(added)) return false;
    const Eigen::MatrixXcd before = std::exchange(motion, linearised_.Coordinates(options_.harmonics));
    const double change = RelativeChange(weighted(before), weighted(motion));
    const double next = change * (earlier > 0 ? std::min(1.0, change / earlier) : 1);
    if (next <= options_.tolerance && iteration > 0) {
      sensors_ = linearised_.Sensors() + sensor_departure_;
      return true;
    }
    earlier = change;
  }
  return false;
}

/// What more must be added for the full system to move as the linearised one does now, from what it lacks to do so.
/// Laws with kinks err by coarse samples; they err alike in both systems, and so not in the difference.
Eigen::MatrixXcd FullCycle::Departure(const Eigen::MatrixXcd& motion, bool read) {
  SampleCycle(motion, read);
  Eigen::MatrixXcd lacking;
  transform_.ToHarmonics(lacking_, lacking);
  const Eigen::MatrixXcd coarse = linearised_.RemainderBy(transform_);
  if (read) {
    Eigen::MatrixXcd readings;
    transform_.ToHarmonics(readings_, readings);
    sensor_departure_ = readings.topRows(3).transpose() - linearised_.SensorsBy(coarse);
  }
  Eigen::MatrixXcd aliases = coarse;
  const Eigen::Index known = std::min(coarse.rows(), linearised_.remainder().rows());
  aliases.topRows(known) -= linearised_.remainder().topRows(known);
  return linearised_.MotionBy(aliases * port_directions_.transpose() - lacking);
}

void FullCycle::SampleCycle(const Eigen::MatrixXcd& motion, bool read) {
  const Eigen::MatrixXcd rates = Rates().asDiagonal() * motion;
  Eigen::MatrixXd position;
  Eigen::MatrixXd velocity;
  Eigen::MatrixXd acceleration;
  transform_.ToTime(motion, position);
  transform_.ToTime(rates, velocity);
  transform_.ToTime(Rates().asDiagonal() * rates, acceleration);
  const Eigen::Index n = chart_.size();
  const Eigen::Index series = motion.cols() - n;
  for (Eigen::Index k = 0; k < options_.samples; ++k) {
    const double t = 2 * std::numbers::pi * static_cast<double>(k) / (omega_ * options_.samples);
    const Chart::Motion now =
        chart_.Follow(t, position.row(k).head(n).transpose(), velocity.row(k).head(n).transpose(),
                      acceleration.row(k).head(n).transpose(), position.row(k).tail(series).transpose());
    Eigen::VectorXd derivative(2 * now.q.size() + series);
    derivative << now.rate, now.acceleration, velocity.row(k).tail(series).transpose();
    lacking_.row(k) = Lacking(now, derivative).transpose();
    if (read) readings_.row(k) = multibody_.Readings(derivative).transpose();
  }
}

/// A series damper pulls on s with its spring in the multibody system, with its dashpot in the linear vehicle; what the
/// two differ by is lacking on x.
Eigen::VectorXd FullCycle::Lacking(const Chart::Motion& motion, const Eigen::VectorXd& derivative) {
  const Eigen::VectorXd residual = multibody_.Residual(derivative);
  const Eigen::Index series = series_directions_.cols();
  Eigen::VectorXd lacking(chart_.size() + series);
  lacking << motion.tangent.transpose() * residual.head(motion.q.size()) - series_directions_ * residual.tail(series),
      residual.tail(series);
  return lacking;
}

Eigen::VectorXcd FullCycle::Rates() const {
  return Complex(0, omega_) * Eigen::VectorXd::LinSpaced(options_.harmonics + 1, 0, options_.harmonics);
}

}  // namespace fourpost
