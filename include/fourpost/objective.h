#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fourpost/study.h>
#include <fourpost/vehicle.h>

namespace fourpost::api {

/// What a fit of a study minimises, for an optimiser or a sampler of your own. Values are those of the free parameters,
/// SI, in the order of parameters(). Residuals are differences over standard deviations, those of priors last; complex
/// ones count twice. It is the model before the fit's correction by the full geometry, which only time histories have.
/// Immutable; may be used from several threads at once.
class Objective {
 public:
  /// Reads the study and its recordings; arrays pass through a temporary folder. Throws Error.
  explicit Objective(const Study& study);

  /// The free ones, with the values of the vehicle's file and their ranges.
  std::vector<Parameter> parameters() const;
  Eigen::Index residual_count() const;

  /// Throws Error of kSimulation (code `evaluation-failed`) where the model has none at these values.
  Eigen::VectorXd Residuals(const Eigen::VectorXd& values) const;
  /// d residuals / d values, residuals x parameters, by the model itself or by central differences; within the ranges.
  /// Throws as Residuals() does, and Error of kInput (code `value-out-of-range`). `stop` as below.
  Eigen::MatrixXd Jacobian(const Eigen::VectorXd& values, const std::function<bool()>& stop = {}) const;

  /// A row of residuals for each row of values; NaN where the model has none. `threads`, 0: one per processor; no
  /// influence on the result. `stop`: asked by one thread at a time; true ends by Error of kSimulation.
  Eigen::MatrixXd ResidualsAt(const Eigen::MatrixXd& values, int threads = 0,
                              const std::function<bool()>& stop = {}) const;
  /// The cost that the fit minimises, by the study's loss, of each row of values; NaN where the model has none. Half of
  /// it is the negative logarithm of the likelihood where noise is normal and the loss is `none`.
  Eigen::VectorXd CostsAt(const Eigen::MatrixXd& values, int threads = 0, const std::function<bool()>& stop = {}) const;

 private:
  struct Inner;
  std::shared_ptr<const Inner> inner_;
};

}  // namespace fourpost::api
