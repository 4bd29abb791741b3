#include <optional>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/responses.h"
#include "identify/command_line/results_line.h"
#include "identify/command_line/work_progress.h"
#include "identify/report/report_page.h"
#include "identify/run/result_kind.h"
#include "identify/study/experiment_kinds.h"
#include "identify/study/loaded_study.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

/// Those of all experiments that come before an interruption; nothing where none does.
std::optional<ExperimentResults> Answers(const LoadedStudy& loaded, const ResponseCommand& command,
                                         WorkProgress& progress) {
  const Subject subject = loaded.MakeSubject();
  CatchInterrupts();
  const WorkHooks hooks = progress.Hooks();
  std::optional<ExperimentResults> all;
  std::size_t answered = 0;
  for (const Experiment& experiment : loaded.study.experiments) {
    std::optional<ExperimentResults> one = experiment.Respond(subject, command.engine, hooks);
    if (!one) break;
    if (!all) all.emplace();
    AddResults(*std::move(one), *all);
    ++answered;
    if (!all->is_whole) break;
  }
  const auto count =
      static_cast<std::size_t>(std::distance(loaded.study.experiments.begin(), loaded.study.experiments.end()));
  if (answered < count) {
    hooks.Note("interrupted: " + std::to_string(answered) + " of " + std::to_string(count) +
               " experiments are answered");
    if (all) all->is_whole = false;
  }
  return all;
}

void Write(const std::filesystem::path& folder, const std::string& json, const LoadedStudy& loaded,
           const ExperimentResults& answers) {
  OutputFolder output(folder);
  RunContents shown{.files = {{"result.json", json}}, .vehicle = loaded.vehicle, .vehicle_fault = ""};
  for (const auto& [name, content] : answers.files) {
    output.Add(name, content);
    shown.files.emplace(name, content);
  }
  shown.files.emplace("study.yaml", loaded.study.text);
  shown.files.emplace("vehicle.urdf", VehicleTextWithValues(loaded.vehicle, loaded.vehicle.ParameterValues(),
                                                            std::filesystem::absolute(folder)));
  output.Add(kPageName, StudyResponsePage(shown, AllExperimentReports()));
  output.Add("result.json", json);
  output.Commit();
  PrintResultsLine(folder);
}

}  // namespace

int RespondToStudy(const ResponseCommand& command) {
  Diagnostics diagnostics;
  const std::optional<LoadedStudy> loaded = LoadStudy(command.input, diagnostics);
  if (!loaded) throw FaultyInput(diagnostics);
  CheckRecordings(*loaded, Severity::kWarning, diagnostics);
  Tell(diagnostics);
  if (!command.output.empty()) {
    RequireInputsElsewhere(loaded->InputFiles(), command.output);
    RequireNoOtherResult(command.output, ResultKind::kResponse);
    OutputFolder{command.output};
  }
  WorkProgress progress;
  const std::optional<ExperimentResults> answers = Answers(*loaded, command, progress);
  if (!answers) return kInterrupted;
  progress.Tell(answers->findings);
  progress.End();
  nlohmann::ordered_json json = {{"recordings", nlohmann::ordered_json::array()},
                                 {"channels", nlohmann::ordered_json::array()}};
  AddKeys(answers->json, json);
  if (!answers->is_whole) json["interrupted"] = true;
  const std::string text = JsonText(json);
  if (!command.output.empty()) Write(command.output, text, *loaded, *answers);
  if (command.json) Print(text);
  else PrintText(answers->text);
  return answers->is_whole ? kGood : kInterrupted;
}

}  // namespace fourpost
