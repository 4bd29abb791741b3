#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "analysis/text/units.h"
#include "vehicles/description/element_laws.h"
#include "vehicles/description/scalar.h"

namespace fourpost {

/// A named number that a fit may change. Values are SI.
struct Parameter {
  std::string name;
  double value = 0;
  double lower = 0;
  double upper = 0;
  /// Grid step of the search.
  double precision = 0;
  Dimension dimension;
  /// Unit the user wrote; used when the value is shown.
  std::string unit;
  std::string source;
  /// Prior knowledge: a normal distribution about `value`, with this standard deviation.
  std::optional<double> prior_sd;
  /// Prior knowledge: the logarithm of its ratio to another parameter is normal about that of the values, with this
  /// standard deviation. Both are positive within their bounds.
  struct Likeness {
    std::string parameter;
    double sd = 0;
  };
  std::optional<Likeness> like = {};
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
  std::array<Scalar, 3> com;
  /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of mass, in link axes [kg m^2].
  std::array<Scalar, 6> inertia;
  std::vector<Visual> visuals;
  int line = 0;

  Eigen::Vector3d ComAt(std::span<const double> parameters) const;
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
  /// At the values of the file's parameters, the shift included.
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
  /// Along the link's axes from the place drawn; as parameters, a hard point that a fit may move, see WithPointsAt().
  std::array<Scalar, 3> shift = {};
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

/// A spring, a bump stop or the gas in a damper. Tension = preload + law(L - L_design).
struct Spring {
  enum class Kind { kCoil, kStop, kGas };
  Kind kind = Kind::kCoil;
  /// For gas the damper's name.
  std::string name;
  ForceLine line;
  SpringDescription law;
  /// Tension in the design pose [N]; empty: by free_length.
  std::optional<Scalar> preload;
  /// Length without load [m]: preload = -law(free_length - L_design). If empty as well, equilibrium in the design pose
  /// sets the preload.
  std::optional<Scalar> free_length;
  int source_line = 0;

  /// Name in messages: "fp:spring 'coil'", "the gas of fp:damper 'strut'".
  std::string Element() const;
};

/// A damper: its dashpot's force against extension rate, rebound and tension positive; alone or in series with a
/// spring.
struct Damper {
  std::string name;
  ForceLine line;
  DashpotDescription law;
  std::optional<SpringDescription> series;
  /// Replaces `law`, except for its friction.
  std::optional<HydraulicDescription> hydraulic;
  int source_line = 0;

  /// The hydraulic law with the damper's friction.
  HydraulicDamper HydraulicAt(std::span<const double> parameters) const;
};

/// Six springs and dampers between two points, along and about the axes of the parent's frame. Translation: of the
/// child point in these axes. Rotation: twice the vector part of the quaternion of the child's turn, which is the angle
/// about each axis to third order. Both are zero in the design pose.
struct Bushing {
  std::string name;
  Point parent;
  Point child;
  /// Axes of the bushing in the parent link.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  /// x, y, z [N/m, N s/m], then about x, y, z [N m/rad, N m s/rad].
  std::array<Scalar, 6> stiffness;
  std::array<Scalar, 6> damping;
  /// Adds damping = factor stiffness / (2 pi frequency): rubber's loss factor at that frequency.
  Scalar loss_factor;
  double loss_frequency_Hz = 1;
  /// Whether its translations carry forces that hold the design pose, as springs do; otherwise it is unloaded there.
  bool holds = false;
  int source_line = 0;

  double DampingAt(std::size_t component, std::span<const double> parameters) const;
};

/// An anti-roll bar: force stiffness (e_left - e_right) + damping (...)' along the left line, opposite along the right;
/// e: extension of the line between the bar's end and the part it is linked to.
struct AntiRollBar {
  std::string name;
  ForceLine left;
  ForceLine right;
  Scalar stiffness;
  Scalar damping;
  int source_line = 0;
};

/// A tyre between the centre of a wheel and a post's platform. It stays upright however the link pitches, and leans
/// with it in roll: its foot is `radius` below the centre, along the wheel's plane (normal: the link's y axis).
/// Vertical force on the wheel = preload + law(squeeze) + damping squeeze', squeeze: approach of foot and platform from
/// the design pose, where the law stands at the deflection that carries the preload. Lateral and longitudinal springs
/// and dampers hold the foot to its position on the platform.
struct Tyre {
  std::string name;
  Point point;
  /// 0: the foot is the point itself.
  double radius = 0;
  TyreDescription law;
  Scalar damping;
  Scalar lateral;
  Scalar longitudinal;
  Scalar lateral_damping;
  Scalar longitudinal_damping;
  /// Whether the vertical force may not pull; forces in the plane remain, see TyreForce. True unless the law is linear.
  bool lifts_off = false;
  /// Vertical force in the design pose [N], pushing; empty: set by equilibrium in the design pose.
  std::optional<Scalar> preload;
  int source_line = 0;
};

/// A hydraulic post that drives the platform under one tyre.
struct Post {
  std::string name;
  int tyre = -1;
  /// Whole travel [m], half of it up and half down from rest; empty: unknown.
  std::optional<double> stroke;
  int source_line = 0;
};

/// A force between two points that a recording or a request gives, such as that of an active suspension, a shaker or
/// the body actuators of a rig. Tension, which pulls the points together, is positive; without a given force it is
/// none.
struct Actuator {
  std::string name;
  ForceLine line;
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

/// Keeps two points together and the links from turning against each other.
struct Weld {
  std::string name;
  Point parent;
  Point child;
  int source_line = 0;
};

/// Keeps two points together and lets the links turn about one axis only.
struct Hinge {
  std::string name;
  Point parent;
  Point child;
  /// Unit vector in parent-link axes, design pose.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
  int source_line = 0;
};

/// A measuring channel.
struct Sensor {
  enum class Type { kAccelerometer, kDisplacement, kStrut, kLoadCell, kGyro };
  std::string name;
  Type type = Type::kAccelerometer;
  /// Accelerometer, displacement: where, and the direction in link axes (unit vector). Gyro: the axis turned about.
  Point point;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  /// Strut: the line whose extension is measured.
  ForceLine line;
  /// Load cell: the tyre whose dynamic force is measured, more load positive.
  int tyre = -1;
  /// Load cell: mass between it and the tyre, whose inertia it measures [kg].
  Scalar wheelpan;
  int source_line = 0;
};

/// What a tag with an attribute `file` takes from that file, as it was read.
struct FileContent {
  /// "fp:spring" and the name of the element, as written.
  std::string tag;
  std::string name;
  /// Absolute.
  std::string file;
  /// Tags that stand for the file: points of a table, rates of a bushing.
  std::string xml;
  /// Whether it is a spring's table without `at`.
  bool lacks_place = false;
  /// The spring's, where the file states it [m].
  std::optional<double> free_length;
  /// What `at` is by the free length [m].
  std::optional<double> at;
};

/// A vehicle as read from its file: plain data, SI, ISO 8855 axes (x forward, y left, z up).
/// Link 0 is the ground; every other link is the child of exactly one joint.
struct Vehicle {
  std::string name;
  std::string file;
  /// The text of the file; empty for a vehicle without one.
  std::string text;
  std::vector<Parameter> parameters;
  std::vector<Link> links;
  /// Parents before children.
  std::vector<Joint> joints;
  std::vector<Spring> springs;
  std::vector<Damper> dampers;
  std::vector<Bushing> bushings;
  std::vector<AntiRollBar> antiroll_bars;
  std::vector<Tyre> tyres;
  std::vector<Post> posts;
  std::vector<Actuator> actuators;
  std::vector<Rod> rods;
  std::vector<Ball> balls;
  std::vector<Weld> welds;
  std::vector<Hinge> hinges;
  std::vector<Sensor> sensors;
  /// Names generated by fp:mirror, each with the written name of its mirror partner.
  std::map<std::string, std::string, std::less<>> twins;
  /// Of tags that name a file.
  std::vector<FileContent> contents;

  /// Index of the parameter of this name.
  std::optional<std::size_t> IndexOf(std::string_view parameter) const;
  /// Whether what is known before a fit is about the value that this parameter has in the file: by a prior_sd, or by a
  /// ratio to another one.
  bool HasPrior(std::size_t parameter) const;
  /// Parameter values of the file.
  std::vector<double> ParameterValues() const;

  bool HasLoops() const { return !(rods.empty() && balls.empty() && welds.empty() && hinges.empty()); }
};

}  // namespace fourpost
