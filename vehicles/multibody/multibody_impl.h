#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "vehicles/multibody/body_forces.h"
#include "vehicles/multibody/line_forces.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/multibody/simbody_bodies.h"

namespace fourpost {

/// A sensor on the bodies that it reads.
struct SensorData {
  Sensor::Type type = Sensor::Type::kAccelerometer;
  SimTK::MobilizedBody body;
  SimTK::Vec3 station;
  SimTK::Vec3 axis;
  BodyLine line;
  int tyre = -1;
  double wheelpan = 0;
  /// Reading in the design pose, taken off.
  double rest = 0;
};

/// By SimTK::MobilizedBodyIndex: of the rotation and of the origin, in ground axes.
using BodyMotions = SimTK::Vector_<SimTK::SpatialVec>;

/// The Simbody system of a vehicle.
struct Multibody::Impl {
  explicit Impl(const Vehicle& v);

  void AddBodies();
  void AddForces();
  void AddSprings();
  void AddDampers();
  void AddBushings();
  void AddTyres();
  void AddLoops();
  void AddHinge(const Hinge& hinge);
  void NoteLoop(const char* tag, const std::string& name, int line, int rows);
  void AddSensors();
  BodyLine MakeLine(const ForceLine& line);
  void AssembleDesignPose();
  double Distance(const Point& a, const Point& b);
  void MeasureDesign();
  void CreateState();
  bool SetMasses(std::span<const double> parameters);
  void SetState(double t, const Eigen::VectorXd& y);
  void SetPose(const Eigen::VectorXd& q);
  SimTK::MobilizedBody& Body(int link) { return bodies[static_cast<std::size_t>(link)]; }
  void Realize(SimTK::Stage stage);
  double Reading(const SensorData& sensor, const SimTK::State& at, const BodyMotions& accelerations);
  Eigen::VectorXd Readings(const SimTK::State& at, const BodyMotions& accelerations);
  BodyMotions AccelerationsAt(const SimTK::State& at) const;
  const Platforms& PlatformsAt(double t);
  double LoadCell(const SensorData& sensor, const SimTK::State& at);

  Vehicle vehicle;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  std::vector<SimTK::MobilizedBody> bodies;
  std::vector<SpringData> springs;
  /// All except the hydraulic ones, and these; each with its place in Vehicle::dampers.
  std::vector<DamperData> dampers;
  std::vector<std::size_t> damper_index;
  std::vector<HydraulicData> hydraulics;
  std::vector<std::size_t> hydraulic_index;
  /// Friction that sticks, each with its place in Vehicle::dampers.
  std::vector<FrictionData> frictions;
  std::vector<std::size_t> friction_index;
  std::vector<BushingData> bushings;
  std::vector<AntiRollData> antiroll_bars;
  std::vector<BodyLine> actuators;
  std::vector<TyreData> tyres;
  std::vector<SensorData> sensors;
  std::vector<double> rod_lengths;
  std::vector<LoopClosure> loops;
  Platforms posts;
  /// Time of posts; NaN, which equals no time, before the first.
  double platform_time = std::numeric_limits<double>::quiet_NaN();
  PostMotion post_motion;
  std::function<const Platforms&(double)> platforms;
  SimTK::State state;
  Eigen::VectorXd design_pose;
};

}  // namespace fourpost
