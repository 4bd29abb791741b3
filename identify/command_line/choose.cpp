#include <cstdio>
#include <string>
#include <vector>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "identify/choice/choice_answer.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/command_line/work_progress.h"
#include "identify/inspection/file_kind.h"
#include "identify/run/result_kind.h"

namespace fourpost {

int Run(const ChooseCommand& command) {
  std::error_code failure;
  if (std::filesystem::is_directory(command.run, failure)) RequireFitResult(command.run);
  else RequireVehicleFile(command.run);
  if (!command.output.empty()) {
    RequireInputsElsewhere({command.run / "vehicle.urdf", command.run, command.settings}, command.output);
    RequireNoOtherResult(command.output, ResultKind::kChoice);
    OutputFolder{command.output};
  }
  CatchInterrupts();
  WorkProgress progress;
  const ChoiceAnswer answer = ChooseForRun(command, progress.Hooks());
  if (answer.choice.is_interrupted) return kInterrupted;
  progress.Tell(answer.choice.findings);
  progress.End();
  const std::string json = JsonText(ChoiceJson(answer));
  if (!command.output.empty()) {
    OutputFolder output(command.output);
    for (auto& [name, text] : ChoiceFiles(answer)) output.Add(name, text);
    output.Add("result.json", json);
    output.Commit();
    std::fprintf(stderr, "results: %s; open %s\n", command.output.string().c_str(),
                 (command.output / "choose.html").string().c_str());
  }
  if (command.json) Print(json);
  else PrintText(ChoiceText(answer));
  return answer.choice.best ? kGood : kNotGood;
}

}  // namespace fourpost
