#include "vehicles/response/contact_cycle.h"

#include "vehicles/condensed/port.h"

namespace fourpost {

ContactCycle::ContactCycle(const CondensedModel& model, const std::vector<double>& shape,
                           const HarmonicBalanceOptions& options)
    : model_(model), shape_(shape), options_(options), held_(model, shape, options, HeldPortsOf(model)) {
  if (!model.liftoffs.empty()) contact_.emplace(model.liftoffs, held_);
}

bool ContactCycle::Solve(double frequency_Hz, double amplitude_m) {
  // Next to the motion of the frequency before; once no tyre lifts any more, as if none ever had.
  if (lifts_ && SolveLifting(frequency_Hz, amplitude_m, {}) && AnyLifts()) return true;
  lifts_ = false;
  const bool converged = held_.Solve(frequency_Hz, amplitude_m);
  if (!contact_ || contact_->Presses()) return converged;
  return SolveLifting(frequency_Hz, amplitude_m, converged ? HeldExtensions() : Eigen::MatrixXcd());
}

bool ContactCycle::SolveLifting(double frequency_Hz, double amplitude_m, const Eigen::MatrixXcd& start) {
  if (!lifting_) lifting_ = std::make_unique<LinearisedCycle>(model_, shape_, options_, PortsOf(model_));
  lifts_ = true;
  return lifting_->Solve(frequency_Hz, amplitude_m, start);
}

bool ContactCycle::AnyLifts() const {
  return !lifting_->remainder().rightCols(static_cast<Eigen::Index>(model_.liftoffs.size())).isZero(0);
}

/// Of all ports, those of the tyres too.
Eigen::MatrixXcd ContactCycle::HeldExtensions() const {
  const Eigen::MatrixXcd squeezes = contact_->Squeezes();
  Eigen::MatrixXcd extensions(squeezes.rows(), held_.extension().cols() + squeezes.cols());
  extensions << held_.extension(), squeezes;
  return extensions;
}

}  // namespace fourpost
