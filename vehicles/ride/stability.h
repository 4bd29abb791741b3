#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A vehicle with an unstable design pose.
struct Growth {
  /// exp(rate t) [1/s].
  double rate_per_s = 0;
  /// "'rear wind-up' and 'roll'"; "a motion" if the growth belongs to a series spring.
  std::string modes;
  bool is_one = true;

  /// "'heave' grows by exp(4.91 t)".
  std::string Text() const;
};

/// `growth_rate`: largest real part of all poles; `modes` with their names. Empty for a stable vehicle.
std::optional<Growth> GrowthOf(const std::vector<Mode>& modes, double growth_rate);

/// Of the vehicle at its file's values, which `model` has.
std::optional<Growth> GrowthOf(const Vehicle& vehicle, const CondensedModel& model);

}  // namespace fourpost
