#include "identify/fit/fit_result.h"

#include <cmath>
#include <limits>
#include <utility>

namespace fourpost {

std::string_view FitEndName(FitEnd end) {
  switch (end) {
    case FitEnd::kNotRun: return "not_run";
    case FitEnd::kConverged: return "converged";
    case FitEnd::kNotConverged: return "not_converged";
    case FitEnd::kInterrupted: return "interrupted";
    case FitEnd::kAllFailed: return "all_failed";
    case FitEnd::kUnidentified: return "unidentified";
  }
  return "";
}

double FitResult::Misfit() const {
  if (!covariance) return std::numeric_limits<double>::quiet_NaN();
  const auto freedom = static_cast<double>(residual_count - prior_count - covariance->rank);
  return std::sqrt(data_squares / (freedom + input_noise_squares));
}

std::optional<ParameterSpread> FitResult::Spread() const {
  constexpr double kSteps = 1000;  // what is made of it has none
  if (!certainty || certainty->judged.empty()) return std::nullopt;
  std::vector<LatticeAxis> axes;
  Eigen::VectorXd fitted(static_cast<Eigen::Index>(parameters.size()));
  for (const FittedParameter& one : parameters) {
    fitted[static_cast<Eigen::Index>(axes.size())] = one.value;
    axes.push_back({one.name, one.lower, one.upper, (one.upper - one.lower) / kSteps});
  }
  Eigen::VectorXd moved;
  if (!certainty->missing.empty()) moved = certainty->MovedByMissing()(certainty->judged);
  return ParameterSpread{.lattice = Lattice(std::move(axes)),
                         .values = std::move(fitted),
                         .judged = certainty->judged,
                         .noise = certainty->noise_covariance,
                         .total = certainty->total_covariance,
                         .moved = std::move(moved)};
}

void FitResult::DropDeviations() {
  covariance.reset();
  certainty.reset();
  for (FittedParameter& parameter : parameters) {
    parameter.state = ParameterState::kNotComputed;
    parameter.sd = parameter.noise_sd = parameter.held_sd = parameter.model_sd = parameter.lower_95 =
        parameter.upper_95 = std::nan("");
  }
}

}  // namespace fourpost
