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

/// See RefineOptions::agreement.
bool Agrees(const RefineResult& run, const RefineResult& best, double zero, const RefineOptions& options) {
  const auto freedom = static_cast<double>(std::max<Eigen::Index>(1, best.residuals.size() - best.values.size()));
  const double share = std::max(options.agreement / freedom, 100 * options.cost_tolerance);
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
    const std::int64_t paid_before = archive_.counts().paid;
    const std::optional<RefineResult> led = Led(start);
    result_.runs.push_back(led && led->met ? MetBy(*led, start) : Refined(led, start));
    RefineResult& run = result_.runs.back();
    run.evaluations = archive_.counts().paid - paid_before;
    Take(run);
    const bool is_at_optimum = run.end == RefineEnd::kConverged || run.end == RefineEnd::kKnown;
    if (led && is_at_optimum) led_.Add(*led, result_.runs.size() - 1);
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
  /// By the coarse residuals; nothing where they lead nowhere.
  std::optional<RefineResult> Led(const Eigen::VectorXd& start) {
    if (!coarse_) return std::nullopt;
    RefineResult led = Refine(*coarse_, start, leading_, stop_, led_.optima());
    if (!led.has_cost()) return std::nullopt;
    return led;
  }

  std::optional<double> CostAt(const Eigen::VectorXd& values) {
    const Evaluation there = archive_.EvaluateValues({values}).front();
    if (!there.ok()) return std::nullopt;
    return options_.loss.Cost(there.residuals);
  }

  /// The run from this start is one with that which made the coarse optimum.
  RefineResult MetBy(const RefineResult& led, const Eigen::VectorXd& start) {
    RefineResult run;
    run.start_cost = CostAt(start).value_or(std::numeric_limits<double>::quiet_NaN());
    run.iterations = led.iterations;
    run.coarse_evaluations = led.evaluations;
    GoOnTo(result_.runs[led_.PlaceOf(*led.met)], run);
    return run;
  }

  RefineResult Refined(const std::optional<RefineResult>& led, const Eigen::VectorXd& start) {
    if (!led) return Refine(archive_, start, options_, stop_, ended_.optima());
    const std::optional<double> before = CostAt(start);
    const std::optional<double> after = CostAt(led->values);
    const bool leads = after && (!before || *after < *before);
    RefineResult run = Refine(archive_, leads ? led->values : start, options_, stop_, ended_.optima());
    if (before) run.start_cost = *before;
    run.iterations += led->iterations;
    run.coarse_evaluations = led->evaluations;
    return run;
  }

  void Take(RefineResult& run) {
    if (run.met) GoOnTo(result_.runs[ended_.PlaceOf(*run.met)], run);
    result_.ended += run.has_ended();
    if (!run.has_cost()) return;
    const std::size_t place = result_.runs.size() - 1;
    ended_.Add(run, place);
    highest_start_ = std::max(highest_start_, run.start_cost);
    const bool wins = result_.best < 0 || run.cost < result_.runs[static_cast<std::size_t>(result_.best)].cost;
    if (wins) result_.best = static_cast<int>(place);
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
