#include "vehicles/vehicle.h"

namespace fourpost {

std::vector<double> Vehicle::ParameterValues() const {
  std::vector<double> values;
  values.reserve(parameters.size());
  for (const Parameter& parameter : parameters) values.push_back(parameter.value);
  return values;
}

}  // namespace fourpost
