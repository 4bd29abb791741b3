#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/engine/steady_response.h"
#include "vehicles/requests/amplitude_limits.h"
#include "vehicles/response/amplitude_law.h"
#include "vehicles/response/excitation.h"

namespace fourpost {

/// Stepped sines of a vehicle as a user writes them.
struct SweepText {
  /// See ReadPostShape.
  std::vector<std::string> modes = {"heave"};
  /// See ParseFrequencies.
  std::string frequencies = "0.5Hz:30Hz:40";
  LimitText limits;
  /// Sensors to report; empty: all.
  std::vector<std::string> channels;
  bool falling = false;
  /// Stroke of posts without one in the vehicle file, from end to end.
  std::string stroke;
};

/// One stepped sine of the posts.
struct Sweep {
  std::string mode;
  /// Frequencies in the order of the sweep.
  Excitation excitation;
};

/// The same, ready to be solved.
struct SweepRequest {
  std::vector<Sweep> sweeps;
  AmplitudeLaw amplitude;
  bool falling = false;
  /// Indices in Vehicle::sensors.
  std::vector<std::size_t> channels;
};

/// Reads and checks all at once. Adds an error for each invalid text, a pattern that the posts cannot make, an unknown
/// post or channel, and a post that would leave its stroke; a warning for frequencies above kHighestRigid_Hz, and those
/// of WarnBeyondUsual. Empty after an error. Findings name the option: "--mode".
std::optional<SweepRequest> ReadSweep(const SweepText& text, const Vehicle& vehicle, Diagnostics& diagnostics);

/// Response of a vehicle to a sweep, frequencies rising.
struct SweptResponse {
  std::string mode;
  Excitation excitation;
  SteadyResponse answer;
};

/// Sorts a falling sweep's frequencies upwards and drops all channels but these.
SweptResponse Sorted(const Sweep& sweep, SteadyResponse answer, const std::vector<std::size_t>& channels);

}  // namespace fourpost
