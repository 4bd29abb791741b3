#include <string>

#include "identify/command_line/commands.h"
#include "identify/command_line/file_kind.h"
#include "identify/command_line/responses.h"

namespace fourpost {
namespace {

/// A study's recordings tell what the posts did.
void RequireNoVehicleOptions(const ResponseCommand& command) {
  Diagnostics faults;
  for (const std::string& option : command.vehicle_options)
    faults.Error(option, 0,
                 "is for a vehicle file; " + command.input.filename().string() +
                     " is a study, whose recordings and vehicle tell this");
  if (faults.HasErrors()) throw FaultyInput(faults);
}

}  // namespace

int Run(const ResponseCommand& command) {
  if (!IsStudyNotVehicle(command.input)) return RespondOfVehicle(command);
  RequireNoVehicleOptions(command);
  return RespondToStudy(command);
}

}  // namespace fourpost
