#include "identify/run/result_json.h"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/signals/median.h"
#include "identify/refine/method_settings.h"
#include "identify/run/parameter_limit.h"
#include "identify/study/fitted_files.h"
#include "identify/study_file/warnings_json.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

Json Evaluations(const FitResult& fit) {
  const EvaluationCounts& counts = fit.evaluations;
  Json causes = Json::object();
  for (const auto& [cause, tally] : counts.failures) causes[std::string(FailureName(cause))] = tally.count;
  return {{"paid", counts.paid},
          {"reused", counts.reused},
          {"failed", counts.failed()},
          {"failures", causes},
          {"coarse", fit.coarse_evaluations}};
}

Json Prior(const FittedParameter& parameter) {
  return {{"value", parameter.start}, {"sd", *parameter.prior_sd}, {"deviation_in_sd", parameter.FromPrior()}};
}

Json Parameters(const FitResult& fit) {
  Json list = Json::array();
  for (const FittedParameter& parameter : fit.parameters) {
    list.push_back({{"name", parameter.name},
                    {"start", parameter.start},
                    {"value", parameter.value},
                    {"unit", SiUnit(parameter.dimension)},
                    {"lower", parameter.lower},
                    {"upper", parameter.upper},
                    {"sd", NumberOrNull(parameter.sd)},
                    {"sd_parts",
                     {{"noise", NumberOrNull(parameter.noise_sd)},
                      {"held", NumberOrNull(parameter.held_sd)},
                      {"model", NumberOrNull(parameter.model_sd)}}},
                    {"limited_by", LimitOf(fit, parameter)},
                    {"interval_95", {NumberOrNull(parameter.lower_95), NumberOrNull(parameter.upper_95)}},
                    {"state", kParameterStateNames[static_cast<std::size_t>(parameter.state)]},
                    {"at_bound", parameter.at_bound}});
    if (parameter.prior_sd) list.back()["prior"] = Prior(parameter);
    if (parameter.like)
      list.back()["like"] = {{"parameter", parameter.like->parameter},
                             {"sd", parameter.like->sd},
                             {"deviation_in_sd", parameter.from_like}};
  }
  return list;
}

/// Row by row.
Json Matrix(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(NumberOrNull(matrix(i, j)));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json Before(const FitResult& fit) {
  if (!fit.before) return nullptr;
  const Covariance& covariance = fit.before->covariance;
  return {{"rank", covariance.rank},
          {"parameters", covariance.directions.cols()},
          {"condition", NumberOrNull(covariance.condition)},
          {"noise", fit.before->noisy},
          {"weakest", fit.before->weakest}};
}

Json After(const std::optional<Covariance>& covariance, const std::vector<std::string>& weakest) {
  if (!covariance) return nullptr;
  return {{"rank", covariance->rank},
          {"parameters", covariance->directions.cols()},
          {"condition", NumberOrNull(covariance->condition)},
          {"weakest", weakest},
          {"sd_inflation", covariance->inflation},
          {"correlation", Matrix(Correlations(*covariance))}};
}

/// Parameters that one part of the data alone determines, and which.
Json RestsOn(const FitResult& fit, const PartedData& way) {
  Json parts = Json::object();
  for (std::size_t i = 0; i < way.rests_on.size(); ++i)
    if (const int part = way.rests_on[i]; part >= 0)
      parts[fit.parameters[static_cast<std::size_t>(fit.certainty->judged[i])].name] =
          way.clusters[static_cast<std::size_t>(part)];
  return parts;
}

/// By which data the parameters move, as shares of their values, or of their ranges.
Json Ways(const FitResult& fit) {
  Json ways = Json::array();
  const Certainty& certainty = *fit.certainty;
  for (const PartedData& way : certainty.model_error.ways) {
    Json shifts = Json::object();
    for (std::size_t i = 0; i < certainty.judged.size() && way.shifts.size() > 0; ++i) {
      Json& row = shifts[fit.parameters[static_cast<std::size_t>(certainty.judged[i])].name] = Json::array();
      for (Eigen::Index g = 0; g < way.shifts.cols(); ++g)
        row.push_back(NumberOrNull(way.shifts(static_cast<Eigen::Index>(i), g)));
    }
    ways.push_back({{"by", way.name},
                    {"parts", way.clusters},
                    {"is_beyond_noise", way.IsSignificant()},
                    {"disagreement", way.degrees > 0 ? NumberOrNull(way.disagreement / way.degrees) : Json(nullptr)},
                    {"shifts_without", shifts},
                    {"rests_on", RestsOn(fit, way)}});
  }
  return ways;
}

/// By recordings, the worst first.
Json Contradictions(const FitResult& fit) {
  Json list = Json::array();
  const std::vector<std::string>& recordings = fit.certainty->model_error.by_recording.clusters;
  for (const Contradiction& one : fit.certainty->Contradictions())
    list.push_back({{"parameter", fit.parameters[static_cast<std::size_t>(one.parameter)].name},
                    {"without", recordings[static_cast<std::size_t>(one.cluster)]},
                    {"shift", one.shift},
                    {"in_sd_of_noise", one.deviations}});
  return list;
}

/// Of a symmetric matrix, row by row.
Json LowerTriangle(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j <= i; ++j) row.push_back(NumberOrNull(matrix(i, j)));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Changes of logarithms of parameters, or shares of their ranges.
Json Covariances(const FitResult& fit) {
  Json names = Json::array();
  for (const Eigen::Index j : fit.certainty->judged) names.push_back(fit.parameters[static_cast<std::size_t>(j)].name);
  Json covariances = {{"parameters", names},
                      {"noise", LowerTriangle(fit.certainty->noise_covariance)},
                      {"total", LowerTriangle(fit.certainty->total_covariance)}};
  if (fit.certainty->missing.empty()) return covariances;
  const Eigen::VectorXd moved = fit.certainty->MovedByMissing()(fit.certainty->judged);
  covariances["moved_by_missing"] = std::vector<double>(moved.begin(), moved.end());
  return covariances;
}

/// What the intervals rest on.
Json Calibrations(const std::vector<CalibrationEstimate>& estimates) {
  Json list = Json::array();
  for (const CalibrationEstimate& one : estimates)
    list.push_back({{"name", one.name},
                    {"unit", one.unit},
                    {"sd", one.sd},
                    {"estimate", one.estimate},
                    {"estimate_sd", one.estimate_sd},
                    {"surprise", one.surprise}});
  return list;
}

/// Median over the judged parameters; NaN without any.
double WiderThanByNoise(const Certainty& certainty) {
  std::vector<double> shares;
  for (const Eigen::Index j : certainty.judged)
    shares.push_back(certainty.HalfWidth(j) / (certainty.covariance.reach_95 * certainty.noise_sd[j]));
  return shares.empty() ? std::numeric_limits<double>::quiet_NaN() : Median(shares);
}

Json Intervals(const FitResult& fit) {
  if (!fit.certainty) return nullptr;
  const Certainty& certainty = *fit.certainty;
  Json held = Json::object();
  for (std::size_t i = 0; i < certainty.held.size(); ++i) {
    Json& by = held[certainty.held[i]] = Json::object();
    for (const Eigen::Index j : certainty.judged)
      by[fit.parameters[static_cast<std::size_t>(j)].name] =
          NumberOrNull(certainty.by_held(static_cast<Eigen::Index>(i), j));
  }
  Json noise_moved = Json::object();
  for (Eigen::Index j = 0; j < fit.moved_by_input_noise.size(); ++j)
    noise_moved[fit.parameters[static_cast<std::size_t>(j)].name] = fit.moved_by_input_noise[j];
  return {{"confidence", certainty.Confidence()},
          {"model_error", certainty.model_error.is_significant},
          {"wider_than_by_noise", NumberOrNull(WiderThanByNoise(certainty))},
          {"ways", Ways(fit)},
          {"contradictions", Contradictions(fit)},
          {"held", held},
          {"calibrations", Calibrations(certainty.calibrations)},
          {"covariance", Covariances(fit)},
          {"moved_by_post_noise", noise_moved}};
}

/// null of a fit that was interrupted.
Json Verdict(const FitResult& fit, const FitVerdict& verdict) {
  if (fit.end == FitEnd::kInterrupted) return nullptr;
  return {{"explains_data", verdict.explains()},
          {"reasons", WarningsJson(verdict.reasons)},
          {"accepted", WarningsJson(verdict.accepted)}};
}

/// Infinite ends: null.
Json Profiles(const std::vector<Profile>& profiles) {
  Json list = Json::array();
  for (const Profile& profile : profiles) {
    Json points = Json::array();
    for (const ProfilePoint& point : profile.points) points.push_back({point.value, NumberOrNull(point.rise)});
    list.push_back({{"name", profile.name},
                    {"interval_95", {NumberOrNull(profile.lower_95), NumberOrNull(profile.upper_95)}},
                    {"threshold", profile.threshold},
                    {"found_better", profile.found_better},
                    {"interrupted", profile.interrupted},
                    {"points", points}});
  }
  return list;
}

/// Infinite and none: null.
Json Stop(const StopRules& rules) {
  return {{"target_cost", rules.target_cost ? Json(*rules.target_cost) : Json(nullptr)},
          {"evaluations", rules.max_evaluations},
          {"generations", rules.max_generations},
          {"seconds", NumberOrNull(rules.max_seconds)},
          {"stagnant_generations", rules.max_stagnant_generations},
          {"free_generations", rules.max_free_generations},
          {"on_collapse", rules.on_collapse}};
}

/// One entry per generation.
Json Log(const SearchResult& search) {
  Json log = Json::array();
  for (const SearchGeneration& generation : search.log)
    log.push_back({{"evaluations", generation.paid},
                   {"best_cost", NumberOrNull(generation.best_cost)},
                   {"diversity", NumberOrNull(generation.diversity)}});
  return log;
}

Json Starts(const FitResult& fit) {
  Json runs = Json::array();
  for (const RefinedStart& run : fit.refined)
    runs.push_back({{"from", run.from},
                    {"end", RefineEndName(run.end)},
                    {"start_cost", NumberOrNull(run.start_cost)},
                    {"cost", NumberOrNull(run.cost)},
                    {"iterations", run.iterations},
                    {"evaluations", run.evaluations},
                    {"coarse_evaluations", run.coarse_evaluations},
                    {"agrees", run.agrees},
                    {"values", run.values}});
  return {{"asked", fit.options.starts}, {"refined", fit.starts}, {"agreeing", fit.agreeing}, {"runs", runs}};
}

Json Files(const std::vector<FileDigest>& files) {
  Json list = Json::array();
  for (const FileDigest& file : files) list.push_back({{"name", file.name}, {"sha256", file.sha256}});
  return list;
}

Json GainJson(const SearchGain& gain) {
  return {{"count", gain.count},
          {"evaluations", gain.evaluations},
          {"successes", gain.successes},
          {"cost_ratio", NumberOrNull(gain.cost_ratio)}};
}

Json Search(const FitResult& fit) {
  Json settings = Json::object();
  for (const auto& [key, value] : fit.search_settings) settings[key] = value;
  const CandidateRules& candidates = fit.options.candidates;
  return {{"algorithm", AlgorithmName(fit.options.search)},
          {"end", fit.search.reason},
          {"accelerations", GainJson(fit.search.accelerations)},
          {"migrations", GainJson(fit.search.migrations)},
          {"log", Log(fit.search)},
          {"settings", settings},
          {"stop", Stop(fit.options.stop)},
          {"candidates", {{"count", candidates.count}, {"separation", candidates.separation}}}};
}

/// Only a loss has a scale.
Json Refinement(const RefineOptions& options) {
  Json refinement = {{"loss", options.loss.name()}};
  if (options.loss.kind() != LossKind::kNone) refinement["scale"] = options.loss.scale();
  refinement["differences"] = kDifferencesWords[static_cast<std::size_t>(options.differences)];
  refinement["step"] = options.step;
  refinement["iterations"] = options.max_iterations;
  refinement["cost_tolerance"] = options.cost_tolerance;
  refinement["step_tolerance"] = options.step_tolerance;
  refinement["nearness"] = options.nearness;
  refinement["agreement"] = options.agreement;
  return refinement;
}

/// What the misfit is relative to.
double ExpectedSquares(const FitResult& fit) { return fit.data_squares / (fit.Misfit() * fit.Misfit()); }

}  // namespace

std::string ResultJson(const LoadedStudy& study, std::uint64_t seed, const FitResult& fit, const Json& of_experiments,
                       const FitFindings& found) {
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  Json json = {{"termination", FitEndName(fit.end)},
               {"message", fit.message},
               {"verdict", Verdict(fit, found.verdict)},
               {"study", study.study.file.filename().string()},
               {"vehicle", study.vehicle.name},
               {"fitted_files", Files(study.fitted_files)},
               {"validation_files", Files(study.validation_files)},
               {"cost", NumberOrNull(fit.cost)},
               {"residuals", fit.residual_count},
               {"misfit", NumberOrNull(fit.Misfit())},
               {"expected_squares", NumberOrNull(ExpectedSquares(fit))},
               {"post_noise_share", fit.InputNoiseShare()},
               {"seed", seed},
               {"evaluations", Evaluations(fit)},
               {"search", Search(fit)},
               {"refine", Refinement(fit.options.refine)},
               {"starts", Starts(fit)},
               {"deadline_s", NumberOrNull(fit.options.deadline_s)},
               {"identifiability_before", Before(fit)},
               {"identifiability", After(fit.covariance, fit.weakest)},
               {"intervals", Intervals(fit)},
               {"parameters", Parameters(fit)},
               {"warnings", WarningsJson(found.warnings)},
               {"conclusions", WarningsJson(found.conclusions)},
               {"versions", versions}};
  if (!fit.profiles.empty()) json["profiles"] = Profiles(fit.profiles);
  // These are there whatever was measured.
  for (const char* list : {"recordings", "channels", "static_loads"}) json[list] = Json::array();
  AddKeys(of_experiments, json);
  return JsonText(json);
}

}  // namespace fourpost
