#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "analysis/units.h"

namespace fourpost {

/// A number of the vehicle: a constant, or a factor times one of the vehicle's parameters.
struct Scalar {
  double value = 0;
  int parameter = -1;
  double factor = 1;

  /// The number for these parameter values (SI, in the order of Vehicle::parameters).
  double At(std::span<const double> parameters) const {
    return parameter < 0 ? value : factor * parameters[static_cast<std::size_t>(parameter)];
  }
};

/// A named number that a fit may change. Values are SI.
struct Parameter {
  std::string name;
  double value = 0;
  double lower = 0;
  double upper = 0;
  /// Lattice step of the search.
  double precision = 0;
  Dimension dimension;
  /// Unit the user wrote; used when the value is shown.
  std::string unit;
  std::string source;
  int line = 0;
};

/// A shape for pictures, placed in its link.
struct Visual {
  enum class Shape { kMesh, kBox, kCylinder, kSphere };
  Shape shape = Shape::kMesh;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  /// Mesh: file, as an absolute path.
  std::string mesh_file;
  /// Mesh: scale. Box: edge lengths [m]. Cylinder: radius, radius, length [m]. Sphere: radius thrice [m].
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
};

/// A rigid body.
struct Link {
  std::string name;
  Scalar mass;
  /// Centre of mass in link axes [m].
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of mass, in link axes [kg m^2].
  std::array<Scalar, 6> inertia;
  std::vector<Visual> visuals;
  int line = 0;
};

/// How a link moves relative to its parent; the joint frame is the child link's frame, as in URDF.
struct Joint {
  enum class Type { kFixed, kRevolute, kPrismatic, kPlanar, kFloating };
  std::string name;
  Type type = Type::kFixed;
  int parent = -1;
  int child = -1;
  /// Pose of the child link in the parent link at zero joint coordinate.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  /// Revolute, prismatic: direction of motion; planar: normal. Unit vector in the joint frame.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  int line = 0;
};

/// A point fixed in a link [m].
struct Point {
  int link = -1;
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
};

/// The line along which a two-ended element acts; its length grows in extension.
struct ForceLine {
  Point parent;
  Point child;
  /// Empty: length = distance of the two points, force along the line that joins them.
  /// Given (unit vector in parent-link axes): length = axis . (parent - child), force along the axis through the child
  /// point, as a strut guided by the parent acts.
  std::optional<Eigen::Vector3d> axis;
};

/// Tension = preload + stiffness (L - L_design).
struct Spring {
  std::string name;
  ForceLine line;
  Scalar stiffness;
  /// Tension in the design pose [N]; empty: whatever holds the design pose in equilibrium.
  std::optional<Scalar> preload;
  int source_line = 0;
};

/// Damping force against extension rate v (rebound positive, tension positive):
/// f(v) = rebound v for v > 0, compression v for v < 0. Equal rates make it linear.
/// With a series stiffness k the law acts in line with a spring: f = k x = d(v - dx/dt).
struct Damper {
  std::string name;
  ForceLine line;
  Scalar compression;
  Scalar rebound;
  std::optional<Scalar> series_stiffness;
  int source_line = 0;
};

/// Vertical spring and damper between a point of a link and a post's platform.
struct Tyre {
  std::string name;
  Point point;
  Scalar stiffness;
  Scalar damping;
  /// Compression force in the design pose [N]; empty: whatever holds the design pose in equilibrium.
  std::optional<Scalar> preload;
  int source_line = 0;
};

/// A hydraulic post that drives the platform under one tyre.
struct Post {
  std::string name;
  int tyre = -1;
  int source_line = 0;
};

/// Keeps two points at their design distance.
struct Rod {
  std::string name;
  Point parent;
  Point child;
  int source_line = 0;
};

/// Keeps two points together.
struct Ball {
  std::string name;
  Point parent;
  Point child;
  int source_line = 0;
};

/// A measuring channel.
struct Sensor {
  enum class Type { kAccelerometer, kDisplacement, kStrut, kLoadCell };
  std::string name;
  Type type = Type::kAccelerometer;
  /// Accelerometer, displacement: where, and the direction in link axes (unit vector).
  Point point;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  /// Strut: the line whose extension is measured.
  ForceLine line;
  /// Load cell: the tyre whose dynamic force is measured, more load positive.
  int tyre = -1;
  int source_line = 0;
};

/// A vehicle as read from its file: plain data, SI, ISO 8855 axes (x forward, y left, z up).
/// Link 0 is the ground; every other link is the child of exactly one joint.
struct Vehicle {
  std::string name;
  std::string file;
  /// The file as it was read; empty for a vehicle that came from none.
  std::string text;
  std::vector<Parameter> parameters;
  std::vector<Link> links;
  /// Parents before children.
  std::vector<Joint> joints;
  std::vector<Spring> springs;
  std::vector<Damper> dampers;
  std::vector<Tyre> tyres;
  std::vector<Post> posts;
  std::vector<Rod> rods;
  std::vector<Ball> balls;
  std::vector<Sensor> sensors;

  /// Values of the parameters as the file gives them.
  std::vector<double> ParameterValues() const;
};

}  // namespace fourpost
