#include <algorithm>
#include <stdexcept>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/gravity.h"
#include "vehicles/multibody/close_loops.h"
#include "vehicles/multibody/loop_gaps.h"
#include "vehicles/multibody/multibody_impl.h"

namespace fourpost {

namespace {

using SimTK::MobilizedBody;
using SimTK::Vec3;

}  // namespace

Multibody::Impl::Impl(const Vehicle& v) : vehicle(v) {
  platforms = [this](double t) -> const Platforms& { return PlatformsAt(t); };
  posts.resize(vehicle.posts.size() + vehicle.actuators.size());
  AddBodies();
  AddForces();
  AddLoops();
  AddSensors();
  CreateState();
  design_pose = Eigen::VectorXd::Zero(state.getNQ());
  AssembleDesignPose();
  MeasureDesign();
}

void Multibody::Impl::AddBodies() {
  const std::vector<double> parameters = vehicle.ParameterValues();
  bodies.resize(vehicle.links.size());
  bodies[0] = matter.Ground();
  for (const Joint& joint : vehicle.joints) {
    const SimTK::Body::Rigid body(MassPropertiesAt(vehicle.links[static_cast<std::size_t>(joint.child)], parameters));
    Body(joint.child) = AddMobilizer(joint, Body(joint.parent), body);
  }
}

BodyLine Multibody::Impl::MakeLine(const ForceLine& line) {
  BodyLine out;
  out.parent = Body(line.parent.link);
  out.child = Body(line.child.link);
  out.parent_station = ToSimbody(line.parent.xyz);
  out.child_station = ToSimbody(line.child.xyz);
  out.guided = line.axis.has_value();
  if (line.axis) out.axis = ToSimbody(*line.axis);
  return out;
}

// The elements keep references into the vectors of their data: each has its final size before its elements are made.

void Multibody::Impl::AddForces() {
  // A handle; the system owns the force.
  const SimTK::Force::Gravity gravity(forces, matter, -SimTK::ZAxis, kGravity);
  AddSprings();
  AddDampers();
  AddBushings();
  AddTyres();
}

void Multibody::Impl::AddSprings() {
  for (const Spring& spring : vehicle.springs) springs.push_back({.line = MakeLine(spring.line), .law = {}});
  for (const SpringData& spring : springs) SimTK::Force::Custom(forces, new SpringForce(spring));
  for (const AntiRollBar& bar : vehicle.antiroll_bars)
    antiroll_bars.push_back({.left = MakeLine(bar.left), .right = MakeLine(bar.right)});
  for (const AntiRollData& bar : antiroll_bars) SimTK::Force::Custom(forces, new AntiRollForce(bar));
  for (const Actuator& actuator : vehicle.actuators) actuators.push_back(MakeLine(actuator.line));
  for (std::size_t i = 0; i < actuators.size(); ++i)
    SimTK::Force::Custom(forces, new ActuatorForce(actuators[i], vehicle.posts.size() + i, platforms));
}

void Multibody::Impl::AddDampers() {
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i) {
    const Damper& damper = vehicle.dampers[i];
    if (damper.law.Sticks()) {
      frictions.push_back({.line = MakeLine(damper.line), .law = {}});
      friction_index.push_back(i);
    }
    if (damper.hydraulic) {
      hydraulics.push_back({.line = MakeLine(damper.line), .damper = {}, .is_mounted = damper.series.has_value()});
      hydraulic_index.push_back(i);
    } else {
      dampers.push_back(
          {.line = MakeLine(damper.line), .dashpot = {}, .in_series = damper.series.has_value(), .series = {}});
      damper_index.push_back(i);
    }
  }
  for (const DamperData& damper : dampers) SimTK::Force::Custom(forces, new DamperForce(damper, forces));
  for (const HydraulicData& damper : hydraulics) SimTK::Force::Custom(forces, new HydraulicForce(damper, forces));
  for (const FrictionData& friction : frictions) SimTK::Force::Custom(forces, new FrictionForce(friction, forces));
}

void Multibody::Impl::AddBushings() {
  for (const Bushing& bushing : vehicle.bushings)
    bushings.push_back({.parent = Body(bushing.parent.link),
                        .child = Body(bushing.child.link),
                        .parent_station = ToSimbody(bushing.parent.xyz),
                        .child_station = ToSimbody(bushing.child.xyz),
                        .parent_axes = bushing.axes,
                        .child_axes = {},
                        .design_place = {}});
  for (const BushingData& bushing : bushings) SimTK::Force::Custom(forces, new BushingForce(bushing));
}

void Multibody::Impl::AddTyres() {
  for (const Tyre& tyre : vehicle.tyres)
    tyres.push_back({.body = Body(tyre.point.link),
                     .station = ToSimbody(tyre.point.xyz),
                     .radius = tyre.radius,
                     .lifts_off = tyre.lifts_off || !tyre.law.IsLinear()});
  for (std::size_t i = 0; i < vehicle.posts.size(); ++i)
    tyres[static_cast<std::size_t>(vehicle.posts[i].tyre)].post = static_cast<int>(i);
  for (const TyreData& tyre : tyres) SimTK::Force::Custom(forces, new TyreForce(tyre, platforms));
}

void Multibody::Impl::NoteLoop(const char* tag, const std::string& name, int line, int rows) {
  const int first = loops.empty() ? 0 : loops.back().first_row + loops.back().rows;
  loops.push_back({std::string(tag) + " '" + name + "'", line, first, rows});
}

void Multibody::Impl::AddLoops() {
  if (!vehicle.HasLoops()) return;
  // Lengths and directions of the design pose, which tree coordinates of zero define.
  CreateState();
  system.realize(state, SimTK::Stage::Position);
  for (const Rod& rod : vehicle.rods) rod_lengths.push_back(Distance(rod.parent, rod.child));
  for (const Ball& ball : vehicle.balls) {
    SimTK::Constraint::Ball(Body(ball.parent.link), ToSimbody(ball.parent.xyz), Body(ball.child.link),
                            ToSimbody(ball.child.xyz));
    NoteLoop("fp:ball", ball.name, ball.source_line, 3);
  }
  for (std::size_t i = 0; i < rod_lengths.size(); ++i) {
    const Rod& rod = vehicle.rods[i];
    SimTK::Constraint::Rod(Body(rod.parent.link), ToSimbody(rod.parent.xyz), Body(rod.child.link),
                           ToSimbody(rod.child.xyz), rod_lengths[i]);
    NoteLoop("fp:rod", rod.name, rod.source_line, 1);
  }
  for (const Weld& weld : vehicle.welds) {
    const SimTK::Transform parent_in_child =
        Body(weld.parent.link).findBodyTransformInAnotherBody(state, Body(weld.child.link));
    SimTK::Constraint::Weld(Body(weld.parent.link), SimTK::Transform(ToSimbody(weld.parent.xyz)), Body(weld.child.link),
                            SimTK::Transform(parent_in_child.R(), ToSimbody(weld.child.xyz)));
    NoteLoop("fp:weld", weld.name, weld.source_line, 6);
  }
  for (const Hinge& hinge : vehicle.hinges) AddHinge(hinge);
}

/// A ball, and the child's axis at right angles to two directions across the parent's.
void Multibody::Impl::AddHinge(const Hinge& hinge) {
  MobilizedBody& parent = Body(hinge.parent.link);
  MobilizedBody& child = Body(hinge.child.link);
  const SimTK::UnitVec3 axis(ToSimbody(hinge.axis));
  const SimTK::UnitVec3 axis_in_child(~child.findBodyRotationInAnotherBody(state, parent) * axis);
  const SimTK::UnitVec3 across = axis.perp();
  const SimTK::UnitVec3 across_both(axis % across);
  SimTK::Constraint::Ball(parent, ToSimbody(hinge.parent.xyz), child, ToSimbody(hinge.child.xyz));
  SimTK::Constraint::ConstantAngle(parent, across, child, axis_in_child);
  SimTK::Constraint::ConstantAngle(parent, across_both, child, axis_in_child);
  NoteLoop("fp:hinge", hinge.name, hinge.source_line, 5);
}

void Multibody::Impl::AddSensors() {
  for (const Sensor& sensor : vehicle.sensors) {
    SensorData data;
    data.type = sensor.type;
    data.tyre = sensor.tyre;
    data.wheelpan = sensor.wheelpan.value;
    data.axis = ToSimbody(sensor.axis);
    if (sensor.type == Sensor::Type::kStrut) data.line = MakeLine(sensor.line);
    if (sensor.point.link >= 0) {
      data.body = Body(sensor.point.link);
      data.station = ToSimbody(sensor.point.xyz);
    }
    sensors.push_back(data);
  }
}

void Multibody::Impl::CreateState() { state = system.realizeTopology(); }

void Multibody::Impl::AssembleDesignPose() {
  const auto error_at = [this](const Eigen::VectorXd& q) {
    SetPose(q);
    return Eigen::VectorXd(ToEigen(state.getQErr()));
  };
  const auto jacobian = [this] {
    SimTK::Matrix g;
    matter.calcG(state, g);
    return Eigen::MatrixXd(ToEigen(g));
  };
  const ClosedLoops assembled = CloseLoops({error_at, jacobian}, design_pose);
  SetPose(assembled.pose);
  design_pose = assembled.pose;
  if (assembled.is_closed) return;
  const auto distance = [this](const Point& parent, const Point& child) { return Distance(parent, child); };
  throw FaultyInput(LoopGapFaults(vehicle, distance));
}

double Multibody::Impl::Distance(const Point& a, const Point& b) {
  return (Body(a.link).findStationLocationInGround(state, ToSimbody(a.xyz)) -
          Body(b.link).findStationLocationInGround(state, ToSimbody(b.xyz)))
      .norm();
}

void Multibody::Impl::MeasureDesign() {
  SetPose(design_pose);
  for (SpringData& spring : springs) spring.line.design_length = Length(spring.line, state);
  for (DamperData& damper : dampers) damper.line.design_length = Length(damper.line, state);
  for (HydraulicData& damper : hydraulics) damper.line.design_length = Length(damper.line, state);
  for (FrictionData& friction : frictions) friction.line.design_length = Length(friction.line, state);
  for (AntiRollData& bar : antiroll_bars) {
    bar.left.design_length = Length(bar.left, state);
    bar.right.design_length = Length(bar.right, state);
  }
  for (BushingData& bushing : bushings) fourpost::MeasureDesign(bushing, state);
  for (TyreData& tyre : tyres) fourpost::MeasureDesign(tyre, state);
  for (SensorData& sensor : sensors) {
    if (sensor.type == Sensor::Type::kStrut) sensor.line.design_length = Length(sensor.line, state);
    if (sensor.type == Sensor::Type::kDisplacement) {
      // A displacement is measured from the ground, along the axis as it points in the design pose.
      sensor.axis = sensor.body.getBodyRotation(state) * sensor.axis;
      sensor.rest = Reading(sensor, state, {});
    }
    // At rest an accelerometer shows gravity along its axis.
    if (sensor.type == Sensor::Type::kAccelerometer)
      sensor.rest = kGravity * (sensor.body.getBodyRotation(state) * sensor.axis)[2];
  }
}

}  // namespace fourpost
