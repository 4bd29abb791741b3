#include "identify/missing_force/force_record.h"

#include <numbers>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

/// Of the information with the bound on motions.
SymmetricEigenpairs PairsOf(const ForceSample& sample) {
  const double most = kMostMotion * sample.amplitude_m;
  Eigen::MatrixXd information = sample.information;
  information.diagonal().array() += 1 / (most * most);
  return SymmetricEigenpairsOf(information);
}

}  // namespace

double ForceSample::omega() const { return 2 * std::numbers::pi * frequency_Hz; }

Eigen::MatrixXd MotionCovariance(const ForceSample& sample) {
  const SymmetricEigenpairs pairs = PairsOf(sample);
  return pairs.vectors * pairs.values.cwiseInverse().asDiagonal() * pairs.vectors.transpose();
}

Eigen::MatrixXd UnmeasuredMotion(const ForceSample& sample) {
  const SymmetricEigenpairs pairs = PairsOf(sample);
  const double bound = kNotMeasured * sample.amplitude_m;
  // Eigenvalues increase.
  return pairs.vectors.leftCols((pairs.values.array() < 1 / (bound * bound)).count());
}

std::complex<double> ExtensionOf(const ElementLine& line, const ForceSample& sample) {
  std::complex<double> extension = line.direction.cast<std::complex<double>>().transpose() * sample.motion;
  if (line.post >= 0) extension += sample.posts[line.post];
  return extension;
}

}  // namespace fourpost
