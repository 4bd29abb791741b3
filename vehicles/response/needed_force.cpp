#include "vehicles/response/needed_force.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Springs to the ground that are so stiff that elements' forces do not count.
CondensedModel Held(CondensedModel model) {
  constexpr double kStiff = 1e9;
  const double most = model.stiffness.cwiseAbs().maxCoeff();
  model.stiffness.diagonal().array() += kStiff * (most > 0 ? most : 1);
  return model;
}

}  // namespace

NeededForce::NeededForce(const CondensedModel& model, const std::vector<double>& shape)
    : model_(model),
      shape_(Eigen::Map<const Eigen::VectorXd>(shape.data(), static_cast<Eigen::Index>(shape.size()))),
      vehicle_(model, LinearVehicle::Rates::kCentre),
      ports_(PortsOf(model)),
      held_(Held(model), ports_, shape) {}

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
    const Eigen::MatrixXcd impedance = vehicle_.Impedance(static_cast<double>(h) * omega);
    // Diagonal: each series spring has its dashpot.
    const Eigen::VectorXcd rates = impedance.bottomRightCorner(series, series).diagonal();
    const Eigen::VectorXcd forces = impedance.bottomLeftCorner(series, n) * all.row(h).head(n).transpose();
    all.row(h).tail(series) = -forces.cwiseQuotient(rates).transpose();
  }
  return all;
}

std::optional<Eigen::VectorXcd> NeededForce::At(double frequency_Hz, std::complex<double> posts,
                                                const Eigen::MatrixXcd& motion, int samples) {
  constexpr double kTolerance = 1e-6;
  constexpr int kMostIterations = 60;
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  const Eigen::Index n = model_.mass.rows();
  const Eigen::Index series = vehicle_.series();
  const Eigen::MatrixXcd linear = WithSeries(omega, motion);
  const Eigen::MatrixXcd driven = Driven(linear, posts);
  PortCycle& cycle = cycles_.try_emplace(samples, ports_, held_, kHarmonics, samples).first->second;
  if (!cycle.Solve(omega, driven, driven, kTolerance, kMostIterations)) return std::nullopt;
  Eigen::VectorXcd tensions = Eigen::VectorXcd::Zero(driven.cols());
  if (driven.cols() > 0) tensions = cycle.remainder().row(1).transpose();
  const Eigen::VectorXcd forces = held_.directions().cast<Complex>() * tensions;
  const Eigen::MatrixXcd impedance = vehicle_.Impedance(omega);
  Eigen::VectorXcd all = linear.row(1).transpose();
  all.tail(series) -= forces.tail(series).cwiseQuotient(impedance.bottomRightCorner(series, series).diagonal());
  Eigen::VectorXcd needed = impedance.topRows(n) * all + forces.head(n);
  needed -= (model_.post_stiffness * shape_).cast<Complex>() * posts;
  needed -= (model_.post_damping * shape_).cast<Complex>() * (Complex(0, omega) * posts);
  return needed;
}

}  // namespace fourpost
