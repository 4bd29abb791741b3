#include <cstdio>

#include "analysis/measured_response/measured_response_files.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/print.h"
#include "identify/inspection/measured_files.h"

namespace fourpost {

int Run(const FrfCommand& command) {
  Diagnostics findings = command.faults;
  RequireRecordings(command.request, findings);
  const bool is_written = !command.output.empty();
  if (is_written) RequireMeasuredFolder(command.request, command.output);
  const MeasuredResponses measured = MeasureFiles(command.request, findings);
  Tell(findings);
  const std::string text = MeasuredFilesJson(measured, findings);
  if (is_written) {
    WriteMeasured(command.output, text, measured);
    std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
  }
  if (command.json) Print(text);
  else PrintText(MeasuredText(measured) + (is_written ? "" : "\n" + StudySection(measured)));
  return kGood;
}

}  // namespace fourpost
