#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/requests/influence_files.h"
#include "vehicles/ride/pole_path.h"

namespace fourpost {

/// What `fourpost modes` found, to be shown.
struct ModesAnswer {
  /// Text of the vehicle's file, at whose values sliders begin.
  std::string file;
  /// Without channels: the vehicle has no sensors or no posts.
  ImpulseFiles impulse;
  /// By parameter: its name, pictures of its poles, and of its responses where the vehicle has sensors.
  struct Influence {
    std::string parameter;
    std::string poles_svg;
    std::string responses_svg;
  };
  std::vector<Influence> influences;
  Diagnostics findings;
};

/// A page of a vehicle's modes: their table and map, the vehicle moving in each with a slider for every parameter, the
/// ways of the poles, and the readings after an impulse of the posts.
std::string ModesPage(const Vehicle& vehicle, const ModesAnswer& answer);

}  // namespace fourpost
