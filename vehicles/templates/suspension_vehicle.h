#pragma once

#include <array>
#include <optional>
#include <string>

#include "analysis/text/diagnostics.h"
#include "vehicles/templates/axle_knowledge.h"
#include "vehicles/templates/axle_points.h"

namespace fourpost {

/// Mass on the tyres of the front and the rear axle [kg].
using AxleLoads = std::array<double, 2>;

/// A vehicle file of a car with these suspensions: body, links, joints, springs, dampers, stops, anti-roll bars, tyres
/// on posts, sensors, and parameters with bounds and the sources of their values. Rates of springs and dampers are
/// chosen for usual ride frequencies and damping at the motion ratios of these points. The file is at rest as drawn.
/// `source` says in the file where the points come from, findings name the points' `file`. Empty after an error.
/// Without loads the body is that of a passenger car.
std::string SuspensionVehicleText(const CarPoints& points, const std::optional<AxleLoads>& loads,
                                  const std::string& name, const std::string& source, const std::string& file,
                                  Diagnostics& diagnostics);

/// Whether springs carry what a model states, so that the file need not be at rest as drawn.
enum class StatedLoads { kLeftToEquilibrium, kAsStated };

/// The same of a model that knows masses, rates and laws; estimates stand for what it leaves out.
std::string KnownVehicleText(const CarPoints& points, const KnownCar& known, const std::string& name,
                             const std::string& file, StatedLoads loads, Diagnostics& diagnostics);

}  // namespace fourpost
