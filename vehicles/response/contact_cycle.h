#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/response/harmonic_balance_options.h"
#include "vehicles/response/linearised_cycle.h"
#include "vehicles/response/tyre_contact.h"

namespace fourpost {

/// One cycle of a reduced vehicle whose tyres may leave their platforms. It is first solved with all tyres held. If
/// none of them would pull, this is the result, at the cost of linear tyres, because the nonlinear parts of lift-off
/// are zero. Otherwise it is solved with lift-off from there, and so are the following frequencies while a tyre lifts.
class ContactCycle {
 public:
  /// `shape`: of the posts, see Excitation. The model must outlive this object.
  ContactCycle(const CondensedModel& model, const std::vector<double>& shape, const HarmonicBalanceOptions& options);
  ContactCycle(const ContactCycle&) = delete;
  ContactCycle& operator=(const ContactCycle&) = delete;

  /// See LinearisedCycle::Solve.
  bool Solve(double frequency_Hz, double amplitude_m);

  /// That of the last solution: one for held tyres, another if one lifts.
  LinearisedCycle& cycle() { return lifts_ ? *lifting_ : held_; }
  const LinearisedCycle& cycle() const { return lifts_ ? *lifting_ : held_; }
  bool lifts() const { return lifts_; }

 private:
  bool SolveLifting(double frequency_Hz, double amplitude_m, const Eigen::MatrixXcd& start);
  bool AnyLifts() const;
  Eigen::MatrixXcd HeldExtensions() const;

  const CondensedModel& model_;
  std::vector<double> shape_;
  HarmonicBalanceOptions options_;
  LinearisedCycle held_;
  /// Contact of the tyres that may lift, while held; empty: there are none.
  std::optional<TyreContact> contact_;
  /// Made when needed.
  std::unique_ptr<LinearisedCycle> lifting_;
  bool lifts_ = false;
};

}  // namespace fourpost
