#include "identify/search/evaluation.h"

#include <cmath>
#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include "analysis/text/number.h"

namespace fourpost {
namespace {

// One that is not a number would not order infeasible points.
Evaluation CheckedViolation(Evaluation evaluation) {
  const double violation = evaluation.violation;
  if (std::isfinite(violation) && violation >= 0) return Infeasible(violation, std::move(evaluation.detail));
  return Failed(Failure::kException, "the violation must be finite and 0 or more, not " + std::to_string(violation) +
                                         " (" + evaluation.detail + ")");
}

Evaluation Checked(Evaluation evaluation) {
  if (evaluation.failure == Failure::kInfeasible) return CheckedViolation(std::move(evaluation));
  if (!evaluation.ok()) return Failed(evaluation.failure, std::move(evaluation.detail));
  if (evaluation.residuals.size() == 0) return Failed(Failure::kWrongSize, "the model gave no residuals");
  if (!evaluation.residuals.allFinite()) return Failed(Failure::kNotFinite, "a residual is not finite");
  if (!std::isfinite(evaluation.cost())) return Failed(Failure::kNotFinite, "the sum of squares overflows");
  return evaluation;
}

}  // namespace

std::string_view FailureName(Failure failure) {
  switch (failure) {
    case Failure::kNone: return "none";
    case Failure::kNotFinite: return "not finite";
    case Failure::kException: return "exception";
    case Failure::kNotConverged: return "not converged";
    case Failure::kTimedOut: return "timed out";
    case Failure::kInfeasible: return "infeasible";
    case Failure::kWrongSize: return "wrong size";
  }
  return "unknown";
}

double Evaluation::cost() const {
  if (!ok()) throw std::logic_error("a failed evaluation has no cost: " + detail);
  return residuals.squaredNorm();
}

Evaluation Failed(Failure failure, std::string detail) {
  Evaluation evaluation;
  evaluation.failure = failure;
  evaluation.detail = std::move(detail);
  return evaluation;
}

Evaluation Infeasible(double violation, std::string detail) {
  Evaluation evaluation = Failed(Failure::kInfeasible, std::move(detail));
  evaluation.violation = violation;
  return evaluation;
}

std::string BytesOf(const Eigen::VectorXd& values) {
  return {reinterpret_cast<const char*>(values.data()), static_cast<std::size_t>(values.size()) * sizeof(double)};
}

Evaluation EvaluateGuarded(const Problem& problem, const Eigen::VectorXd& values) {
  try {
    return Checked(problem.evaluate(values, Deadline::In(problem.deadline_s)));
  } catch (const TimedOut&) {
    return Failed(Failure::kTimedOut, "took longer than " + FormatNumber(problem.deadline_s) + " s");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return Failed(Failure::kException, error.what());
  } catch (...) {
    return Failed(Failure::kException, "an exception of unknown type");
  }
}

}  // namespace fourpost
