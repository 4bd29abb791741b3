#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnostics.h"
#include "identify/amplitude_limits.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/engine/steady_response.h"
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
  /// Sensors to tell of; empty: all.
  std::vector<std::string> channels;
  bool falling = false;
  /// Of posts whose stroke the vehicle file does not tell, from end to end.
  std::string stroke;
};

/// One stepped sine of the posts.
struct Sweep {
  std::string mode;
  /// Frequencies in the order in which they are taken.
  Excitation excitation;
};

/// The same, ready to be answered.
struct SweepRequest {
  std::vector<Sweep> sweeps;
  AmplitudeLaw amplitude;
  bool falling = false;
  /// Indices in Vehicle::sensors.
  std::vector<std::size_t> channels;
};

/// Reads and checks all at once. Adds an error for each text that cannot be read, a pattern that the posts cannot make,
/// a post or a channel that the vehicle has not, and a post that would leave its stroke; a warning for frequencies
/// above kHighestRigid_Hz, and of WarnBeyondUsual. Nothing after an error. Findings are about the option: "--mode".
std::optional<SweepRequest> ReadSweep(const SweepText& text, const Vehicle& vehicle, Diagnostics& diagnostics);

/// What a vehicle answered to a sweep, frequencies rising.
struct SweptResponse {
  std::string mode;
  Excitation excitation;
  SteadyResponse answer;
};

/// Brings a falling sweep's frequencies into rising order and leaves out all channels but these.
SweptResponse Sorted(const Sweep& sweep, SteadyResponse answer, const std::vector<std::size_t>& channels);

}  // namespace fourpost
