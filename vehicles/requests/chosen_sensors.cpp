#include "vehicles/requests/chosen_sensors.h"

#include <algorithm>

#include "analysis/text/known_names.h"
#include "vehicles/requests/findings.h"

namespace fourpost {

std::vector<std::size_t> ChosenSensors(const std::vector<std::string>& names, const Vehicle& vehicle,
                                       Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const Sensor& sensor : vehicle.sensors) known.push_back(sensor.name);
  std::vector<std::size_t> chosen;
  for (const std::string& name : names.empty() ? known : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    const auto index = static_cast<std::size_t>(found - known.begin());
    if (found == known.end())
      diagnostics.Report(kOptionSensor, Place::Option("--channels"), {name, KnownNames(name, known)});
    else if (std::find(chosen.begin(), chosen.end(), index) == chosen.end()) chosen.push_back(index);
  }
  return chosen;
}

}  // namespace fourpost
