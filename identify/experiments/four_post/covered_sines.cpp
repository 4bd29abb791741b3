#include "identify/experiments/four_post/covered_sines.h"

#include <algorithm>
#include <cmath>

#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/probed_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {

CoveredRanges CoveredBySines(const Vehicle& vehicle, const std::vector<double>& values,
                             const std::vector<MeasuredRun>& runs) {
  const ProbedVehicle probed(vehicle);
  const CondensedModel model = CondensedVehicle(probed.vehicle()).At(values);
  const std::vector<FrequencyResponse> responses = ModelledResponses(model, probed.vehicle().sensors, runs);
  CoveredRanges ranges;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Excitation& excitation = runs[r].excitation;
    if (excitation.frequency_Hz.empty()) continue;
    const auto [slowest, fastest] = std::minmax_element(excitation.frequency_Hz.begin(), excitation.frequency_Hz.end());
    const auto [least, most] = std::minmax_element(excitation.amplitude_m.begin(), excitation.amplitude_m.end());
    ranges.Add(CoveredQuantity::kPostFrequency, "posts", *slowest, *fastest);
    ranges.Add(CoveredQuantity::kPostAmplitude, "posts", *least, *most);
    probed.AddSteady(responses[r], model, ranges);
  }
  return ranges;
}

}  // namespace fourpost
