#include "identify/experiments/four_post/tyre_pull_lint.h"

#include "identify/experiments/four_post/modelled_response.h"
#include "vehicles/response/tyre_pull.h"

namespace fourpost {

void LintTyrePulls(const Vehicle& vehicle, std::span<const double> values, const std::vector<MeasuredRun>& runs,
                   Diagnostics& diagnostics) {
  for (const MeasuredRun& run : runs)
    WarnOfPulls(vehicle, FindTyrePulls(vehicle, values, run.excitation, kFitBalance), "frequencies",
                "'" + run.name + "'", diagnostics);
}

}  // namespace fourpost
