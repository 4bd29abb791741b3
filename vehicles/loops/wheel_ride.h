#pragma once

#include <map>
#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"
#include "vehicles/loops/loop_pose.h"

namespace fourpost {

/// The centres of a vehicle's tyres, and the parts that rise and fall with them.
class WheelRide {
 public:
  /// `design`: of the design pose.
  WheelRide(const Vehicle& vehicle, const LoopPose& design);

  /// The chassis, see ChassisOf; the ground if there is none.
  int body() const { return body_; }

  /// By the link that locates them: the tyre's, or its carrier if the tyre's link only spins about the tyre's centre.
  const std::map<int, std::vector<Point>>& centres() const { return centres_; }

  /// Vertical motion of a link's tyres against the body in a pose that the tree allows but these motions do not
  /// contain: "heave", "roll" or "pitch"; empty if nothing is lost.
  std::string LostBy(const LoopPose& pose, int link, const Eigen::MatrixXd& motions) const;

 private:
  int CarrierOf(const Vehicle& vehicle, const LoopPose& design, const Tyre& tyre) const;
  std::string Word(const LoopPose& pose, const std::vector<Point>& centres, const Eigen::VectorXd& lost) const;

  std::map<int, std::vector<Point>> centres_;
  int body_ = 0;
};

}  // namespace fourpost
