#include "identify/missing_force/force_parts.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Eigen::MatrixXd Directions(const ForceRecord& record) {
  const Eigen::Index n = record.samples.front().motion.size();
  Eigen::MatrixXd directions(n, static_cast<Eigen::Index>(record.lines.size()));
  for (std::size_t l = 0; l < record.lines.size(); ++l)
    directions.col(static_cast<Eigen::Index>(l)) = record.lines[l].direction;
  return directions;
}

/// The same matrix for real and imaginary parts.
Eigen::MatrixXd Twice(const Eigen::MatrixXd& one) {
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * one.rows(), 2 * one.cols());
  both.topLeftCorner(one.rows(), one.cols()) = one;
  both.bottomRightCorner(one.rows(), one.cols()) = one;
  return both;
}

/// Covariance of [Re force, Im force], and how unmeasured motions move it.
struct ForceNoise {
  Eigen::MatrixXd covariance;
  Eigen::MatrixXd unmeasured;
};

ForceNoise NoiseOf(const ForceSample& sample) {
  return {.covariance = sample.slope * Twice(MotionCovariance(sample)) * sample.slope.transpose(),
          .unmeasured = kMostMotion * sample.amplitude_m * sample.slope * Twice(UnmeasuredMotion(sample))};
}

/// Of rows times [Re force, Im force], one per real part: its deviation; NaN where unmeasured motions count.
double SdOf(const Eigen::MatrixXd& rows, const ForceNoise& noise) {
  const double variance = (rows * noise.covariance * rows.transpose()).trace() / 2;
  const double unknown = noise.unmeasured.cols() > 0 ? (rows * noise.unmeasured).squaredNorm() / 2 : 0;
  constexpr double kCounts = 0.5;
  return unknown > kCounts * variance ? kNone : std::sqrt(variance);
}

void Put(const ForceSample& sample, const Eigen::MatrixXd& rows, const Eigen::VectorXd& force, const ForceNoise& noise,
         Complex motion, ForceCurve& curve) {
  const Eigen::Vector2d value = rows * force;
  const double sd = SdOf(rows, noise);
  curve.frequency_Hz.push_back(sample.frequency_Hz);
  curve.force.push_back(std::isfinite(sd) ? Complex(value[0], value[1]) : Complex(kNone, kNone));
  curve.force_sd.push_back(sd);
  curve.motion.push_back(motion);
}

/// Tensions by [Re force, Im force]: minus the best along the lines.
Eigen::MatrixXd ToLines(const Eigen::MatrixXd& directions, const ForceNoise& noise) {
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(noise.covariance);
  constexpr double kLeast = 1e-14;
  const Eigen::VectorXd values = pairs.values.cwiseMax(kLeast * pairs.values.maxCoeff());
  const Eigen::MatrixXd weight = values.cwiseSqrt().cwiseInverse().asDiagonal() * pairs.vectors.transpose();
  return -LeastNorm(weight * Twice(directions), 1e-9).PseudoInverse() * weight;
}

}  // namespace

ForceParts PartsOf(const ForceCurve& curve, std::size_t i) {
  const Complex force = curve.force[i];
  const Complex motion = curve.motion[i];
  const double size = std::abs(motion);
  const double omega = 2 * std::numbers::pi * curve.frequency_Hz[i];
  const Complex turned = size > 0 ? force * std::conj(motion) / size : Complex(kNone, kNone);
  ForceParts parts{.with_displacement = turned.real(), .with_speed = turned.imag()};
  parts.stiffness = parts.with_displacement / size;
  parts.damping = parts.with_speed / (omega * size);
  // The first harmonic of a rectangle of height 1 is 4 / pi.
  parts.friction = std::numbers::pi / 4 * parts.with_speed;
  parts.mass = -parts.stiffness / (omega * omega);
  return parts;
}

bool AreLinesUnique(const ForceRecord& record) {
  if (record.samples.empty() || record.lines.empty()) return false;
  return LeastNorm(Directions(record), 1e-6).rank() == static_cast<Eigen::Index>(record.lines.size());
}

std::vector<ForceCurve> ForceCurves(const ForceRecord& record) {
  std::vector<ForceCurve> all;
  if (record.samples.empty()) return all;
  const Eigen::MatrixXd directions = Directions(record);
  const std::size_t coordinates = record.coordinates.size();
  Eigen::MatrixXd shapes(directions.rows(), static_cast<Eigen::Index>(coordinates));
  for (std::size_t k = 0; k < coordinates; ++k) shapes.col(static_cast<Eigen::Index>(k)) = record.coordinates[k].shape;
  const Eigen::MatrixXd to_coordinates = LeastNorm(shapes).PseudoInverse();
  for (std::size_t run = 0; run < record.runs.size(); ++run) {
    const std::size_t first = all.size();
    for (const NamedCoordinate& coordinate : record.coordinates)
      all.push_back({.run = run, .of = coordinate.name, .is_turn = coordinate.is_turn});
    for (const ElementLine& line : record.lines) all.push_back({.run = run, .of = line.called, .is_line = true});
    for (const ForceSample& sample : record.samples) {
      if (sample.run != run) continue;
      const ForceNoise noise = NoiseOf(sample);
      const Eigen::Index n = sample.motion.size();
      Eigen::VectorXd force(2 * n);
      force << sample.force.real(), sample.force.imag();
      for (std::size_t k = 0; k < coordinates; ++k) {
        const Complex motion = (to_coordinates.row(static_cast<Eigen::Index>(k)).cast<Complex>() * sample.motion)(0);
        Put(sample, -Twice(record.coordinates[k].shape.transpose()), force, noise, motion, all[first + k]);
      }
      const Eigen::MatrixXd to_lines = ToLines(directions, noise);
      const auto count = static_cast<Eigen::Index>(record.lines.size());
      for (Eigen::Index l = 0; l < count; ++l) {
        Eigen::MatrixXd rows(2, 2 * n);
        rows << to_lines.row(l), to_lines.row(count + l);
        const ElementLine& line = record.lines[static_cast<std::size_t>(l)];
        Put(sample, rows, force, noise, ExtensionOf(line, sample),
            all[first + coordinates + static_cast<std::size_t>(l)]);
      }
    }
  }
  return all;
}

}  // namespace fourpost
