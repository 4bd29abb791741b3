#include "identify/run/run_suggestions.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/output_folder.h"
#include "analysis/text/text_table.h"
#include "identify/run/findings.h"
#include "identify/run/study_fit.h"
#include "identify/study_file/result_reader.h"
#include "identify/suggest/applied_suggestion.h"
#include "identify/suggest/findings.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Throws FaultyInput.
LoadedStudy FittedStudy(const SuggestRequest& request) {
  Diagnostics diagnostics;
  std::optional<LoadedStudy> study = LoadStudy(request.study, diagnostics, request.set);
  if (!study || diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return *std::move(study);
}

/// Of the study's free parameters. Throws FaultyInput where the run fitted others.
Eigen::VectorXd FittedValues(const nlohmann::json& result, const LoadedStudy& study) {
  Eigen::VectorXd values(static_cast<Index>(study.free.size()));
  const nlohmann::json parameters = result.value("parameters", nlohmann::json::array());
  bool are_same = parameters.size() == study.free.size();
  for (std::size_t i = 0; are_same && i < study.free.size(); ++i) {
    are_same = parameters[i].value("name", "") == study.vehicle.parameters[study.free[i]].name &&
               parameters[i]["value"].is_number();
    if (are_same) values[static_cast<Index>(i)] = parameters[i]["value"];
  }
  if (!are_same) Refuse(kDrawsOtherParameters, {study.study.file.string()});
  return values;
}

void RequireCost(const nlohmann::json& result, double cost, const std::filesystem::path& study) {
  constexpr double kDifference = 0.01;
  const double fitted = result.value("cost", std::nan(""));
  if (!(std::abs(cost - fitted) <= kDifference * fitted + 1e-9))
    Refuse(kDrawsOtherCost, {study.string()}, {Rounded(cost, 6), Rounded(fitted, 6)});
}

}  // namespace

RunSuggestions SuggestForRun(const SuggestRequest& request, const WorkHooks& hooks) {
  const nlohmann::json result = ReadResultFile(request.run / "result.json");
  RunSuggestions run{.study = FittedStudy(request)};
  if (result.value("post_noise_share", 0.0) > kMostlyInputNoise) {
    Diagnostics noise;
    noise.Report(kSuggestPostNoise, {(request.run / "result.json").string()});
    hooks.Find(noise);
  }
  run.values = FittedValues(result, run.study);
  run.misfit = NumberAt(result, "misfit");
  run.study.Prepare(hooks);
  if (!run.study.CorrectAt(run.values, hooks)) {
    run.suggestions.is_interrupted = true;
    return run;
  }
  run.suggestions = SuggestFor(run.study, run.values, request.threads, hooks);
  RequireCost(result, run.suggestions.cost, request.study);
  return run;
}

void WriteApplied(const RunSuggestions& suggestions, std::size_t k, const std::filesystem::path& folder) {
  const std::vector<SuggestedAddition>& list = suggestions.suggestions.list;
  if (k < 1 || k > list.size())
    Refuse(kSuggestionUnknown, Place::Option("--apply"), {std::to_string(k), std::to_string(list.size())});
  RequireInputsElsewhere(suggestions.study.InputFiles(), folder);
  OutputFolder output(folder, "", "study.yaml");
  const AppliedSuggestion applied = Apply(suggestions.study, list[k - 1], folder);
  output.Add("vehicle.urdf", applied.vehicle);
  output.Add("study.yaml", applied.study);
  output.Commit();
}

}  // namespace fourpost
