#include "vehicles/response/tyre_contact.h"

#include <cmath>
#include <complex>
#include <numbers>

#include "vehicles/response/cycle_transform.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Per period of the highest harmonic.
constexpr Eigen::Index kSamples = 8;

/// Of sum_h C_h exp(i h w t), at equally spaced samples.
double LeastSample(const Eigen::VectorXcd& harmonics) {
  const auto highest = static_cast<int>(harmonics.size() - 1);
  const CycleTransform& transform = CycleTransform::Shared(highest, static_cast<int>(kSamples) * (highest + 1));
  Eigen::MatrixXd samples;
  transform.ToTime(harmonics, samples);
  return samples.minCoeff();
}

/// How far a signal falls below its samples at most, those h apart: h^2 / 8 of its greatest curvature.
double DipBetweenSamples(const Eigen::VectorXcd& harmonics) {
  const Eigen::Index highest = harmonics.size() - 1;
  const double apart = 2 * std::numbers::pi / static_cast<double>(kSamples * (highest + 1));
  const Eigen::ArrayXd order = Eigen::ArrayXd::LinSpaced(harmonics.size(), 0, static_cast<double>(highest));
  return apart * apart / 8 * (order.square() * harmonics.array().abs()).sum();
}

}  // namespace

TyreContact::TyreContact(const std::vector<CondensedModel::Liftoff>& tyres, const LinearisedCycle& cycle)
    : tyres_(tyres), cycle_(cycle) {
  const Eigen::Index ports = cycle.directions().cols();
  const auto count = static_cast<Eigen::Index>(tyres.size());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, cycle.vehicle().size());
  mean_gain_.resize(count, ports);
  const Eigen::MatrixXd at_rest = cycle.receptance().UnitMotions(0).leftCols(ports).real();
  for (Eigen::Index i = 0; i < count; ++i) {
    const CondensedModel::Liftoff& tyre = tyres[static_cast<std::size_t>(i)];
    rows.row(i).head(tyre.direction.size()) = tyre.direction.transpose();
    mean_gain_.row(i) = tyre.stiffness * rows.row(i) * at_rest;
  }
  if (cycle.receptance().by_poles()) modal_sizes_ = cycle.receptance().ModalSizes(rows);
}

bool TyreContact::Presses() const {
  if (PressesByFirstHarmonic()) return true;
  const Eigen::MatrixXcd squeezes = Squeezes();
  for (std::size_t i = 0; i < tyres_.size(); ++i) {
    const Eigen::VectorXcd forces = ForcesOf(i, squeezes.col(static_cast<Eigen::Index>(i)));
    // So written that it is false for NaN.
    if (!(LeastSample(forces) - DipBetweenSamples(forces) >= 0)) return false;
  }
  return true;
}

/// By a bound of what the higher harmonics come to; false where there is none.
bool TyreContact::PressesByFirstHarmonic() const {
  const Eigen::MatrixXcd& remainder = cycle_.remainder();
  const bool has_ports = remainder.cols() > 0;
  if (has_ports && modal_sizes_.size() == 0) return false;
  Eigen::MatrixX2d reach;
  if (has_ports) reach = cycle_.receptance().ModalReach(cycle_.omega(), remainder.cwiseAbs2().cwiseSqrt());
  const Eigen::VectorXcd first = cycle_.CoordinatesOf(1);
  for (std::size_t i = 0; i < tyres_.size(); ++i) {
    const CondensedModel::Liftoff& law = tyres_[i];
    const auto row = static_cast<Eigen::Index>(i);
    double left = law.preload;
    for (Eigen::Index j = 0; j < remainder.cols(); ++j) left += mean_gain_(row, j) * remainder(0, j).real();
    if (has_ports) left -= modal_sizes_.row(row).dot(law.stiffness * reach.col(0) + law.damping * reach.col(1));
    Complex squeeze = PostShare(i);
    for (Eigen::Index k = 0; k < law.direction.size(); ++k) squeeze += law.direction[k] * first[k];
    // So written that it is false for NaN.
    if (!(left >= std::abs(Complex(law.stiffness, cycle_.omega() * law.damping) * squeeze))) return false;
  }
  return true;
}

Complex TyreContact::PostShare(std::size_t tyre) const {
  const int post = tyres_[tyre].post;
  return post < 0 ? 0 : cycle_.amplitude_m() * cycle_.shape()[post];
}

Eigen::MatrixXcd TyreContact::Squeezes() const {
  const Eigen::MatrixXcd motion = cycle_.Coordinates(cycle_.harmonics());
  Eigen::MatrixXcd squeezes(motion.rows(), static_cast<Eigen::Index>(tyres_.size()));
  for (std::size_t i = 0; i < tyres_.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    squeezes.col(column) = motion.leftCols(tyres_[i].direction.size()) * tyres_[i].direction;
    squeezes(1, column) += PostShare(i);
  }
  return squeezes;
}

/// With the preload.
Eigen::VectorXcd TyreContact::ForcesOf(std::size_t tyre, const Eigen::VectorXcd& squeeze) const {
  const CondensedModel::Liftoff& law = tyres_[tyre];
  Eigen::VectorXcd forces = squeeze;
  for (Eigen::Index h = 0; h < forces.size(); ++h)
    forces[h] *= Complex(law.stiffness, static_cast<double>(h) * cycle_.omega() * law.damping);
  forces[0] += law.preload;
  return forces;
}

std::vector<double> TyreContact::LeastForces(const Eigen::MatrixXcd& squeezes) const {
  std::vector<double> least;
  for (std::size_t i = 0; i < tyres_.size(); ++i)
    least.push_back(LeastSample(ForcesOf(i, squeezes.col(static_cast<Eigen::Index>(i)))));
  return least;
}

}  // namespace fourpost
