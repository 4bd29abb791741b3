#include "identify/command_line/condensed_at_values.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"

namespace fourpost {

CondensedModel CondensedAtValues(const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  try {
    for (const Damper& damper : vehicle.dampers)
      if (damper.hydraulic) damper.HydraulicAt(values).Validate();
    return CondensedVehicle(vehicle).At(values);
  } catch (const std::invalid_argument& fault) {
    Diagnostics faults;
    faults.Error("--set", 0, std::string("these values do not go together: ") + fault.what());
    throw FaultyInput(faults);
  }
}

}  // namespace fourpost
