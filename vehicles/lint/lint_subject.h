#pragma once

#include <vector>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// A vehicle at its file's values, as seen by plausibility checks.
struct LintSubject {
  /// Throws FaultyInput as CondensedVehicle does. The vehicle must outlive this object.
  explicit LintSubject(const Vehicle& described);

  double At(const Scalar& scalar) const { return scalar.At(values); }
  /// In ground axes, design pose.
  Eigen::Vector3d Place(const Point& point) const { return pose.Location(point); }
  /// Weight of all that can move [N].
  double Weight() const;

  const Vehicle& vehicle;
  std::vector<double> values;
  CondensedVehicle condensed;
  CondensedModel model;
  std::vector<Mode> modes;
  std::vector<LinkMotion> links;
  /// The design pose.
  Kinematics pose;
};

/// A plausibility check: adds a warning, with a remedy, for each finding.
using LintRule = void (*)(const LintSubject& subject, FileFaults& findings);

}  // namespace fourpost
