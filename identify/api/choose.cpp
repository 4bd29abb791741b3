#include <fourpost/run.h>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/choice/run_choice.h"
#include "identify/run/result_kind.h"

namespace fourpost::api {

Choice Choose(const std::filesystem::path& run, const std::filesystem::path& settings, const ChooseOptions& options) {
  const bool is_written = !options.output.empty();
  return Guarded([&] {
    if (is_written) {
      RequireInputsElsewhere({run / "vehicle.urdf", run, settings}, options.output);
      RequireNoOtherResult(options.output, ResultKind::kChoice);
    }
    const ChoiceAnswer answer =
        ChooseForRun({.run = run, .settings = settings, .threads = options.threads}, {.stop = options.stop});
    if (answer.choice.is_interrupted) throw SimulationError(kCallStopped);
    Choice choice{.json = JsonText(ChoiceJson(answer)), .warnings = FindingsOf(answer.choice.findings)};
    if (is_written) {
      OutputFolder output(options.output);
      for (auto& [name, text] : ChoiceFiles(answer)) output.Add(name, text);
      output.Add("result.json", choice.json);
      output.Commit();
    }
    return choice;
  });
}

}  // namespace fourpost::api
