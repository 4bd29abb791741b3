#pragma once

#include <map>
#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"
#include "vehicles/loops/loop_pose.h"

namespace fourpost {

/// The centres of a vehicle's tyres, and what goes up and down with them.
class WheelRide {
 public:
  /// `design`: of the design pose.
  WheelRide(const Vehicle& vehicle, const LoopPose& design);

  /// The chassis, see ChassisOf; the ground when there is none.
  int body() const { return body_; }

  /// By the link that locates them: the tyre's, or what carries it where that only spins about the tyre's centre.
  const std::map<int, std::vector<Point>>& centres() const { return centres_; }

  /// How a link's tyres may go up and down against the body in a pose when only the tree says so, but not any more with
  /// these motions: "heave", "roll" or "pitch"; empty when nothing is lost.
  std::string LostBy(const LoopPose& pose, int link, const Eigen::MatrixXd& motions) const;

 private:
  int CarrierOf(const Vehicle& vehicle, const LoopPose& design, const Tyre& tyre) const;
  std::string Word(const LoopPose& pose, const std::vector<Point>& centres, const Eigen::VectorXd& lost) const;

  std::map<int, std::vector<Point>> centres_;
  int body_ = 0;
};

}  // namespace fourpost
