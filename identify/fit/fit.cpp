#include "identify/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identify/fit/input_noise.h"
#include "identify/refine/fit_variables.h"
#include "identify/refine/search_method_list.h"
#include "identify/uncertainty/derivative_noise.h"
#include "vehicles/reader/physical_range.h"

namespace fourpost {
namespace {

/// Deviation, its parts and the interval of a parameter; `k`: its place among the free ones.
void DescribeCertainty(const Certainty& certainty, Eigen::Index k, double slope, bool is_logarithmic,
                       const PhysicalRange& physical, FittedParameter& fitted) {
  fitted.state = certainty.states[static_cast<std::size_t>(k)];
  fitted.sd = slope * certainty.total_sd[k];
  fitted.noise_sd = slope * certainty.noise_sd[k];
  fitted.held_sd = slope * certainty.held_sd[k];
  fitted.model_sd = slope * certainty.model_sd[k];
  fitted.limited_by = certainty.LimitedBy(k);
  const double range = fitted.upper - fitted.lower;
  const auto end = [&](double sd, int side) {
    const double reach = side * certainty.covariance.reach_95 * sd;
    return is_logarithmic ? fitted.value * std::exp(reach) : fitted.value + reach * range;
  };
  // Noise may reach beyond the range that the file gives; what the model lacks is not known so well.
  const double noise = certainty.noise_sd[k];
  const double total = certainty.total_sd[k];
  fitted.lower_95 = std::max(end(total, -1), std::min(end(noise, -1), fitted.lower));
  fitted.upper_95 = std::min(end(total, 1), std::max(end(noise, 1), fitted.upper));
  if (!std::isfinite(fitted.sd)) return;
  fitted.lower_95 = std::max(fitted.lower_95, physical.least);
  fitted.upper_95 = std::min(fitted.upper_95, physical.greatest);
}

std::vector<FittedParameter> Describe(const VehicleObjective& objective, const Lattice& lattice,
                                      const Eigen::VectorXd& values, const std::optional<Certainty>& certainty) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const FitVariables variables(lattice);
  const Eigen::VectorXd slopes = variables.Slopes(values);
  const std::vector<PhysicalRange> physical = PhysicalRanges(objective.vehicle());
  std::vector<FittedParameter> out;
  for (std::size_t i = 0; i < objective.free().size(); ++i) {
    const Parameter& parameter = objective.vehicle().parameters[objective.free()[i]];
    const Eigen::Index k = static_cast<Eigen::Index>(i);
    FittedParameter fitted;
    fitted.name = parameter.name;
    fitted.start = parameter.value;
    fitted.value = values[k];
    fitted.prior_sd = parameter.prior_sd;
    fitted.lower = parameter.lower;
    fitted.upper = parameter.upper;
    fitted.sd = fitted.noise_sd = fitted.held_sd = fitted.model_sd = fitted.lower_95 = fitted.upper_95 = kUnknown;
    if (certainty)
      DescribeCertainty(*certainty, k, slopes[k], variables.is_logarithmic(k), physical[objective.free()[i]], fitted);
    fitted.at_bound = IsAtBound(lattice.axes()[i], values[k]);
    fitted.dimension = parameter.dimension;
    fitted.unit = parameter.unit;
    out.push_back(fitted);
  }
  return out;
}

/// Of the data's derivatives at an optimum; none where the user stops it.
std::vector<Eigen::Index> NoisyAt(Archive& archive, const RefineResult& best, Eigen::Index prior_count,
                                  const RefineOptions& options, const std::function<bool()>& stop) {
  std::optional<Eigen::MatrixXd> again;
  const FitVariables variables(archive.lattice());
  archive.StopBatches(stop);
  try {
    again = JacobianAgain(archive, variables, variables.FromValues(best.values), best.residuals,
                          options.DifferenceStep(archive.problem()));
  } catch (const BatchStopped&) {
  }
  archive.StopBatches({});
  if (!again) return {};
  const Eigen::Index data = best.jacobian.rows() - prior_count;
  return NoisyColumns(best.jacobian.topRows(data), again->topRows(data));
}

/// Takes a step of FitVariables from an optimum, within the bounds; derivatives stay those of the optimum. False where
/// the model cannot be evaluated there.
bool MoveBy(Archive& archive, const Eigen::VectorXd& step, const RobustLoss& loss, RefineResult& best) {
  const FitVariables variables(archive.lattice());
  const Eigen::VectorXd values = variables.ToValues(
      (variables.FromValues(best.values) + step).cwiseMax(variables.lower()).cwiseMin(variables.upper()));
  const Evaluation there = archive.EvaluateValues({values}).front();
  if (!there.ok()) return false;
  best.values = values;
  best.residuals = there.residuals;
  best.cost = loss.Cost(there.residuals);
  return true;
}

std::string FailureCauses(const EvaluationCounts& counts) {
  std::string text = "every evaluation failed:";
  for (const auto& [cause, tally] : counts.failures)
    text += " " + std::to_string(tally.count) + " " + std::string(FailureName(cause)) + " (" + tally.example + ");";
  return text;
}

FitEnd EndOf(const RefineResult& best, bool interrupted) {
  if (interrupted) return FitEnd::kInterrupted;
  return best.end == RefineEnd::kConverged ? FitEnd::kConverged : FitEnd::kNotConverged;
}

/// Distinct good points of the search, and the vehicle's own values.
std::vector<Eigen::VectorXd> Starts(const SearchResult& search, const VehicleObjective& objective, int count) {
  std::vector<Eigen::VectorXd> starts;
  for (const Candidate& candidate : search.candidates)
    if (static_cast<int>(starts.size()) < count) starts.push_back(candidate.values);
  starts.push_back(objective.FileValues());
  return starts;
}

/// The model's own derivatives may be good enough for steps only: differences end what they began, and give
/// the standard deviations.
/// `report_and_ask` is called between the steps, `stop` within them.
RefineResult Polished(Archive& archive, const RefineResult& best, RefineOptions options,
                      const std::function<bool()>& report_and_ask, const std::function<bool()>& stop) {
  if (options.differences != Differences::kAutomatic || !archive.problem().differentiate || stop()) return best;
  options.differences = Differences::kCentral;
  archive.StopBatches(stop);
  RefineResult polished = best;
  try {
    polished = Refine(archive, best.values, options, report_and_ask);
  } catch (const BatchStopped&) {
  }
  archive.StopBatches({});
  return polished.has_cost() && polished.cost <= best.cost ? polished : best;
}

/// The vehicle's own values come last; after an interruption they may be left out.
std::vector<RefinedStart> Summarised(const std::vector<RefineResult>& runs, std::size_t starts) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<RefinedStart> refined;
  for (const RefineResult& run : runs) {
    const bool is_last = refined.size() + 1 == starts;
    refined.push_back({.from = is_last ? "vehicle file" : "search",
                       .end = run.end,
                       .start_cost = run.has_cost() ? run.start_cost : kNone,
                       .cost = run.has_cost() ? run.cost : kNone,
                       .iterations = run.iterations,
                       .evaluations = run.evaluations,
                       .agrees = run.agrees,
                       .values = {run.values.begin(), run.values.end()}});
  }
  return refined;
}

/// By the refinement's loss; of the search squares are known, no residuals. NaN when it fails now.
double CostOf(Archive& archive, const Candidate& candidate, const RobustLoss& loss) {
  if (loss.kind() == LossKind::kNone) return candidate.cost;
  const Evaluation again = archive.EvaluateValues({candidate.values}).front();
  return again.ok() ? loss.Cost(again.residuals) : std::numeric_limits<double>::quiet_NaN();
}

/// As dvHDE accelerates: squares alone, since a robust loss gives little direction far from the optimum.
Eigen::VectorXd AcceleratedFrom(Archive& archive, const Eigen::VectorXd& values, const FitOptions& options,
                                const std::function<bool()>& stop) {
  RefineOptions refine = options.refine;
  refine.loss = {};
  if (const auto* dvhde = std::get_if<DvhdeOptions>(&options.search)) refine.max_iterations = dvhde->refine_iterations;
  const RefineResult result = Refine(archive, values, refine, stop);
  return result.has_cost() ? result.values : values;
}

}  // namespace

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
  return std::sqrt(data_squares / static_cast<double>(residual_count - prior_count - covariance->rank));
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
  return ParameterSpread{.lattice = Lattice(std::move(axes)),
                         .values = std::move(fitted),
                         .judged = certainty->judged,
                         .noise = certainty->noise_covariance,
                         .total = certainty->total_covariance};
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

FitResult Fit(const VehicleObjective& objective, const FitOptions& options, const FitHooks& hooks,
              EvaluationStore* store) {
  Problem problem = objective.MakeProblem();
  problem.deadline_s = options.deadline_s;
  Archive archive(std::move(problem), options.threads, store);
  archive.Watch([&loss = options.refine.loss](const Eigen::VectorXd& residuals) { return loss.Cost(residuals); });
  const std::function<bool()> stop = hooks.stop ? hooks.stop : [] { return false; };
  FitResult result;
  std::string_view stage_now;
  std::int64_t paid_before = 0;
  const auto begin = [&](std::string_view stage) {
    stage_now = stage;
    paid_before = archive.counts().paid;
  };
  const auto report_within = [&](std::int64_t of_batch) {
    const EvaluationCounts& counts = archive.counts();
    if (!hooks.progress) return;
    const std::int64_t paid = counts.paid + of_batch;
    hooks.progress({.stage = stage_now,
                    .best_cost = archive.best_cost(),
                    .paid = paid,
                    .in_stage = paid - paid_before,
                    .profiled = result.profiles.size(),
                    .reused = counts.reused,
                    .failed = counts.failed(),
                    .restored = counts.restored});
  };
  archive.TellProgress(report_within);
  const auto report = [&] { report_within(0); };

  result.values = objective.vehicle().ParameterValues();
  result.residual_count = objective.residual_count();
  result.prior_count = objective.prior_count();
  result.options = options;
  result.options.refine.step = options.refine.DifferenceStep(archive.problem());
  if (options.identify_first && !options.from) {
    begin("identifiability");
    report();
    archive.StopBatches(stop);
    try {
      result.before = IdentifiabilityBefore(archive, objective, options.seed);
    } catch (const BatchStopped&) {
      result.end = FitEnd::kInterrupted;
      result.message = "before its search began;";
      result.evaluations = archive.counts();
      return result;
    }
    archive.StopBatches({});
    if (result.before && result.before->HasUndetermined() && !options.accept_unidentified) {
      result.end = FitEnd::kUnidentified;
      result.evaluations = archive.counts();
      return result;
    }
  }
  if (options.from) {
    result.search.candidates = {{.values = *options.from}};
  } else {
    begin("search");
    const auto refine = [&](const Eigen::VectorXd& values, const std::function<bool()>& end) {
      const auto report_and_end = [&] {
        report();
        return end();
      };
      return AcceleratedFrom(archive, values, options, report_and_end);
    };
    result.search = RunMethod(options.search, archive, options.seed, options.stop, options.candidates,
                              {[&](const SearchGeneration&) { report(); }, stop, refine});
  }
  result.search_settings = Settings(options.search);
  result.evaluations = archive.counts();
  if (result.search.candidates.empty()) {
    result.end = stop() ? FitEnd::kInterrupted : FitEnd::kAllFailed;
    result.message =
        stop() ? "before its search found a point that can be evaluated;" : FailureCauses(archive.counts());
    return result;
  }

  begin("refine");
  const auto report_and_ask = [&] {
    report();
    return stop();
  };
  const std::vector<Eigen::VectorXd> starts =
      options.from ? std::vector{*options.from} : Starts(result.search, objective, options.starts);
  const MultiStartResult refined = RefineFrom(archive, starts, options.refine, report_and_ask);
  result.starts = refined.ended;
  result.agreeing = refined.agreeing;
  result.refined = Summarised(refined.runs, starts.size());
  if (options.from)
    for (RefinedStart& run : result.refined) run.from = "fit";

  Eigen::VectorXd values = result.search.candidates.front().values;
  std::optional<Certainty> certainty;
  result.end = stop() ? FitEnd::kInterrupted : FitEnd::kNotConverged;
  if (refined.best >= 0) {
    begin("deviations");
    RefineResult best =
        Polished(archive, refined.runs[static_cast<std::size_t>(refined.best)], options.refine, report_and_ask, stop);
    result.end = EndOf(best, stop());
    result.message = best.message;
    Eigen::MatrixXd input_noise;
    std::vector<ParameterState> states;
    if (best.jacobian.size() > 0) {
      states = StatesAt(best, archive.lattice(), NoisyAt(archive, best, result.prior_count, options.refine, stop));
      const std::optional<InputNoise> noise = InputNoiseAt(objective, best, options.refine, FixedOf(states),
                                                           options.threads, stop, result.evaluations_beside);
      if (noise && MoveBy(archive, noise->step, options.refine.loss, best)) {
        result.moved_by_input_noise = noise->step;
        input_noise = noise->gradient;
      }
    }
    values = best.values;
    result.cost = best.cost;
    if (best.jacobian.size() > 0) {
      const HeldParameters held =
          HeldAt(objective, best.values, options.refine, options.threads, stop, result.evaluations_beside);
      certainty = CertaintyAt(objective, archive.lattice(), best, options.refine.loss, states, input_noise, held);
      result.covariance = certainty->covariance;
      result.certainty = certainty;
      result.data_squares = best.residuals.head(best.residuals.size() - result.prior_count).squaredNorm();
      result.weakest = WeakestDirections(archive.lattice(), *result.covariance);
      begin("profile");
      const auto report_profile = [&] {
        report();
        return stop();
      };
      for (const Eigen::Index index : options.profiled)
        if (!stop())
          result.profiles.push_back(
              ProfileOf(archive, best, *result.covariance, index, options.refine, report_profile));
    }
  } else {
    result.cost = CostOf(archive, result.search.candidates.front(), options.refine.loss);
  }
  result.evaluations = archive.counts();
  result.prior_cost = objective.PriorResiduals(values).squaredNorm();
  result.parameters = Describe(objective, archive.lattice(), values, certainty);
  result.values = objective.AllParameters(values);
  return result;
}

}  // namespace fourpost
