#pragma once

#include <string>
#include <vector>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/requests/history_channel.h"
#include "vehicles/ride/pole_path.h"

namespace fourpost {

/// Parameter sensitivity study of thesis section 4.2.2 as an SVG document: gain and phase of every sensor while all
/// posts move alike, 0.5 to 30 Hz, dashpots at their mean rates, at up to five values of one parameter, including first
/// and last. Throws FaultyInput if the vehicle cannot be held at one of them.
std::string InfluenceSvg(const Vehicle& vehicle, const PolePaths& paths);

/// Readings of all sensors after an impulse of 1 mm s of all posts, as CSV and as an SVG document: names, units, then a
/// row per sample.
struct ImpulseFiles {
  std::string csv;
  std::string svg;
  /// What they show, from the impulse on.
  double rate_Hz = 0;
  std::vector<HistoryChannel> channels;
};

/// Until the slowest mode has settled, at most five seconds.
ImpulseFiles ImpulseOf(const Vehicle& vehicle, const CondensedModel& model);

}  // namespace fourpost
