#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/laws/spring_law.h"
#include "vehicles/loops/motion_name.h"

namespace fourpost {

/// A force of the design pose that equilibrium does not set: the weight of a link, or a preload that the file gives.
struct GivenForce {
  enum class Kind { kWeight, kPreload };
  Kind kind = Kind::kWeight;
  /// As messages call it: "link 'body'", "fp:spring 'coil'".
  std::string element;
  int line = 0;
  /// At the file's parameter values [kg or N]; 0 for what only a parameter can bring about.
  double size = 0;
  /// Indices of the parameters that it follows.
  std::vector<int> parameters;
  /// Generalised force per unit of `size`.
  Eigen::VectorXd direction;
  /// Of a spring whose free length sets the preload.
  struct FreeSpring {
    SpringLaw law;
    /// In the design pose [m].
    double length = 0;

    /// The free length that makes this preload [m]; nothing where none does.
    std::optional<double> FreeLengthFor(double preload) const;
  };
  std::optional<FreeSpring> free_spring;
  /// A preload that could be another one: not that of a stop or of gas, which do not set a vehicle's pose.
  bool carries = true;

  /// Generalised force.
  Eigen::VectorXd Force() const { return size * direction; }
};

/// What moves with a vehicle but has no load in the design pose.
struct IdleElement {
  enum class Kind { kDamper, kStop, kBushing };
  Kind kind = Kind::kDamper;
  /// As messages call it: "fp:damper 'shock'".
  std::string element;
  /// Its extension per unit of the independent coordinates.
  Eigen::VectorXd direction;
};

/// What acts on a vehicle at rest, in its n independent coordinates.
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
  /// Names of links, in file order: those with about as much energy in that direction as the named one, which is among
  /// them; and those that move fastest, taking a radian for a metre.
  std::vector<std::string> alike;
  std::vector<std::string> fastest;
  /// Those that this motion moves, each by a hand's breadth per radian of what turns fastest or more.
  std::vector<IdleElement> idle;
};

/// The motions in which a vehicle falls from its design pose. Let H hold the directions of all preloads, equilibrium's
/// and given ones, Z span the motions that none of them feels, H' Z = 0, w be a given force that is not among H, and M
/// the mass matrix. Released, the vehicle moves with the acceleration Z (Z' M Z)^-1 Z' w (Gauss). The motions that
/// these span over all w are named by NameMotions; those in which all w together do no work, as about the pivot of a
/// balanced beam, are left out where there are others. None where preloads alone stand against each other.
std::vector<UnheldMotion> UnheldMotions(const StaticLoads& loads);

}  // namespace fourpost
