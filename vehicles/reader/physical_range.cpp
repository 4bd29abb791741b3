#include "vehicles/reader/physical_range.h"

#include <algorithm>

#include "vehicles/reader/parameter_uses.h"

namespace fourpost {

std::vector<PhysicalRange> PhysicalRanges(const Vehicle& vehicle) {
  std::vector<PhysicalRange> ranges(vehicle.parameters.size());
  for (const ParameterUse& use : FindParameterUses(vehicle.text)) {
    const auto found = std::find_if(vehicle.parameters.begin(), vehicle.parameters.end(),
                                    [&](const Parameter& parameter) { return parameter.name == use.parameter; });
    if (found == vehicle.parameters.end() || use.sign == Sign::kAny) continue;
    PhysicalRange& range = ranges[static_cast<std::size_t>(found - vehicle.parameters.begin())];
    if (use.factor > 0) range.least = 0;
    if (use.factor < 0) range.greatest = 0;
  }
  return ranges;
}

}  // namespace fourpost
