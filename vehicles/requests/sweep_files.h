#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/text/diagnostics.h"
#include "vehicles/requests/sweep.h"

namespace fourpost {

/// Comma-separated text, one row per mode, channel and frequency: gain and phase relative to the reference post, mean
/// offset and amplitude of the second harmonic in the channel's unit, and the engine. Missing results are blank.
std::string SweepCsv(const std::vector<SweptResponse>& responses);

/// Error of linear kinematics, or why it is not known; null if not requested.
nlohmann::ordered_json KinematicsJson(const std::optional<KinematicsError>& error, const std::string& not_estimated);

/// The same as JSON, in SI units, with the values of all parameters, the differences of engines, missing results and
/// their reasons, `findings`, and versions.
std::string SweepJson(const Vehicle& vehicle, const SweepRequest& request, const std::vector<SweptResponse>& responses,
                      const Diagnostics& findings);

/// As an SVG picture: one row of panels for each channel, with gain and phase of each mode. If the full geometry was
/// used, the linearised result is drawn below it. Channels that are silent in a mode leave its panels empty.
std::string SweepSvg(const std::string& vehicle, const std::vector<SweptResponse>& responses);

}  // namespace fourpost
