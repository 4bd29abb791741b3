#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/run_contents.h"
#include "identify/report/run_result.h"
#include "vehicles/ride_metrics/ride_instruments.h"

namespace fourpost {

/// The ride that a page begins with.
struct ShownRide {
  RideInstruments instruments;
  std::string road_class = "C";
  double speed = 60 / 3.6;
  double lower_Hz = 0.5;
  double upper_Hz = 30;
};

/// What a page needs to follow other values of the parameters: the reduced vehicle, base 64 of BytesOf(), and its
/// parameters, those that were fitted first; `ride`: without it that of InstrumentRide(). analysis/report/README.md
/// describes the shape. Null where the folder has no vehicle, or one that cannot be condensed.
nlohmann::ordered_json LiveJson(const RunContents& run, const std::vector<ReportedParameter>& fitted,
                                const std::optional<ShownRide>& ride = {});

}  // namespace fourpost
