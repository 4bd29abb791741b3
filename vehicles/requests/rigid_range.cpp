#include "vehicles/requests/rigid_range.h"

#include "analysis/text/number.h"
#include "vehicles/requests/findings.h"

namespace fourpost {

void WarnAboveRigid(double highest_Hz, const std::string& option, Diagnostics& diagnostics) {
  // The last of a range is computed.
  constexpr double kSlack = 1e-9;
  if (highest_Hz <= kHighestRigid_Hz * (1 + kSlack)) return;
  diagnostics.Report(kBodiesBend, Place::Option(option), {FormatNumber(kHighestRigid_Hz) + " Hz"});
}

}  // namespace fourpost
