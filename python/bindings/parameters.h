#pragma once

#include <vector>

#include <fourpost/vehicle.h>

#include "python/bindings/bindings.h"

namespace fourpost::python {

/// Name, value, lower and upper bound, and unit, SI; a tuple each.
py::list ParametersOf(const std::vector<api::Parameter>& parameters);

}  // namespace fourpost::python
