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

/// One cycle of a condensed vehicle whose tyres may leave their platforms. It is solved with all tyres held first;
/// where none of them would pull that is the answer, for the remainders of lift-off are zero, and costs what linear
/// tyres cost. Where one would, it is solved with lift-off from there, and from then on from one frequency to the next
/// while a tyre lifts.
class ContactCycle {
 public:
  /// `shape`: of the posts, see Excitation. The model must outlive this object.
  ContactCycle(const CondensedModel& model, const std::vector<double>& shape, const HarmonicBalanceOptions& options);
  ContactCycle(const ContactCycle&) = delete;
  ContactCycle& operator=(const ContactCycle&) = delete;

  /// See LinearisedCycle::Solve.
  bool Solve(double frequency_Hz, double amplitude_m);

  /// That of the last solution: one for tyres that are held, another one where one lifts.
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
  /// Of the tyres that may lift, while held; none: there are none.
  std::optional<TyreContact> contact_;
  /// Made when needed.
  std::unique_ptr<LinearisedCycle> lifting_;
  bool lifts_ = false;
};

}  // namespace fourpost
