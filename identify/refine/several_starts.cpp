#include "identify/refine/several_starts.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "identify/refine/fit_variables.h"
#include "identify/refine/known_optima.h"

namespace fourpost {
namespace {

/// Runs that went all the way, by their places among all.
class EndedRuns {
 public:
  EndedRuns(const FitVariables& variables, const RobustLoss& loss) : variables_(variables), loss_(loss) {}

  void Add(const RefineResult& run, std::size_t place) {
    if (run.end != RefineEnd::kConverged || run.jacobian.size() == 0) return;
    const Eigen::MatrixXd weighted = loss_.Weights(run.residuals).asDiagonal() * run.jacobian;
    optima_.Add(
        {.x = variables_.FromValues(run.values), .cost = run.cost, .normal = run.jacobian.transpose() * weighted});
    places_.push_back(place);
  }

  const KnownOptima& optima() const { return optima_; }
  std::size_t PlaceOf(std::size_t optimum) const { return places_[optimum]; }

 private:
  const FitVariables& variables_;
  const RobustLoss& loss_;
  KnownOptima optima_;
  std::vector<std::size_t> places_;
};

double FreedomOf(const RefineResult& run) {
  return static_cast<double>(std::max<Eigen::Index>(1, run.residuals.size() - run.values.size()));
}

/// See RefineOptions::agreement.
bool Agrees(const RefineResult& run, const RefineResult& best, double zero, const RefineOptions& options) {
  const double share = std::max(options.agreement / FreedomOf(best), 100 * options.cost_tolerance);
  return run.cost <= zero || run.cost - best.cost <= share * best.cost;
}

/// To the optimum that it met.
void GoOnTo(const RefineResult& optimum, RefineResult& run) {
  run.end = RefineEnd::kKnown;
  run.values = optimum.values;
  run.cost = optimum.cost;
  run.residuals = optimum.residuals;
  run.jacobian = optimum.jacobian;
}

class SeveralStarts {
 public:
  SeveralStarts(Archive& archive, const RefineOptions& options, const std::function<bool()>& stop, Archive* coarse)
      : archive_(archive), options_(options), stop_(stop), coarse_(coarse), variables_(archive.lattice()) {
    // It need not end in its optimum, only so near that others are known to have met it.
    constexpr double kNearCoarse = 0.2;
    leading_.nearness = std::max(options.nearness, kNearCoarse);
  }

  void From(const Eigen::VectorXd& start) {
    const std::int64_t paid = archive_.counts().paid;
    const std::int64_t coarse_paid = coarse_ ? coarse_->counts().paid : 0;
    RefineResult run = coarse_ ? RefinedByBoth(start) : Refine(archive_, start, options_, stop_, ended_.optima());
    run.evaluations = archive_.counts().paid - paid;
    if (coarse_) run.coarse_evaluations = coarse_->counts().paid - coarse_paid;
    Take(std::move(run));
  }

  MultiStartResult Judged() {
    if (result_.best < 0) return std::move(result_);
    const RefineResult& best = result_.runs[static_cast<std::size_t>(result_.best)];
    for (RefineResult& run : result_.runs) {
      run.agrees = run.has_cost() && run.has_ended() && Agrees(run, best, 1e-12 * highest_start_, options_);
      result_.agreeing += run.agrees;
    }
    return std::move(result_);
  }

 private:
  RefineResult RefinedByBoth(const Eigen::VectorXd& start) {
    const Evaluation at_start = archive_.EvaluateValues({start}).front();
    const RefineResult led = Refine(*coarse_, start, leading_, stop_, led_.optima());
    RefineResult run = Refined(start, at_start, led);
    run.start_cost = CostOf(at_start).value_or(std::numeric_limits<double>::quiet_NaN());
    return run;
  }

  RefineResult Refined(const Eigen::VectorXd& start, const Evaluation& at_start, const RefineResult& led) {
    const std::optional<double> before = CostOf(at_start);
    if (led.end == RefineEnd::kStopped && before)
      return {.end = RefineEnd::kStopped, .values = start, .cost = *before, .residuals = at_start.residuals};
    if (const std::optional<std::size_t> place = MetBy(led); place && LeadsTo(result_.runs[*place].cost, before)) {
      RefineResult run{.iterations = led.iterations};
      GoOnTo(result_.runs[*place], run);
      return run;
    }
    const Evaluation at_end = led.has_cost() ? archive_.EvaluateValues({led.values}).front() : at_start;
    const std::optional<double> after = CostOf(at_end);
    if (!led.has_cost() || !after || !LeadsTo(*after, before))
      return Refine(archive_, start, options_, stop_, ended_.optima(), &at_start);
    RefineOptions rest = options_;
    rest.max_iterations = std::max(1, options_.max_iterations - led.iterations);
    RefineResult run = Refine(archive_, led.values, rest, stop_, ended_.optima(), &at_end);
    run.iterations += led.iterations;
    // What comes there later is one with it, but for one that it was of no use to.
    if (run.end == RefineEnd::kConverged) led_.Add(led, result_.runs.size());
    return run;
  }

  /// The place of the run that came to the same coarse optimum.
  std::optional<std::size_t> MetBy(const RefineResult& led) const {
    if (led.met) return led_.PlaceOf(*led.met);
    if (led.end != RefineEnd::kConverged) return std::nullopt;
    const std::optional<std::size_t> one =
        led_.optima().OneWith(variables_.FromValues(led.values), led.cost, FreedomOf(led), options_.agreement);
    return one ? std::optional(led_.PlaceOf(*one)) : std::nullopt;
  }

  static bool LeadsTo(double cost, const std::optional<double>& before) { return !before || cost < *before; }

  std::optional<double> CostOf(const Evaluation& evaluation) const {
    if (!evaluation.ok()) return std::nullopt;
    return options_.loss.Cost(evaluation.residuals);
  }

  void Take(RefineResult run) {
    if (run.met) GoOnTo(result_.runs[ended_.PlaceOf(*run.met)], run);
    result_.ended += run.has_ended();
    const std::size_t place = result_.runs.size();
    if (run.has_cost()) {
      ended_.Add(run, place);
      highest_start_ = std::max(highest_start_, run.start_cost);
      const bool wins = result_.best < 0 || run.cost < result_.runs[static_cast<std::size_t>(result_.best)].cost;
      if (wins) result_.best = static_cast<int>(place);
    }
    result_.runs.push_back(std::move(run));
  }

  Archive& archive_;
  const RefineOptions& options_;
  const std::function<bool()>& stop_;
  Archive* coarse_;
  RefineOptions leading_ = options_;
  FitVariables variables_;
  EndedRuns ended_{variables_, options_.loss};
  EndedRuns led_{variables_, options_.loss};
  double highest_start_ = 0;
  MultiStartResult result_;
};

}  // namespace

MultiStartResult RefineFrom(Archive& archive, const std::vector<Eigen::VectorXd>& starts, const RefineOptions& options,
                            const std::function<bool()>& stop, Archive* coarse) {
  SeveralStarts several(archive, options, stop, coarse);
  for (const Eigen::VectorXd& start : starts) {
    if (stop && stop()) break;
    several.From(start);
  }
  return several.Judged();
}

}  // namespace fourpost
