#include "identify/refine/difference_jacobian.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fourpost {
namespace {

// Where a column's two further points are, relative to x.
struct Offsets {
  double a = 0;
  double b = 0;
};

Offsets OffsetsInside(double x, double lower, double upper, double step) {
  const double h = std::min(step, (upper - lower) / 4);
  if (x + h > upper) return {-h, -2 * h};
  if (x - h < lower) return {h, 2 * h};
  return {h, -h};
}

Eigen::VectorXd Shifted(const Eigen::VectorXd& x, Eigen::Index j, double offset) {
  Eigen::VectorXd shifted = x;
  shifted[j] += offset;
  return shifted;
}

std::optional<Eigen::VectorXd> Slope(const Eigen::VectorXd& residuals, const Evaluation& at_a, const Evaluation& at_b,
                                     const Offsets& offsets) {
  const auto [a, b] = offsets;
  if (b == 0) {
    if (!at_a.ok()) return std::nullopt;
    return (at_a.residuals - residuals) / a;
  }
  if (!at_a.ok() && !at_b.ok()) return std::nullopt;
  if (!at_b.ok()) return (at_a.residuals - residuals) / a;
  if (!at_a.ok()) return (at_b.residuals - residuals) / b;
  return ((at_a.residuals - residuals) * (b / a) - (at_b.residuals - residuals) * (a / b)) / (b - a);
}

// A step of this axis that its values can show.
double StepOf(const Lattice& lattice, const FitVariables& variables, const Eigen::VectorXd& x, Eigen::Index j,
              double step) {
  const LatticeAxis& axis = lattice.axes()[static_cast<std::size_t>(j)];
  if (!axis.discrete) return step;
  return std::max(step, axis.precision / variables.Slopes(variables.ToValues(x))[j]);
}

}  // namespace

double StepFor(double accuracy, Differences differences) {
  return differences == Differences::kForward ? std::sqrt(accuracy) : std::cbrt(accuracy);
}

std::optional<Eigen::MatrixXd> DifferenceJacobian(Archive& archive, const FitVariables& variables,
                                                  const Eigen::VectorXd& x, const Eigen::VectorXd& residuals,
                                                  double step, Differences differences) {
  const bool central = differences != Differences::kForward;
  if (differences == Differences::kAutomatic) {
    const Eigen::VectorXd values = variables.ToValues(x);
    if (const std::optional<Eigen::MatrixXd> own = archive.Differentiate(values))
      return *own * variables.Slopes(values).asDiagonal();
  }
  std::vector<Offsets> offsets;
  std::vector<Eigen::VectorXd> points;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    offsets.push_back(OffsetsInside(x[j], variables.lower()[j], variables.upper()[j],
                                    StepOf(archive.lattice(), variables, x, j, step)));
    if (!central) offsets.back().b = 0;
    points.push_back(variables.ToValues(Shifted(x, j, offsets.back().a)));
    if (central) points.push_back(variables.ToValues(Shifted(x, j, offsets.back().b)));
  }
  const std::vector<Evaluation> evaluations = archive.EvaluateValues(points);

  Eigen::MatrixXd jacobian(residuals.size(), x.size());
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    const auto column = central ? Slope(residuals, evaluations[2 * k], evaluations[2 * k + 1], offsets[k])
                                : Slope(residuals, evaluations[k], evaluations[k], offsets[k]);
    if (!column) return std::nullopt;
    jacobian.col(j) = *column;
  }
  return jacobian;
}

}  // namespace fourpost
