#include "identify/study_file/filter_rate.h"

#include "analysis/text/short_number.h"

namespace fourpost {

std::optional<std::string> RateFault(double rate_Hz, double cutoff_Hz) {
  constexpr double kSamplesPerPeriod = 4;
  // Of times that a file rounds.
  constexpr double kRounding = 1e-3;
  const double least_Hz = kSamplesPerPeriod * cutoff_Hz;
  if (rate_Hz >= (1 - kRounding) * least_Hz) return std::nullopt;
  return "is sampled at " + ShortNumber(rate_Hz, 4) + " Hz, too slowly for the band up to its filter's cut-off at " +
         ShortNumber(cutoff_Hz, 4) + " Hz: record faster, at " + ShortNumber(least_Hz, 4) + " Hz or more";
}

}  // namespace fourpost
