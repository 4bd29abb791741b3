#include "vehicles/requests/travel_range.h"

#include <optional>

#include "vehicles/requests/findings.h"
#include "vehicles/requests/option_quantity.h"

namespace fourpost {

TravelRange ReadTravelRange(const std::string& travel, const std::string& step, Diagnostics& findings) {
  constexpr const char* kTravel = "--travel";
  constexpr int kMostSteps = 1000;
  TravelRange range;
  if (const std::optional<double> length = ReadQuantity(step, kLength, "--step", findings)) range.step = *length;
  if (travel.empty()) return range;
  if (const std::size_t colon = travel.find(':'); colon == std::string::npos) {
    range.upper = ReadQuantity(travel, kLength, kTravel, findings);
    if (range.upper) range.lower = -*range.upper;
  } else {
    range.lower = ReadQuantity(travel.substr(0, colon), kLength, kTravel, findings, OptionSign::kAny);
    range.upper = ReadQuantity(travel.substr(colon + 1), kLength, kTravel, findings, OptionSign::kAny);
  }
  if (!range.lower || !range.upper) return range;
  if (!(*range.lower <= 0 && *range.upper >= 0 && *range.lower < *range.upper))
    findings.Report(kOptionTravel, Place::Option(kTravel), {travel});
  else if ((*range.upper - *range.lower) / range.step > kMostSteps)
    findings.Report(kOptionTravelSteps, Place::Option("--step"), {step, std::to_string(kMostSteps)});
  return range;
}

}  // namespace fourpost
