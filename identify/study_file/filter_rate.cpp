#include "identify/study_file/filter_rate.h"

#include <utility>

#include "analysis/text/short_number.h"
#include "identify/study_file/findings.h"

namespace fourpost {

bool CheckFilterRate(const std::string& recording, double rate_Hz, double cutoff_Hz, Place place,
                     Diagnostics& diagnostics) {
  constexpr double kSamplesPerPeriod = 4;
  // Of times that a file rounds.
  constexpr double kRounding = 1e-3;
  const double least_Hz = kSamplesPerPeriod * cutoff_Hz;
  if (rate_Hz >= (1 - kRounding) * least_Hz) return true;
  diagnostics.Report(kSampledTooSlowly, std::move(place),
                     {recording, ShortNumber(rate_Hz, 4), ShortNumber(cutoff_Hz, 4), ShortNumber(least_Hz, 4)});
  return false;
}

}  // namespace fourpost
