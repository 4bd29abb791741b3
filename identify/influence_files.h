#pragma once

#include <string>
#include <vector>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/ride/pole_path.h"

namespace fourpost {

/// Gain and phase of every sensor while all posts move alike, 0.5 to 30 Hz, dashpots at their mean rates, at five of
/// the values of one parameter at most, first and last among them: what the influence study of thesis section 4.2.2
/// draws, as an SVG document. Throws FaultyInput where the vehicle cannot be held at one of them.
std::string InfluenceSvg(const Vehicle& vehicle, const PolePaths& paths);

/// Readings of all sensors after an impulse of 1 mm s of all posts, as CSV and as an SVG document: names, units, then a
/// row per sample.
struct ImpulseFiles {
  std::string csv;
  std::string svg;
};

/// Until the slowest mode has settled, five seconds at most.
ImpulseFiles ImpulseOf(const Vehicle& vehicle, const CondensedModel& model);

}  // namespace fourpost
