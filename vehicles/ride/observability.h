#pragma once

#include <span>
#include <string>
#include <vector>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// What a rig test can tell about one parameter p, before any recording: how strongly the frequency responses H of the
/// sensors depend on it,
///   sensitivity = mean over the band of |p dH/dp| / sqrt(|H|^2 + (0.2 H_most)^2),
/// so that 1 % more of p changes H by `sensitivity` % on average, gain and phase together. In place of p stands half
/// its range where that is more, as for an offset about zero. H_most is the most that a sensor of its kind reads at
/// that frequency in any test: no channel gains by reading little, for at its nodes it errs by what moves its
/// neighbours.
struct ParameterView {
  struct Channel {
    std::string sensor;
    /// Motion of the posts that shows it best, see PostPattern; or the name of a post that moves alone.
    std::string excitation;
    double sensitivity = 0;
  };
  std::string parameter;
  /// Whether it is in a law that the linear model replaces by a rate, such as a stop's gap or friction: then channels
  /// tell what the model sees of it about the design pose, which may be nothing.
  bool in_curved_law = false;
  /// The sensors that see it, best first: sensitivity kLeastSensitivity or more.
  std::vector<Channel> channels;
};

/// The response follows by 0.02 % per 1 %: half a range moves it by less than a rig repeats itself.
inline constexpr double kLeastSensitivity = 0.02;

/// One entry per free parameter, in file order. Small motion, dashpots at their mean rates, 0.5 to 30 Hz, central
/// differences. `vehicle` is what `condensed` was made from.
std::vector<ParameterView> ParameterViews(const Vehicle& vehicle, const CondensedVehicle& condensed,
                                          std::span<const double> parameters);

}  // namespace fourpost
