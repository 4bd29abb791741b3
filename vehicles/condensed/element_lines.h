#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A line along which an element of a vehicle acts on the n independent coordinates s of its CondensedModel, about the
/// design pose: extension e = direction . s + z of its post, force on s = -direction tension.
struct ElementLine {
  enum class Kind { kStrut, kTyre, kBar, kBushing };
  Kind kind = Kind::kStrut;
  /// Of the element in the vehicle's file, of springs, dampers and gas along one line that of the damper.
  std::string name;
  /// In messages: "damper 'front'", "tyre 'FL'", "bushing 'arm' along x".
  std::string called;
  Eigen::VectorXd direction;
  /// Of a tyre, whose extension is its squeeze; -1: none.
  int post = -1;
};

/// Lines of springs, dampers, tyres in the vertical, anti-roll bars and translations of bushings, in this order; those
/// that act alike are one. Throws FaultyInput if the loops cannot be assembled.
std::vector<ElementLine> ElementLines(const Vehicle& vehicle);

}  // namespace fourpost
