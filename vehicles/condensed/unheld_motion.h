#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/laws/spring_law.h"
#include "vehicles/loops/motion_name.h"

namespace fourpost {

/// A force in the design pose that equilibrium does not set: the weight of a link, or a preload given in the file.
struct GivenForce {
  enum class Kind { kWeight, kPreload };
  Kind kind = Kind::kWeight;
  /// Name in messages: "link 'body'", "fp:spring 'coil'".
  std::string element;
  int line = 0;
  /// At the file's parameter values [kg or N]; 0 for a force that only a parameter can cause.
  double size = 0;
  /// Indices of the parameters that it depends on.
  std::vector<int> parameters;
  /// Generalised force per unit of `size`.
  Eigen::VectorXd direction;
  /// Spring whose free length sets the preload.
  struct FreeSpring {
    SpringLaw law;
    /// Length in the design pose [m].
    double length = 0;

    /// The free length for this preload [m]; empty if there is none.
    std::optional<double> FreeLengthFor(double preload) const;
  };
  std::optional<FreeSpring> free_spring;
  /// Whether the preload could be another one: not that of a stop or of gas, which do not set a vehicle's pose.
  bool carries = true;

  /// Generalised force.
  Eigen::VectorXd Force() const { return size * direction; }
};

/// An element that moves with a vehicle but is unloaded in the design pose.
struct IdleElement {
  enum class Kind { kDamper, kStop, kBushing };
  Kind kind = Kind::kDamper;
  /// Name in messages: "fp:damper 'shock'".
  std::string element;
  /// Its extension per unit of the independent coordinates.
  Eigen::VectorXd direction;
};

/// Forces on a vehicle at rest, in its n independent coordinates.
struct StaticLoads {
  std::vector<GivenForce> forces;
  /// n x preloads that equilibrium sets: generalised force per unit of each.
  Eigen::MatrixXd holders;
  std::vector<IdleElement> idle;
  std::vector<LinkMotion> links;
};

/// A motion that no preload resists, though weights act in it.
struct UnheldMotion {
  NamedMotion motion;
  /// Names of links, in file order: those with about as much energy in that direction as the named one, itself
  /// included; and those that move fastest, counting a radian as a metre.
  std::vector<std::string> alike;
  std::vector<std::string> fastest;
  /// Elements that this motion moves, each by at least a hand's breadth per radian of the link that turns fastest.
  std::vector<IdleElement> idle;
};

/// The motions in which a vehicle falls from its design pose. Let H hold the directions of all preloads, equilibrium's
/// and given ones, Z span the motions without effect on them, H' Z = 0, w be a given force that is not among H, and M
/// the mass matrix. Released, the vehicle moves with the acceleration Z (Z' M Z)^-1 Z' w (Gauss). The motions that
/// these span over all w are named by NameMotions. Those in which all w together do no work, as about the pivot of a
/// balanced beam, are left out if there are others. Empty if only preloads contradict each other.
std::vector<UnheldMotion> UnheldMotions(const StaticLoads& loads);

}  // namespace fourpost
