#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "identify/fit/certainty.h"
#include "identify/fit/fit_options.h"
#include "identify/fit/identifiability.h"
#include "identify/refine/refine.h"
#include "identify/search/archive.h"
#include "identify/uncertainty/covariance.h"
#include "identify/uncertainty/parameter_spread.h"
#include "identify/uncertainty/parameter_state.h"
#include "identify/uncertainty/profile.h"

namespace fourpost {

enum class FitEnd { kNotRun, kConverged, kNotConverged, kInterrupted, kAllFailed, kUnidentified };

/// "converged", "interrupted", ... as in result.json.
std::string_view FitEndName(FitEnd end);

/// Above this share of the residuals noise of recorded inputs hides what a vehicle lacks.
inline constexpr double kMostlyInputNoise = 0.5;

/// A fitted parameter; SI.
struct FittedParameter {
  std::string name;
  double start = 0;
  double value = 0;
  /// What was known of it before the fit: normal about `start`, with this deviation.
  std::optional<double> prior_sd;
  /// As in Parameter, and how far the fit took the ratio, in its deviations.
  std::optional<Parameter::Likeness> like = {};
  double from_like = 0;
  double lower = 0;
  double upper = 0;
  ParameterState state = ParameterState::kNotComputed;
  /// Standard deviation, while parameters at a bound and those of noise stay where they are; infinite when nothing
  /// determines the parameter; NaN of those at a bound and of noise.
  double sd = 0;
  /// Its parts, whose squares add up: of noise; of parameters that are held though they have ranges; of what the model
  /// lacks, see EstimateModelError().
  double noise_sd = 0;
  double held_sd = 0;
  double model_sd = 0;
  /// See Certainty::LimitedBy().
  std::string limited_by;
  /// Interval of the certainty's confidence, about the logarithm of the value where the fit is of that (see
  /// FitVariables). Beyond a bound of the parameter it reaches by noise alone, never beyond what is physical, see
  /// PhysicalRanges(); what held parameters and the model's errors would add there is cut at the bound. Infinite and
  /// NaN like `sd`.
  double lower_95 = 0;
  double upper_95 = 0;
  bool at_bound = false;
  Dimension dimension;
  /// As the vehicle file writes it.
  std::string unit;

  double RelativeSd() const { return fourpost::RelativeSd(sd, value, lower, upper); }
  std::string_view CutAt() const { return IntervalCutAt(lower_95, upper_95, lower, upper); }

  /// "lower" or "upper", of one at its bound.
  std::string_view BoundName() const { return value - lower < upper - value ? "lower" : "upper"; }

  /// How far the fit took it from its prior, in deviations of the prior; zero without one.
  double FromPrior() const { return prior_sd ? (value - start) / *prior_sd : 0; }
};

/// What a refinement made of its start.
struct RefinedStart {
  /// "search", "vehicle file" or "fit", see FitOptions::from
  std::string from;
  RefineEnd end = RefineEnd::kNotRun;
  double start_cost = 0;
  double cost = 0;
  int iterations = 0;
  std::int64_t evaluations = 0;
  std::int64_t coarse_evaluations = 0;
  /// With the best, see RefineOptions::agreement.
  bool agrees = false;
  /// Of the free parameters, SI.
  std::vector<double> values;
};

struct FitResult {
  FitEnd end = FitEnd::kNotRun;
  std::string message;
  /// Sum of squared whitened residuals, or of the refinement's loss of them, and how many of them were measured; priors
  /// included.
  double cost = 0;
  /// With which it was run; the step of central differences is the one that was used.
  FitOptions options;
  /// Sum of squares of the data's residuals, whatever the loss; with the covariance.
  double data_squares = 0;
  Eigen::Index residual_count = 0;
  /// Those of the priors among them.
  double prior_cost = 0;
  Eigen::Index prior_count = 0;
  std::vector<FittedParameter> parameters;
  /// All parameters of the vehicle, the free ones at their fitted values.
  std::vector<double> values;
  /// Nothing when it was not asked for, or could not be computed at the file's values.
  std::optional<Identifiability> before;
  /// Nothing when the fit ended before it could be computed.
  std::optional<Covariance> covariance;
  std::optional<Certainty> certainty;
  /// Combinations of parameters that data and priors do not determine, in words; if there is none, the one they
  /// determine least.
  std::vector<std::string> weakest;
  std::vector<Profile> profiles;
  EvaluationCounts evaluations;
  /// Of coarse residuals, see ResidualBlock::coarse; not among `evaluations`.
  std::int64_t coarse_evaluations = 0;
  /// For derivatives by parameters that are held, and with noise added to inputs; not among `evaluations`.
  std::int64_t evaluations_beside = 0;
  /// By how much FitVariables were moved from the optimum because recorded inputs have noise, see InputNoise; empty:
  /// not at all.
  Eigen::VectorXd moved_by_input_noise;
  /// What that noise adds to `data_squares`; 0 where none is known.
  double input_noise_squares = 0;
  /// What looks like noise of the inputs would move them further than noise can, so that nothing was moved.
  bool is_input_noise_implausible = false;
  /// Data could not be asked for the objective's calibrations; intervals take those as stated that can be evaluated.
  bool are_calibrations_unused = false;
  SearchResult search;
  /// Every setting of the search and its value, in the words of a study.
  std::vector<std::pair<std::string, std::string>> search_settings;
  /// Refinements that ended by themselves, and how many of them in the best optimum.
  int starts = 0;
  int agreeing = 0;
  /// Each that began, in the order of the starts: good points of the search, then the vehicle's own values.
  std::vector<RefinedStart> refined;

  /// Root mean square of the data's residuals over their degrees of freedom, whatever the loss: how many times what
  /// noise, that of recorded inputs as well, and the stated model error explain. NaN without a covariance.
  double Misfit() const;
  /// Nothing without a certainty.
  std::optional<ParameterSpread> Spread() const;

  /// Of the squares of the data's residuals, what noise of recorded inputs makes of them.
  double InputNoiseShare() const { return data_squares > 0 ? input_noise_squares / data_squares : 0; }
  bool IsMostlyInputNoise() const { return InputNoiseShare() > kMostlyInputNoise; }

  /// Of a cost that weighs by other than noise, which has none; see LoadedStudy::HasDeviations.
  void DropDeviations();
};

}  // namespace fourpost
