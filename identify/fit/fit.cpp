#include "identify/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identify/fit/first_order_step.h"
#include "identify/fit/fitted_parameters.h"
#include "identify/fit/held_parameters.h"
#include "identify/fit/input_noise.h"
#include "identify/refine/derivative_check.h"
#include "identify/refine/fit_variables.h"
#include "identify/refine/search_method_list.h"
#include "identify/refine/several_starts.h"
#include "identify/uncertainty/derivative_noise.h"

namespace fourpost {
namespace {

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

bool HasOwnDerivatives(Archive& archive, const RefineResult& best, const RefineOptions& options) {
  const FitVariables variables(archive.lattice());
  return best.jacobian.size() > 0 &&
         DerivativesHold(archive, variables, variables.FromValues(best.values), best.residuals, best.jacobian,
                         options.DifferenceStep(archive.problem()));
}

/// The model's own derivatives may be good enough for steps only: then differences end what they began, and give the
/// standard deviations. `report_and_ask` is called between the steps, `stop` within them.
RefineResult Polished(Archive& archive, const RefineResult& best, RefineOptions options,
                      const std::function<bool()>& report_and_ask, const std::function<bool()>& stop) {
  if (options.differences != Differences::kAutomatic || !archive.problem().differentiate || stop()) return best;
  archive.StopBatches(stop);
  RefineResult polished = best;
  try {
    if (HasOwnDerivatives(archive, best, options)) {
      archive.StopBatches({});
      return best;
    }
    options.differences = Differences::kCentral;
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
                       .coarse_evaluations = run.coarse_evaluations,
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

Problem ProblemOf(const VehicleObjective& objective, const FitOptions& options) {
  Problem problem = objective.MakeProblem();
  problem.deadline_s = options.deadline_s;
  return problem;
}

/// A fit while it runs: its stages share the archive, the result and what is reported.
class RunningFit {
 public:
  RunningFit(const VehicleObjective& objective, const FitOptions& options, const FitHooks& hooks,
             EvaluationStore* store)
      : objective_(objective),
        options_(options),
        hooks_(hooks),
        stop_(hooks.stop ? hooks.stop : [] { return false; }),
        archive_(ProblemOf(objective, options), options.threads, store) {
    archive_.Watch([&loss = options.refine.loss](const Eigen::VectorXd& residuals) { return loss.Cost(residuals); });
    archive_.TellProgress([this](std::int64_t of_batch) { Report(of_batch); });
    if (coarse_objective_) {
      coarse_.emplace(ProblemOf(*coarse_objective_, options), options.threads);
      coarse_->TellProgress([this](std::int64_t) { Report(); });
    }
    result_.values = objective.vehicle().ParameterValues();
    result_.residual_count = objective.residual_count() - objective.unmeasured_count();
    result_.prior_count = objective.prior_count();
    result_.options = options;
    result_.options.refine.step = options.refine.DifferenceStep(archive_.problem());
  }

  FitResult Run() {
    if (Identify() && Search()) Conclude(Refine());
    result_.evaluations = archive_.counts();
    if (coarse_) result_.coarse_evaluations = coarse_->counts().paid;
    return std::move(result_);
  }

 private:
  void Begin(std::string_view stage) {
    stage_ = stage;
    paid_before_ = archive_.counts().paid;
  }

  void Report(std::int64_t of_batch = 0) {
    if (!hooks_.progress) return;
    const EvaluationCounts& counts = archive_.counts();
    const std::int64_t paid = counts.paid + of_batch;
    hooks_.progress({.stage = stage_,
                     .best_cost = archive_.best_cost(),
                     .lattice = &archive_.lattice(),
                     .best = &archive_.best_values(),
                     .paid = paid,
                     .in_stage = paid - paid_before_,
                     .coarse = coarse_ ? coarse_->counts().paid : 0,
                     .profiled = result_.profiles.size(),
                     .reused = counts.reused,
                     .failed = counts.failed(),
                     .restored = counts.restored});
  }

  /// True where the fit goes on, as of Search().
  bool Identify() {
    if (!options_.identify_first || options_.from) return true;
    Begin("identifiability");
    Report();
    archive_.StopBatches(stop_);
    try {
      result_.before = IdentifiabilityBefore(archive_, objective_, options_.seed, options_.refine.differences);
    } catch (const BatchStopped&) {
      result_.end = FitEnd::kInterrupted;
      result_.message = "before its search began;";
      return false;
    }
    archive_.StopBatches({});
    if (!result_.before || !result_.before->HasUndetermined() || options_.accept_unidentified) return true;
    result_.end = FitEnd::kUnidentified;
    return false;
  }

  bool Search() {
    result_.search_settings = Settings(options_.search);
    if (options_.from) {
      result_.search.candidates = {{.values = *options_.from, .cost = std::nan("")}};
      return true;
    }
    Begin("search");
    const auto refine = [&](const Eigen::VectorXd& values, const std::function<bool()>& end) {
      const auto report_and_end = [&] {
        Report();
        return end();
      };
      return AcceleratedFrom(archive_, values, options_, report_and_end);
    };
    result_.search = RunMethod(options_.search, archive_, options_.seed, options_.stop, options_.candidates,
                               {[&](const SearchGeneration&) { Report(); }, stop_, refine});
    if (!result_.search.candidates.empty()) return true;
    result_.end = stop_() ? FitEnd::kInterrupted : FitEnd::kAllFailed;
    result_.message =
        stop_() ? "before its search found a point that can be evaluated;" : FailureCauses(archive_.counts());
    return false;
  }

  MultiStartResult Refine() {
    Begin("refine");
    const std::vector<Eigen::VectorXd> starts =
        options_.from ? std::vector{*options_.from} : Starts(result_.search, objective_, options_.starts);
    // From a fit it is not far.
    Archive* const coarse = coarse_ && !options_.from ? &*coarse_ : nullptr;
    MultiStartResult refined = RefineFrom(archive_, starts, options_.refine, report_and_ask_, coarse);
    result_.starts = refined.ended;
    result_.agreeing = refined.agreeing;
    result_.refined = Summarised(refined.runs, starts.size());
    if (options_.from)
      for (RefinedStart& run : result_.refined) run.from = "fit";
    return refined;
  }

  void Conclude(const MultiStartResult& refined) {
    Eigen::VectorXd values = result_.search.candidates.front().values;
    result_.end = stop_() ? FitEnd::kInterrupted : FitEnd::kNotConverged;
    if (refined.best >= 0) values = Determine(refined.runs[static_cast<std::size_t>(refined.best)]);
    else result_.cost = CostOf(archive_, result_.search.candidates.front(), options_.refine.loss);
    result_.prior_cost = objective_.PriorResiduals(values).squaredNorm();
    result_.parameters = DescribeParameters(objective_, archive_.lattice(), values, result_.certainty);
    result_.values = objective_.AllParameters(values);
  }

  /// Polishes the best refined point, adds what is known about it, and returns its values.
  Eigen::VectorXd Determine(const RefineResult& refined) {
    Begin("deviations");
    RefineResult best = Polished(archive_, refined, options_.refine, report_and_ask_, stop_);
    result_.end = EndOf(best, stop_());
    result_.message = best.message;
    if (best.jacobian.size() > 0) {
      std::vector<ParameterState> states =
          StatesAt(best, archive_.lattice(), NoisyAt(archive_, best, result_.prior_count, options_.refine, stop_));
      const std::vector<Eigen::Index> fixed = FixedOf(states);
      const Eigen::VectorXd left = RemainingStep(best, options_.refine.loss, result_.prior_count, fixed);
      if (!stop_()) AllowForIntegration(fixed, best);
      const InputNoise noise = AllowForInputNoise(fixed, best);
      std::optional<Calibrated> calibrated;
      if (!stop_()) calibrated = AllowForCalibrations(states, noise, best);
      if (calibrated) HoldAtBounds(best.values, states);
      AddCertainty(best, states, noise.gradient, calibrated);
      if (stop_()) EndWithoutDeviations();
      else if (result_.end != FitEnd::kConverged) JudgeEnd(left);
      if (result_.covariance) AddProfiles(best);
    }
    result_.cost = best.cost;
    return best.values;
  }

  /// Of those that calibrations took there.
  void HoldAtBounds(const Eigen::VectorXd& values, std::vector<ParameterState>& states) const {
    for (std::size_t j = 0; j < states.size(); ++j)
      if (states[j] == ParameterState::kDetermined &&
          IsAtBound(archive_.lattice().axes()[j], values[static_cast<Eigen::Index>(j)]))
        states[j] = ParameterState::kAtBound;
  }

  /// What held parameters and noise of the inputs do to the deviations may not have been computed.
  void EndWithoutDeviations() {
    result_.end = FitEnd::kInterrupted;
    DropCertainty();
  }

  void DropCertainty() {
    result_.certainty.reset();
    result_.covariance.reset();
    result_.weakest.clear();
  }

  /// Deviations are those of an optimum. One that is less than a tenth of them away is reached. `left`: the step to it.
  void JudgeEnd(const Eigen::VectorXd& left) {
    constexpr double kNear = 0.1;
    const std::vector<Eigen::Index>& judged = result_.certainty->judged;
    if (judged.empty()) return;
    const bool is_near = std::all_of(judged.begin(), judged.end(), [&](Eigen::Index j) {
      return std::abs(left[j]) < kNear * result_.certainty->total_sd[j];
    });
    if (is_near) result_.end = FitEnd::kConverged;
    else DropCertainty();
  }

  /// Moves the best point to where that of an exact integration is, if it is better by one that is nearly so. From
  /// there on residuals are those of such a one: what is left of them is noise and what the model lacks.
  void AllowForIntegration(const std::vector<Eigen::Index>& fixed, RefineResult& best) {
    const RobustLoss& loss = options_.refine.loss;
    const std::optional<Eigen::VectorXd> here = FinerResiduals(objective_, best);
    if (!here) return;
    const double coarse_cost = best.cost;
    Eigen::VectorXd finer = *here;
    RefineResult moved = best;
    if (MoveBy(archive_, IntegrationStep(objective_, best, *here, loss, fixed), loss, moved)) {
      const std::optional<Eigen::VectorXd> there = FinerResiduals(objective_, moved);
      if (there && loss.Cost(*there) < loss.Cost(*here)) {
        best = std::move(moved);
        finer = *there;
      }
    }
    archive_.ShiftResiduals(finer - best.residuals);
    best.residuals = std::move(finer);
    best.cost = loss.Cost(best.residuals);
    // Near the optimum the integration takes as much of the cost elsewhere.
    for (RefinedStart& run : result_.refined) run.cost += best.cost - coarse_cost;
  }

  /// Rise over cost is the power of the noise over that of the motion: a tenth is noise of a third of the motion. What
  /// a model lacks may look like more. Where the first order does not hold, the cost rises by more than it says.
  bool IsByNoise(const RefineResult& best, const Eigen::VectorXd& step, const RefineResult& moved) const {
    constexpr double kMost = 0.1;
    constexpr double kBeyond = 2;
    constexpr double kRounding = 0.01;
    const Eigen::Index data = best.jacobian.rows() - result_.prior_count;
    Eigen::VectorXd roots = Eigen::VectorXd::Ones(best.residuals.size());
    roots.head(data) = options_.refine.loss.OfData().Weights(best.residuals.head(data)).cwiseSqrt();
    const Eigen::VectorXd change = roots.cwiseProduct(best.jacobian * step);
    const double rise = change.squaredNorm();
    // The point may lie beside the optimum, where the integration's error was taken back.
    const double slope = std::max(0.0, 2 * change.dot(roots.cwiseProduct(best.residuals)));
    return rise <= kMost * best.cost && moved.cost - best.cost <= kBeyond * (rise + slope) + kRounding * best.cost;
  }

  /// Moves the best point by the bias that noise of the recorded inputs makes, and returns that; empty: not moved.
  InputNoise AllowForInputNoise(const std::vector<Eigen::Index>& fixed, RefineResult& best) {
    std::optional<InputNoise> noise =
        InputNoiseAt(objective_, best, options_.refine, fixed, options_.threads, stop_, result_.evaluations_beside);
    if (!noise) return {};
    RefineResult moved = best;
    if (!MoveBy(archive_, noise->step, options_.refine.loss, moved) || !IsByNoise(best, noise->step, moved)) {
      result_.is_input_noise_implausible = true;
      return {};
    }
    best = std::move(moved);
    result_.moved_by_input_noise = noise->step;
    result_.input_noise_squares = noise->squares;
    return *std::move(noise);
  }

  /// Parameters and calibrations together explain the data better than the former alone, where the first order holds.
  bool ExplainsMore(const Calibrated& found, const RefineResult& best, const RefineResult& moved) const {
    constexpr double kRounding = 0.01;
    Eigen::VectorXd corrected = moved.residuals;
    corrected.head(found.changes.rows()) += found.changes * found.mean;
    return options_.refine.loss.Cost(corrected) <= (1 + kRounding) * best.cost;
  }

  /// Moves the best point to that of calibrations that data and statement together make likeliest.
  std::optional<Calibrated> AllowForCalibrations(const std::vector<ParameterState>& states, const InputNoise& noise,
                                                 RefineResult& best) {
    std::optional<Calibrated> found =
        CalibratedAt(objective_, archive_.lattice(), best, options_.refine.loss, states, noise);
    result_.are_calibrations_unused = !objective_.calibrations().empty() && !found;
    if (!found) return std::nullopt;
    RefineResult moved = best;
    if (MoveBy(archive_, found->step, options_.refine.loss, moved) && ExplainsMore(*found, best, moved)) {
      best = std::move(moved);
    } else {
      found->TakeAsStated();
      result_.are_calibrations_unused = true;
    }
    return found;
  }

  void AddCertainty(RefineResult best, const std::vector<ParameterState>& states, const Eigen::MatrixXd& input_noise,
                    const std::optional<Calibrated>& calibrated) {
    if (calibrated) best.residuals.head(calibrated->changes.rows()) += calibrated->changes * calibrated->mean;
    const HeldParameters held =
        HeldAt(objective_, best.values, options_.refine, options_.threads, stop_, result_.evaluations_beside);
    result_.certainty =
        CertaintyAt(objective_, archive_.lattice(), best, options_.refine.loss, states, input_noise, held, calibrated);
    result_.covariance = result_.certainty->covariance;
    result_.data_squares = best.residuals.head(best.residuals.size() - result_.prior_count).squaredNorm();
    result_.weakest = WeakestDirections(archive_.lattice(), *result_.covariance);
  }

  void AddProfiles(const RefineResult& best) {
    Begin("profile");
    for (const Eigen::Index index : options_.profiled) {
      if (!stop_())
        result_.profiles.push_back(
            ProfileOf(archive_, best, *result_.covariance, index, options_.refine, report_and_ask_));
      if (stop_()) result_.end = FitEnd::kInterrupted;
    }
  }

  const VehicleObjective& objective_;
  const FitOptions& options_;
  const FitHooks& hooks_;
  const std::function<bool()> stop_;
  const std::function<bool()> report_and_ask_ = [this] {
    Report();
    return stop_();
  };
  Archive archive_;
  /// They lead refinements.
  const std::optional<VehicleObjective> coarse_objective_ = objective_.Coarse();
  std::optional<Archive> coarse_;
  FitResult result_;
  std::string_view stage_;
  std::int64_t paid_before_ = 0;
};

}  // namespace

FitResult Fit(const VehicleObjective& objective, const FitOptions& options, const FitHooks& hooks,
              EvaluationStore* store) {
  return RunningFit(objective, options, hooks, store).Run();
}

}  // namespace fourpost
