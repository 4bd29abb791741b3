#include <string>

#include "identify/command_line/commands.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/responses.h"
#include "identify/inspection/file_kind.h"

namespace fourpost {
namespace {

/// A study's recordings define what the posts did.
void RequireNoVehicleOptions(const ResponseCommand& command) {
  Diagnostics faults;
  for (const std::string& option : command.vehicle_options)
    faults.Report(kOptionOfVehicle, Place::Option(option), {command.input.filename().string()});
  if (faults.HasErrors()) throw FaultyInput(faults);
}

}  // namespace

int Run(const ResponseCommand& command) {
  if (!IsStudyNotVehicle(command.input)) return RespondOfVehicle(command);
  RequireNoVehicleOptions(command);
  return RespondToStudy(command);
}

}  // namespace fourpost
