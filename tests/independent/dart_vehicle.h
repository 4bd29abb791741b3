#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "tests/independent/dart_tree.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// A vehicle in DART: its tree, and the laws of its elements as vehicle.h states them, written out once more on DART's
/// kinematics. Knows linear and cubic springs, linear and bilinear dampers, anti-roll bars, bushings and tyres.
class DartVehicle {
 public:
  /// Throws std::invalid_argument for what it does not know.
  DartVehicle(const Vehicle& vehicle, const Preloads& preloads);

  /// d[q u]/dt of the state [q u], see DartTree.
  Eigen::VectorXd StateDerivative(const Eigen::VectorXd& state, std::span<const PostState> posts);
  /// M(q) at the last state.
  Eigen::MatrixXd MassMatrix() const { return tree_.MassMatrix(); }

 private:
  /// A ForceLine at one instant: where a tension acts, and its direction on the child.
  struct LineMotion {
    Eigen::Vector3d on_parent;
    Eigen::Vector3d on_child;
    Eigen::Vector3d pull;
    double length = 0;
    double rate = 0;
  };

  void RefuseUnknown() const;
  void MeasureDesign();

  LineMotion Motion(const ForceLine& line) const;
  Eigen::Isometry3d ChildInBushing(const Bushing& bushing) const;
  Eigen::Vector3d Foot(const Tyre& tyre) const;

  void Pull(const ForceLine& line, const LineMotion& motion, double tension);
  void Apply(const Spring& spring, double preload, double design_length);
  void Apply(const Damper& damper);
  void Apply(const AntiRollBar& bar, double design_difference);
  void Apply(const Bushing& bushing, const Eigen::Vector3d& preload, const Eigen::Isometry3d& design);
  void Apply(const Tyre& tyre, double preload, const Eigen::Vector3d& design_foot, const PostState& platform);
  void ApplyElements(std::span<const PostState> posts);

  Vehicle vehicle_;
  Preloads preloads_;
  std::vector<double> parameters_;
  DartTree tree_;
  // In the design pose.
  std::vector<double> spring_lengths_;
  std::vector<double> bar_differences_;
  std::vector<Eigen::Isometry3d> bushings_;
  std::vector<Eigen::Vector3d> feet_;
};

}  // namespace fourpost
