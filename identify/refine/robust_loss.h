#pragma once

#include <array>
#include <string_view>

#include <Eigen/Core>

namespace fourpost {

/// How much a residual r of a refinement counts: rho(r^2) in place of r^2, alike for small ones, less for large ones,
/// so that outliers pull less. With s = r^2 / scale^2, rho / scale^2 is
///   none      s
///   huber     s up to 1, then 2 sqrt(s) - 1
///   soft_l1   2 (sqrt(1 + s) - 1)
///   cauchy    ln(1 + s)
///   tukey     (1 - (1 - s)^3) / 3 up to 1, then 1/3: what is further off does not count at all
/// (loss functions of Ceres; Huber, Robust Statistics, 1981).
enum class LossKind { kNone, kHuber, kSoftL1, kCauchy, kTukey };

/// In the order of LossKind.
inline constexpr std::array<std::string_view, 5> kLossNames = {"none", "huber", "soft_l1", "cauchy", "tukey"};

/// Where a loss departs from the square, in standard deviations: what loses 5 % of precision where nothing but normal
/// noise is there (Huber 1981; Holland and Welsch, Commun. Stat. A6, 1977; of soft_l1 by the same integral).
double UsualScale(LossKind kind);

/// A loss of independent residuals. The last `plain` of them are squared whatever the loss: priors.
class RobustLoss {
 public:
  /// Squares all.
  RobustLoss() = default;
  /// Throws std::invalid_argument for a scale that is not above 0 and finite.
  RobustLoss(LossKind kind, double scale, Eigen::Index plain);

  LossKind kind() const { return kind_; }
  std::string_view name() const { return kLossNames[static_cast<std::size_t>(kind_)]; }
  double scale() const { return scale_; }
  /// Another one of the same scale.
  RobustLoss As(LossKind kind) const { return {kind, scale_, plain_}; }
  /// The same of the residuals of data alone, without the last ones.
  RobustLoss OfData() const { return {kind_, scale_, 0}; }

  /// Sum of rho.
  double Cost(const Eigen::VectorXd& residuals) const;

  /// sign(r) sqrt(rho(r^2)): their squares add up to the cost.
  Eigen::VectorXd Transformed(const Eigen::VectorXd& residuals) const;
  /// Their derivatives by r.
  Eigen::VectorXd Slopes(const Eigen::VectorXd& residuals) const;

  /// rho'(r^2): what each residual counts in the gradient, 1 for small ones.
  Eigen::VectorXd Weights(const Eigen::VectorXd& residuals) const;
  /// psi' of psi = r rho'(r^2), the slope of that gradient: 1 for small ones.
  Eigen::VectorXd Curvatures(const Eigen::VectorXd& residuals) const;

  /// The sum of squares that would leave estimates the variance that they have with this loss: of N residuals about an
  /// optimum over n parameters sum psi^2 / (mean psi')^2, psi = r rho'(r^2) (Huber 1981, section 7.6).
  /// Infinite where mean psi' is not above 0, as where Tukey's rejects all: such residuals determine nothing.
  /// `unmeasured`: of the residuals, those that are 0 and no data, which the mean leaves out.
  double EquivalentCost(const Eigen::VectorXd& residuals, Eigen::Index unmeasured = 0) const;

 private:
  /// At s = r^2: value and first two derivatives.
  std::array<double, 3> Rho(double s) const;

  LossKind kind_ = LossKind::kNone;
  double scale_ = 1;
  Eigen::Index plain_ = 0;
};

}  // namespace fourpost
