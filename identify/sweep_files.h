#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnostics.h"
#include "identify/sweep.h"

namespace fourpost {

/// Comma-separated text, one row per mode, channel and frequency: gain and phase relative to the reference post, mean
/// offset and amplitude of the second harmonic in the channel's unit, and the engine that answered. What has no answer
/// is blank.
std::string SweepCsv(const std::vector<SweptResponse>& responses);

/// By how much linear kinematics are off, or why that is not known; null where nobody asked.
nlohmann::ordered_json KinematicsJson(const std::optional<KinematicsError>& error, const std::string& not_estimated);

/// The same as JSON, in SI units, with the values of all parameters, the differences of engines, what has no answer and
/// why, `findings`, and versions.
std::string SweepJson(const Vehicle& vehicle, const SweepRequest& request, const std::vector<SweptResponse>& responses,
                      const Diagnostics& findings);

/// As an SVG picture: one row of panels for each channel, with gain and phase of each mode. Where the full geometry
/// answers, the linearised answer is drawn below it. Channels that are silent in a mode leave its panels empty.
std::string SweepSvg(const std::string& vehicle, const std::vector<SweptResponse>& responses);

}  // namespace fourpost
