#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "identify/experiments/kinematics/kinematic_sweep.h"
#include "vehicles/ride/suspension.h"

namespace fourpost {

/// What the words of a rig's table mean on a vehicle.
class MeasuredAxles {
 public:
  /// Throws FaultyInput if the vehicle cannot be assembled.
  explicit MeasuredAxles(const Vehicle& vehicle);

  const std::vector<std::string>& names() const { return names_; }
  std::optional<std::size_t> AxleNamed(const std::string& name) const;
  /// Place in Axle::wheels: by the tyre's name, or "left" and "right" of an axle with one wheel a side.
  std::optional<std::size_t> WheelNamed(const std::string& name, std::size_t axle) const;
  const std::string& WheelName(std::size_t place, std::size_t axle) const;
  /// Null for an unknown name.
  const AxleStrut* StrutNamed(const std::string& name) const;
  /// Whether a quantity may be of this on some axle.
  bool IsKnown(const KinematicQuantity& quantity, const std::string& of) const;
  /// Whether all axles have one wheel.
  bool HaveOneWheel() const;

  /// Of a sweep's axle its motion, travel or load; false where it has none of this name.
  bool SetMotion(const std::string& motion, bool is_opposed, KinematicSweep& sweep) const;
  std::vector<std::string> MotionsOf(std::size_t axle) const;

 private:
  Suspension suspension_;
  std::vector<AxleStrut> struts_;
  std::vector<std::string> names_;
};

/// "lateral" and so on; nothing for another word.
std::optional<WheelLoad> LoadNamed(const std::string& name);

}  // namespace fourpost
