#pragma once

#include <span>
#include <string>
#include <vector>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Sensitivity of a rig test to one parameter p, before any recording: how strongly the frequency responses H of the
/// sensors depend on it,
///   sensitivity = mean over the band of |p dH/dp| / sqrt(|H|^2 + (0.2 H_most)^2),
/// so that 1 % more of p changes H by `sensitivity` % on average, gain and phase together. p is replaced by half its
/// range where that is more, as for an offset about zero. H_most is the largest reading of a sensor of its kind at that
/// frequency in any test: a small reading is no advantage, because next to a node errors of neighbouring motions
/// dominate.
struct ParameterView {
  struct Channel {
    std::string sensor;
    /// Motion of the posts with the largest sensitivity, see PostPattern; or the name of a post that moves alone.
    std::string excitation;
    double sensitivity = 0;
  };
  std::string parameter;
  /// Whether it is in a law that the linear model replaces by a rate, such as a stop's gap or friction: then channels
  /// show only its effect about the design pose, which may be zero.
  bool in_curved_law = false;
  /// The sensitive sensors, best first: sensitivity kLeastSensitivity or more.
  std::vector<Channel> channels;
};

/// The response changes by 0.02 % per 1 %: half a range changes it by less than a rig's repeatability.
inline constexpr double kLeastSensitivity = 0.02;

/// One entry per free parameter, in file order. Small motion, dashpots at their mean rates, 0.5 to 30 Hz, central
/// differences. `condensed`: made from `vehicle`.
std::vector<ParameterView> ParameterViews(const Vehicle& vehicle, const CondensedVehicle& condensed,
                                          std::span<const double> parameters);

}  // namespace fourpost
