#include "identify/command_line/condensed_at_values.h"

#include <stdexcept>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/command_line/findings.h"

namespace fourpost {

CondensedModel CondensedAtValues(const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  try {
    for (const Damper& damper : vehicle.dampers)
      if (damper.hydraulic) damper.HydraulicAt(values).Validate();
    return CondensedVehicle(vehicle).At(values);
  } catch (const std::invalid_argument& fault) {
    Refuse(kValuesInconsistent, Place::Option("--set"), {fault.what()});
  }
}

}  // namespace fourpost
