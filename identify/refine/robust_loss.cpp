#include "identify/refine/robust_loss.h"

#include <cmath>
#include <limits>

#include <ceres/loss_function.h>

#include "analysis/text/option_check.h"

namespace fourpost {

double UsualScale(LossKind kind) {
  switch (kind) {
    case LossKind::kNone: return 1;
    case LossKind::kHuber: return 1.345;
    case LossKind::kSoftL1: return 1.287;
    case LossKind::kCauchy: return 2.385;
    case LossKind::kTukey: return 4.685;
  }
  return 1;
}

RobustLoss::RobustLoss(LossKind kind, double scale, Eigen::Index plain) : kind_(kind), scale_(scale), plain_(plain) {
  RequireOption(scale > 0 && std::isfinite(scale), "scale of the loss", scale, "above 0 and finite");
}

double RobustLoss::Cost(const Eigen::VectorXd& residuals) const { return Transformed(residuals).squaredNorm(); }

Eigen::VectorXd RobustLoss::Transformed(const Eigen::VectorXd& residuals) const {
  if (kind_ == LossKind::kNone) return residuals;
  Eigen::VectorXd transformed = residuals;
  for (Eigen::Index i = 0; i < residuals.size() - plain_; ++i)
    transformed[i] = std::copysign(std::sqrt(Rho(residuals[i] * residuals[i])[0]), residuals[i]);
  return transformed;
}

// d sign(r) sqrt(rho) / dr = rho' |r| / sqrt(rho); rho = r^2 next to zero.
Eigen::VectorXd RobustLoss::Slopes(const Eigen::VectorXd& residuals) const {
  Eigen::VectorXd slopes = Eigen::VectorXd::Ones(residuals.size());
  if (kind_ == LossKind::kNone) return slopes;
  for (Eigen::Index i = 0; i < residuals.size() - plain_; ++i) {
    const auto [rho, first, second] = Rho(residuals[i] * residuals[i]);
    if (rho > 0) slopes[i] = first * std::abs(residuals[i]) / std::sqrt(rho);
  }
  return slopes;
}

Eigen::VectorXd RobustLoss::Weights(const Eigen::VectorXd& residuals) const {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(residuals.size());
  for (Eigen::Index i = 0; i < residuals.size() - plain_; ++i) weights[i] = Rho(residuals[i] * residuals[i])[1];
  return weights;
}

// psi' = rho' + 2 r^2 rho''.
Eigen::VectorXd RobustLoss::Curvatures(const Eigen::VectorXd& residuals) const {
  Eigen::VectorXd curvatures = Eigen::VectorXd::Ones(residuals.size());
  for (Eigen::Index i = 0; i < residuals.size() - plain_; ++i) {
    const auto [rho, first, second] = Rho(residuals[i] * residuals[i]);
    curvatures[i] = first + 2 * residuals[i] * residuals[i] * second;
  }
  return curvatures;
}

double RobustLoss::EquivalentCost(const Eigen::VectorXd& residuals, Eigen::Index unmeasured) const {
  if (kind_ == LossKind::kNone) return residuals.squaredNorm();
  double squares = 0;
  double slope = 0;
  for (const double r : residuals) {
    const auto [rho, first, second] = Rho(r * r);
    squares += r * r * first * first;
    slope += first + 2 * r * r * second;
  }
  // Those that are 0 have a slope of 1 and no squares.
  slope = (slope - static_cast<double>(unmeasured)) / static_cast<double>(residuals.size() - unmeasured);
  if (!(slope > 0)) return std::numeric_limits<double>::infinity();
  return squares / (slope * slope);
}

std::array<double, 3> RobustLoss::Rho(double s) const {
  std::array<double, 3> rho = {s, 1, 0};
  switch (kind_) {
    case LossKind::kNone: break;
    case LossKind::kHuber: ceres::HuberLoss(scale_).Evaluate(s, rho.data()); break;
    case LossKind::kSoftL1: ceres::SoftLOneLoss(scale_).Evaluate(s, rho.data()); break;
    case LossKind::kCauchy: ceres::CauchyLoss(scale_).Evaluate(s, rho.data()); break;
    case LossKind::kTukey: ceres::TukeyLoss(scale_).Evaluate(s, rho.data()); break;
  }
  return rho;
}

}  // namespace fourpost
