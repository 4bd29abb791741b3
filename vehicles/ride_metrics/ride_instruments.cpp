#include "vehicles/ride_metrics/ride_instruments.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vehicles/description/design_poses.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/ride/suspension.h"

namespace fourpost {
namespace {

/// Directions within 45 degrees of it are vertical.
constexpr double kVertical = 0.7071;

std::size_t Add(Sensor sensor, RideInstruments& instruments) {
  instruments.vehicle.sensors.push_back(std::move(sensor));
  return instruments.vehicle.sensors.size() - 1;
}

bool Holds(const std::vector<int>& links, int link) {
  return std::find(links.begin(), links.end(), link) != links.end();
}

/// A place in ground axes as a point of a link.
Point PointAt(const Eigen::Vector3d& place, int link, const std::vector<Eigen::Isometry3d>& poses) {
  return {.link = link, .xyz = poses[static_cast<std::size_t>(link)].inverse() * place};
}

class Instrumenting {
 public:
  Instrumenting(const Vehicle& vehicle, const std::vector<RidePoint>& more)
      : vehicle_(vehicle),
        poses_(DesignPoses(vehicle)),
        suspension_(SuspensionOf(vehicle, DesignKinematics(vehicle), vehicle.ParameterValues())) {
    instruments_.vehicle = vehicle;
    instruments_.file_sensors = vehicle.sensors.size();
    instruments_.tracks = RoadTracksOf(vehicle);
    FindChassis();
    AddPoints(more);
    AddTyres();
    AddDampers();
    AddChassis();
    AddAxles();
  }

  RideInstruments Take() { return std::move(instruments_); }

 private:
  void FindChassis() {
    if (suspension_.chassis < 0) return;
    const BodyMotion& body = suspension_.bodies[static_cast<std::size_t>(suspension_.chassis)];
    links_ = body.links;
    centre_ = body.mass.com;
    for (const int link : links_)
      if (vehicle_.links[static_cast<std::size_t>(link)].name == body.name) link_ = link;
  }

  std::size_t AddHeight(const Eigen::Vector3d& place, const char* name) {
    const Eigen::Isometry3d& pose = poses_[static_cast<std::size_t>(link_)];
    return Add({.name = name,
                .type = Sensor::Type::kDisplacement,
                .point = PointAt(place, link_, poses_),
                .axis = pose.linear().transpose() * Eigen::Vector3d::UnitZ()},
               instruments_);
  }

  void AddPoints(const std::vector<RidePoint>& more) {
    for (std::size_t i = 0; i < vehicle_.sensors.size(); ++i) {
      const Sensor& sensor = vehicle_.sensors[i];
      if (sensor.type != Sensor::Type::kAccelerometer || !Holds(links_, sensor.point.link)) continue;
      const Eigen::Vector3d axis = poses_[static_cast<std::size_t>(sensor.point.link)].linear() * sensor.axis;
      instruments_.points.push_back({sensor.name, i, std::abs(axis.z()) > kVertical ? Weighting::kWk : Weighting::kWd});
    }
    for (const RidePoint& point : more) AddPoint(point);
    if (!instruments_.points.empty() || links_.empty()) return;
    const Eigen::Isometry3d& pose = poses_[static_cast<std::size_t>(link_)];
    AddPoint({.name = vehicle_.links[static_cast<std::size_t>(link_)].name,
              .point = PointAt(centre_, link_, poses_),
              .axis = pose.linear().transpose() * Eigen::Vector3d::UnitZ()});
  }

  void AddPoint(const RidePoint& point) {
    const std::size_t sensor =
        Add({.name = point.name, .type = Sensor::Type::kAccelerometer, .point = point.point, .axis = point.axis},
            instruments_);
    instruments_.points.push_back({point.name, sensor, point.weighting});
  }

  void AddTyres() {
    for (std::size_t i = 0; i < vehicle_.tyres.size(); ++i)
      instruments_.loads.push_back(Add(
          {.name = "load of " + vehicle_.tyres[i].name, .type = Sensor::Type::kLoadCell, .tyre = static_cast<int>(i)},
          instruments_));
  }

  void AddDampers() {
    for (const Damper& damper : vehicle_.dampers)
      instruments_.dampers.push_back(Add(
          {.name = "extension of " + damper.name, .type = Sensor::Type::kStrut, .line = damper.line}, instruments_));
    for (std::size_t i = 0; i < vehicle_.springs.size(); ++i) {
      const Spring& spring = vehicle_.springs[i];
      if (spring.kind != Spring::Kind::kStop) continue;
      instruments_.stops.push_back(
          {i, Add({.name = "extension of " + spring.name, .type = Sensor::Type::kStrut, .line = spring.line},
                  instruments_)});
    }
  }

  void AddChassis() {
    if (links_.empty()) return;
    const double lever = RideInstruments::kLever_m;
    instruments_.chassis = {.centre = AddHeight(centre_, "chassis"),
                            .ahead = AddHeight(centre_ + lever * Eigen::Vector3d::UnitX(), "chassis ahead"),
                            .left = AddHeight(centre_ + lever * Eigen::Vector3d::UnitY(), "chassis left")};
  }

  void AddAxles() {
    for (const Axle& axle : suspension_.axles) {
      RideInstruments::Axle added{.name = axle.name, .tyres = axle.wheels, .posts = {}, .height = {}};
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const std::size_t i : axle.wheels)
        middle += suspension_.wheels[i].foot / static_cast<double>(axle.wheels.size());
      for (std::size_t p = 0; p < vehicle_.posts.size(); ++p)
        if (std::find(axle.wheels.begin(), axle.wheels.end(), static_cast<std::size_t>(vehicle_.posts[p].tyre)) !=
            axle.wheels.end())
          added.posts.push_back(p);
      if (!links_.empty()) added.height = AddHeight({middle.x(), middle.y(), centre_.z()}, "ride height");
      instruments_.axles.push_back(std::move(added));
    }
  }

  const Vehicle& vehicle_;
  std::vector<Eigen::Isometry3d> poses_;
  Suspension suspension_;
  /// Of the chassis; empty: there is none.
  std::vector<int> links_;
  int link_ = 0;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  RideInstruments instruments_;
};

}  // namespace

RideInstruments InstrumentRide(const Vehicle& vehicle, const std::vector<RidePoint>& more) {
  return Instrumenting(vehicle, more).Take();
}

}  // namespace fourpost
