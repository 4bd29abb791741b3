#include "vehicles/requests/rigid_range.h"

#include "analysis/text/number.h"

namespace fourpost {

void WarnAboveRigid(double highest_Hz, const std::string& option, Diagnostics& diagnostics) {
  // The last of a range is computed.
  constexpr double kSlack = 1e-9;
  if (highest_Hz <= kHighestRigid_Hz * (1 + kSlack)) return;
  diagnostics.Warning(option, 0,
                      "above " + FormatNumber(kHighestRigid_Hz) +
                          " Hz the bodies of a road vehicle bend, and rigid bodies do not: take the answers up there "
                          "for those of the model, not of a car");
}

}  // namespace fourpost
