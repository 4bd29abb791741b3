#pragma once

#include <nlohmann/json.hpp>

#include "analysis/signals/frequency_response.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Name, unit, gain, phase [deg], mean and second harmonic of a modelled channel; values that are not finite become
/// null.
nlohmann::ordered_json ChannelJson(const ChannelResponse& channel);

/// File, line, severity and text of each finding.
nlohmann::ordered_json FindingsJson(const Diagnostics& findings);

}  // namespace fourpost
