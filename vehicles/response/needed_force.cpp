#include "vehicles/response/needed_force.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fourpost {
namespace {

using Complex = std::complex<double>;

}  // namespace

NeededForce::NeededForce(const CondensedModel& model, const std::vector<double>& shape)
    : model_(model),
      shape_(Eigen::Map<const Eigen::VectorXd>(shape.data(), static_cast<Eigen::Index>(shape.size()))),
      vehicle_(model, LinearVehicle::Rates::kCentre),
      ports_(PortsOf(model)),
      held_(model, ports_, shape, Receptance::Coordinates::kHeld),
      are_apart_(AreApart(ports_, vehicle_.series())) {}

int NeededForce::SamplesFor(double frequency_Hz, std::complex<double> posts, const Eigen::MatrixXcd& motion) const {
  constexpr int kSmooth = 4 * kHarmonics + 4;
  constexpr int kMost = 16 * kSmooth;
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  const Eigen::MatrixXcd driven = Driven(WithSeries(omega, motion), posts);
  const Eigen::VectorXd orders = Eigen::VectorXd::LinSpaced(driven.rows(), 0, static_cast<double>(driven.rows() - 1));
  int samples = kSmooth;
  for (std::size_t j = 0; j < ports_.size(); ++j) {
    const double greatest = omega * driven.col(static_cast<Eigen::Index>(j)).cwiseAbs().dot(orders);
    const double per_sample = 2 * std::numbers::pi * greatest;
    while (samples < kMost && per_sample > samples * StepOfRate(ports_[j].law)) samples *= 2;
  }
  return samples;
}

Eigen::MatrixXcd NeededForce::Driven(const Eigen::MatrixXcd& linear, std::complex<double> posts) const {
  Eigen::MatrixXcd driven(linear.rows(), static_cast<Eigen::Index>(ports_.size()));
  for (std::size_t j = 0; j < ports_.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    driven.col(column) = linear * ports_[j].direction.cast<Complex>();
    if (ports_[j].post >= 0) driven(1, column) += shape_[ports_[j].post] * posts;
  }
  return driven;
}

Eigen::MatrixXcd NeededForce::WithSeries(double omega, const Eigen::MatrixXcd& motion) const {
  const Eigen::Index n = model_.mass.rows();
  const Eigen::Index last = std::min<Eigen::Index>(motion.rows(), kHarmonics + 1);
  Eigen::MatrixXcd all = Eigen::MatrixXcd::Zero(kHarmonics + 1, vehicle_.size());
  all.topLeftCorner(last, n) = motion.topRows(last);
  const Eigen::Index series = vehicle_.series();
  for (Eigen::Index h = 0; h < last && series > 0; ++h) {
    const Complex rate(0, static_cast<double>(h) * omega);
    const Eigen::VectorXcd moved = all.row(h).head(n).transpose();
    const Eigen::VectorXcd forces = vehicle_.stiffness.bottomLeftCorner(series, n) * moved +
                                    vehicle_.damping.bottomLeftCorner(series, n) * (rate * moved);
    // Diagonal: each series spring has its dashpot.
    const Eigen::VectorXcd rates =
        vehicle_.stiffness.diagonal().tail(series) + rate * vehicle_.damping.diagonal().tail(series);
    all.row(h).tail(series) = -forces.cwiseQuotient(rates).transpose();
  }
  return all;
}

std::optional<Eigen::VectorXcd> NeededForce::At(double frequency_Hz, std::complex<double> posts,
                                                const Eigen::MatrixXcd& motion, int samples,
                                                const Eigen::MatrixXcd& start) {
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  const Eigen::Index n = model_.mass.rows();
  const Eigen::Index series = vehicle_.series();
  const Eigen::MatrixXcd linear = WithSeries(omega, motion);
  const Eigen::MatrixXcd driven = Driven(linear, posts);
  const Eigen::MatrixXcd* remainders = Remainders(omega, driven, samples, start);
  if (!remainders) return std::nullopt;
  Eigen::VectorXcd tensions = Eigen::VectorXcd::Zero(driven.cols());
  if (driven.cols() > 0) tensions = remainders->row(1).transpose();
  const Eigen::VectorXcd forces = held_.directions().cast<Complex>() * tensions;
  const Eigen::MatrixXcd impedance = vehicle_.Impedance(omega);
  Eigen::VectorXcd all = linear.row(1).transpose();
  all.tail(series) -= forces.tail(series).cwiseQuotient(impedance.bottomRightCorner(series, series).diagonal());
  Eigen::VectorXcd needed = impedance.topRows(n) * all + forces.head(n);
  needed -= (model_.post_stiffness * shape_).cast<Complex>() * posts;
  needed -= (model_.post_damping * shape_).cast<Complex>() * (Complex(0, omega) * posts);
  return needed;
}

const Eigen::MatrixXcd* NeededForce::Remainders(double omega, const Eigen::MatrixXcd& driven, int samples,
                                                const Eigen::MatrixXcd& start) {
  constexpr double kTolerance = 1e-6;
  constexpr int kMostIterations = 60;
  PortCycle& cycle = cycles_.try_emplace(samples, ports_, held_, kHarmonics, samples).first->second;
  const Eigen::MatrixXcd from =
      start.cols() == driven.cols() && start.rows() == driven.rows() ? Eigen::MatrixXcd(driven + start) : driven;
  if (!cycle.Solve(omega, driven, from, kTolerance, kMostIterations)) return nullptr;
  yielded_ = cycle.extension() - driven;
  return &cycle.remainder();
}

bool NeededForce::AreApart(const std::vector<Port>& ports, Eigen::Index series) {
  const auto share = [&](std::size_t port) { return ports[port].direction.tail(series).cwiseAbs(); };
  for (std::size_t j = 0; j < ports.size(); ++j)
    for (std::size_t k = 0; k < j; ++k)
      if (share(j).dot(share(k)) > 0) return false;
  return true;
}

/// Coordinates are given, so that the force of each port follows its own extension: all of them are moved at once.
std::optional<Eigen::MatrixXd> NeededForce::Slope(double frequency_Hz, std::complex<double> posts,
                                                  const Eigen::MatrixXcd& motion, int samples, double step) {
  if (!are_apart_) return SlopeByCoordinates(frequency_Hz, posts, motion, samples, step);
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  const Eigen::Index n = model_.mass.rows();
  const Eigen::Index series = vehicle_.series();
  const Eigen::MatrixXcd impedance = vehicle_.Impedance(omega);
  const Eigen::VectorXcd yielding = impedance.bottomRightCorner(series, series).diagonal().cwiseInverse();
  const Eigen::MatrixXcd directions = held_.directions().cast<Complex>();
  Eigen::MatrixXcd all(n + series, n);
  all << Eigen::MatrixXcd::Identity(n, n), -(yielding.asDiagonal() * impedance.bottomLeftCorner(series, n));
  const Eigen::MatrixXcd by_motion = impedance.topRows(n) * all;
  const Eigen::MatrixXcd extensions = directions.transpose() * all;
  const Eigen::MatrixXcd by_tension =
      directions.topRows(n) -
      impedance.topRightCorner(n, series) * (yielding.asDiagonal() * directions.bottomRows(series));
  const Eigen::MatrixXcd driven = Driven(WithSeries(omega, motion), posts);
  const Eigen::Index ports = driven.cols();
  Eigen::VectorXcd here = Eigen::VectorXcd::Zero(ports);
  Eigen::MatrixXcd tensions = Eigen::MatrixXcd::Zero(ports, 2);
  if (ports > 0) {
    const Eigen::MatrixXcd* remainders = Remainders(omega, driven, samples, {});
    if (!remainders) return std::nullopt;
    here = remainders->row(1).transpose();
    const Eigen::MatrixXcd start = yielded_;
    for (Eigen::Index part = 0; part < 2; ++part) {
      Eigen::MatrixXcd moved = driven;
      moved.row(1).array() += part == 0 ? Complex(step, 0) : Complex(0, step);
      remainders = Remainders(omega, moved, samples, start);
      if (!remainders) return std::nullopt;
      tensions.col(part) = (remainders->row(1).transpose() - here) / step;
    }
  }
  Eigen::MatrixXd slope(2 * n, 2 * n);
  for (const Eigen::Index part : {0, 1}) {
    const Complex unit = part == 0 ? Complex(1, 0) : Complex(0, 1);
    const Eigen::MatrixXcd moved = unit * extensions;
    const Eigen::MatrixXcd change =
        unit * by_motion + by_tension * (tensions.col(0).asDiagonal() * moved.real().cast<Complex>() +
                                         tensions.col(1).asDiagonal() * moved.imag().cast<Complex>());
    slope.block(0, part * n, n, n) = change.real();
    slope.block(n, part * n, n, n) = change.imag();
  }
  return slope;
}

std::optional<Eigen::MatrixXd> NeededForce::SlopeByCoordinates(double frequency_Hz, std::complex<double> posts,
                                                               const Eigen::MatrixXcd& motion, int samples,
                                                               double step) {
  const Eigen::Index n = model_.mass.rows();
  const std::optional<Eigen::VectorXcd> here = At(frequency_Hz, posts, motion, samples);
  if (!here) return std::nullopt;
  const Eigen::MatrixXcd start = yielded_;
  Eigen::MatrixXd slope(2 * n, 2 * n);
  for (Eigen::Index j = 0; j < 2 * n; ++j) {
    Eigen::MatrixXcd moved = motion;
    moved(1, j % n) += j < n ? Complex(step, 0) : Complex(0, step);
    const std::optional<Eigen::VectorXcd> there = At(frequency_Hz, posts, moved, samples, start);
    if (!there) return std::nullopt;
    const Eigen::VectorXcd change = (*there - *here) / step;
    slope.col(j) << change.real(), change.imag();
  }
  return slope;
}

}  // namespace fourpost
