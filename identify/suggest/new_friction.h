#pragma once

#include <string>

#include "identify/suggest/addition.h"
#include "identify/suggest/addition_source.h"
#include "identify/suggest/vehicle_edit.h"

namespace fourpost {

/// Dry friction F tanh(v / v0) of an addition. Both are parameters: a speed v0 taken as exact where it is a guess moves
/// the rates of dampers and the force by many standard deviations.
class NewFriction {
 public:
  /// A usual speed, and the range of measured seals, bushes and guides.
  static constexpr double kFirstSpeed_mps = 2e-3;
  static constexpr double kLeastSpeed_mps = 0.5e-3;
  static constexpr double kMostSpeed_mps = 50e-3;

  /// From 0 to the addition's greatest amount, a force in N.
  NewFriction(const AdditionSource& source, const Addition& addition, const std::string& name = "friction");

  const NewParameter& force() const { return force_; }
  const NewParameter& speed() const { return speed_; }
  /// `<friction force="$..." speed="$..."/>`
  std::string Text() const;
  /// Both become the numbers of the addition, whose vehicle is this text with them.
  void Finish(Addition& addition, VehicleEdit& edit) const;

 private:
  NewParameter force_;
  NewParameter speed_;
};

}  // namespace fourpost
