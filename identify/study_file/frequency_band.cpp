#include "identify/study_file/frequency_band.h"

#include "identify/study_file/findings.h"

namespace fourpost {

std::optional<FrequencyBand> ReadFrequencyBand(const StrictMap& map) {
  constexpr double kHighest_Hz = 200;
  const YAML::Node node = map.Get("band");
  if (!node.IsSequence() || node.size() != 2) {
    map.FaultOf("band", kBandOutOfRange);
    return std::nullopt;
  }
  const auto end = [&](std::size_t i, const char* what) {
    return ReadQuantity(node[i], kFrequency, what, map.file(), map.diagnostics());
  };
  const std::optional<double> lower = end(0, "the lower end of 'band'");
  const std::optional<double> upper = end(1, "the upper end of 'band'");
  if (!lower || !upper) return std::nullopt;
  if (*lower > 0 && *lower < *upper && *upper <= kHighest_Hz) return FrequencyBand{*lower, *upper};
  map.FaultOf("band", kBandOutOfRange);
  return std::nullopt;
}

}  // namespace fourpost
