#include "vehicles/condensed/condense.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <span>
#include <utility>

#include "vehicles/condensed/design_shapes.h"
#include "vehicles/condensed/equilibrium.h"
#include "vehicles/condensed/findings.h"
#include "vehicles/condensed/sensor_rows.h"
#include "vehicles/description/gravity.h"
#include "vehicles/loops/chart.h"

namespace fourpost {
namespace {

std::string Tagged(const char* tag, const std::string& name) { return std::string(tag) + " '" + name + "'"; }

/// Among the springs: their preloads are not set by a file.
bool IsStopOrGas(const std::string& element) {
  return element.starts_with("fp:stop") || element.starts_with("the gas of");
}

bool HasMovableCom(const Link& link) {
  return std::any_of(link.com.begin(), link.com.end(), [](const Scalar& number) { return number.parameter >= 0; });
}

/// Points whose heights are needed: the centre of mass, or the origin and the ends of the link's unit vectors.
std::vector<Point> HeightPoints(const Link& link, int index) {
  if (!HasMovableCom(link)) return {{index, link.ComAt({})}};
  return {{index, Eigen::Vector3d::Zero()},
          {index, Eigen::Vector3d::UnitX()},
          {index, Eigen::Vector3d::UnitY()},
          {index, Eigen::Vector3d::UnitZ()}};
}

/// Values at the origin and at the ends of the unit vectors become the affine function's.
template <typename T>
void MakeAffine(std::vector<T>& values) {
  for (std::size_t k = 1; k < values.size(); ++k) values[k] -= values[0];
}

/// `heights`: shapes of the heights of HeightPoints().
ReducedData::Body BodyOf(const Link& link, int index, const Kinematics& pose, std::span<const DesignShape> heights) {
  ReducedData::Body body{.name = link.name,
                         .mass = link.mass,
                         .com = link.com,
                         .inertia = link.inertia,
                         .place = {},
                         .com_jacobian = {},
                         .spin_jacobian = pose.Rotation(index).transpose() * pose.AngularJacobian(index),
                         .weight = {},
                         .weight_stiffness = {}};
  for (const Point& point : HeightPoints(link, index)) {
    body.place.push_back(pose.Location(point));
    body.com_jacobian.push_back(pose.PointJacobian(point));
  }
  for (const DesignShape& height : heights) {
    body.weight.emplace_back(kGravity * height.gradient);
    body.weight_stiffness.emplace_back(kGravity * height.curvature);
  }
  MakeAffine(body.place);
  MakeAffine(body.com_jacobian);
  MakeAffine(body.weight);
  MakeAffine(body.weight_stiffness);
  return body;
}

/// Where a held element stands in the vehicle's file.
struct HeldPlace {
  std::string element;
  int line = 0;
};

/// Takes a vehicle's data in its design pose.
class Condenser {
 public:
  explicit Condenser(const Vehicle& vehicle) : vehicle_(vehicle), multibody_(vehicle), chart_(multibody_) {}

  ReducedData Take();
  const std::vector<HeldPlace>& places() const { return places_; }

 private:
  ReducedData::Held& Hold(const std::string& element, int line, const SpringDescription& law);
  void AddHeld(const Kinematics& pose);
  void AddShapes(const Kinematics& pose);
  void AddTyres();
  void AddBonds(const Kinematics& pose);
  void AddDampers(const Kinematics& pose);
  void AddSensors(const Kinematics& pose);

  const Vehicle& vehicle_;
  Multibody multibody_;
  Chart chart_;
  ReducedData data_;
  std::vector<HeldPlace> places_;
  std::vector<GeometricScalar> lengths_;
};

ReducedData Condenser::Take() {
  if (chart_.size() == 0) Refuse(kNothingMoves, {vehicle_.file});
  data_.name = vehicle_.name;
  data_.parameters = vehicle_.parameters;
  for (const Post& post : vehicle_.posts) data_.posts.push_back(post.name);
  data_.coordinates = static_cast<int>(chart_.size());
  const Kinematics pose(multibody_, chart_.MoveTo(Eigen::VectorXd::Zero(chart_.size())));
  AddHeld(pose);
  AddShapes(pose);
  AddTyres();
  AddBonds(pose);
  AddDampers(pose);
  AddSensors(pose);
  return std::move(data_);
}

ReducedData::Held& Condenser::Hold(const std::string& element, int line, const SpringDescription& law) {
  places_.push_back({element, line});
  ReducedData::Held held;
  held.law = law;
  return data_.held.emplace_back(std::move(held));
}

void Condenser::AddHeld(const Kinematics& undisturbed) {
  data_.springs = vehicle_.springs.size();
  for (const Spring& spring : vehicle_.springs) {
    lengths_.push_back([&](const Kinematics& pose) { return pose.LineLength(spring.line); });
    ReducedData::Held& held = Hold(spring.Element(), spring.source_line, spring.law);
    held.preload = spring.preload;
    held.free_length = spring.free_length;
  }
  for (const Tyre& tyre : vehicle_.tyres) {
    lengths_.push_back([&](const Kinematics& pose) { return pose.FootPosition(tyre, -Eigen::Vector3d::UnitZ()); });
    Hold(Tagged("fp:tyre", tyre.name), tyre.source_line, {.stiffness = tyre.law.stiffness, .cubic = {}, .knees = {}})
        .preload = tyre.preload;
  }
  for (const Bushing& bushing : vehicle_.bushings) {
    data_.bushings.push_back(bushing.holds);
    const Eigen::Matrix3d child_axes = undisturbed.ChildAxes(bushing);
    for (std::size_t k = 0; k < 3 && bushing.holds; ++k) {
      lengths_.push_back(
          [&bushing, child_axes, k](const Kinematics& pose) { return pose.BushingPlace(bushing, child_axes)[k]; });
      Hold(Tagged("fp:bushing", bushing.name), bushing.source_line,
           {.stiffness = bushing.stiffness[k], .cubic = {}, .knees = {}});
    }
  }
}

/// Of held elements and bodies.
void Condenser::AddShapes(const Kinematics& undisturbed) {
  std::vector<GeometricScalar> scalars = lengths_;
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < vehicle_.links.size(); ++i) {
    const std::vector<Point> points = HeightPoints(vehicle_.links[i], static_cast<int>(i));
    counts.push_back(points.size());
    for (const Point& point : points)
      scalars.push_back([point](const Kinematics& pose) { return pose.Position(point, Eigen::Vector3d::UnitZ()); });
  }
  const std::vector<DesignShape> shapes = DesignShapes(multibody_, chart_, scalars);
  for (std::size_t i = 0; i < data_.held.size(); ++i) data_.held[i].shape = shapes[i];
  std::size_t height = data_.held.size();
  for (std::size_t i = 0; i < vehicle_.links.size(); ++i) {
    data_.bodies.push_back(
        BodyOf(vehicle_.links[i], static_cast<int>(i), undisturbed, std::span(shapes).subspan(height, counts[i])));
    height += counts[i];
  }
}

void Condenser::AddTyres() {
  for (const Tyre& tyre : vehicle_.tyres) {
    data_.tyres.push_back({.damping = tyre.damping, .curve = {}, .lifts_off = tyre.lifts_off});
    if (!tyre.law.IsLinear()) data_.tyres.back().curve = tyre.law;
  }
  for (std::size_t i = 0; i < vehicle_.posts.size(); ++i)
    data_.tyres[static_cast<std::size_t>(vehicle_.posts[i].tyre)].post = static_cast<int>(i);
}

void Condenser::AddBonds(const Kinematics& pose) {
  std::vector<ReducedData::Bond>& bonds = data_.bonds;
  for (const Tyre& tyre : vehicle_.tyres) {
    bonds.push_back(
        {tyre.longitudinal, tyre.longitudinal_damping, {}, pose.FootPosition(tyre, Eigen::Vector3d::UnitX()).gradient});
    bonds.push_back(
        {tyre.lateral, tyre.lateral_damping, {}, pose.FootPosition(tyre, Eigen::Vector3d::UnitY()).gradient});
  }
  for (const Bushing& bushing : vehicle_.bushings) {
    const std::array<Coordinate, 6> place = pose.BushingPlace(bushing, pose.ChildAxes(bushing));
    Scalar loss_time = bushing.loss_factor;
    const double per_factor = 1 / (2 * std::numbers::pi * bushing.loss_frequency_Hz);
    loss_time.value *= per_factor;
    loss_time.factor *= per_factor;
    for (std::size_t k = 0; k < place.size(); ++k)
      bonds.push_back({bushing.stiffness[k], bushing.damping[k], loss_time, place[k].gradient});
  }
  for (const AntiRollBar& bar : vehicle_.antiroll_bars)
    bonds.push_back({bar.stiffness, bar.damping, {}, pose.Twist(bar).gradient});
}

void Condenser::AddDampers(const Kinematics& pose) {
  for (const Damper& damper : vehicle_.dampers)
    data_.dampers.push_back({pose.LineLength(damper.line).gradient, damper.law, damper.series, damper.hydraulic});
  data_.actuators.resize(data_.coordinates, static_cast<Eigen::Index>(vehicle_.actuators.size()));
  for (std::size_t i = 0; i < vehicle_.actuators.size(); ++i)
    data_.actuators.col(static_cast<Eigen::Index>(i)) = -pose.LineLength(vehicle_.actuators[i].line).gradient;
}

void Condenser::AddSensors(const Kinematics& pose) {
  data_.sensors = vehicle_.sensors;
  SetSensorRows(pose, vehicle_, data_);
}

std::vector<int> PreloadParameters(const ReducedData::Held& held) {
  if (held.preload) return {held.preload->parameter};
  std::vector<int> indices = {held.free_length->parameter, held.law.stiffness.parameter, held.law.cubic.parameter};
  for (const SpringDescription::Knee& knee : held.law.knees)
    indices.insert(indices.end(), {knee.at.parameter, knee.rate.parameter, knee.cubic.parameter});
  for (const SpringDescription::TablePoint& point : held.law.table)
    indices.insert(indices.end(), {point.extension.parameter, point.force.parameter});
  indices.push_back(held.law.place.parameter);
  return indices;
}

std::vector<IdleElement> IdleElements(const Vehicle& vehicle, const ReducedData& data,
                                      const std::vector<HeldPlace>& places, std::span<const double> values) {
  using Kind = IdleElement::Kind;
  std::vector<IdleElement> idle;
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i)
    idle.push_back({Kind::kDamper, Tagged("fp:damper", vehicle.dampers[i].name), data.dampers[i].direction});
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i].element.starts_with("fp:stop"))
      idle.push_back({Kind::kStop, places[i].element, data.held[i].shape.gradient});
  for (std::size_t i = 0; i < vehicle.bushings.size(); ++i) {
    const Bushing& bushing = vehicle.bushings[i];
    const std::size_t first = 2 * vehicle.tyres.size() + 6 * i;
    for (std::size_t k = 0; k < 3 && !bushing.holds; ++k)
      if (bushing.stiffness[k].At(values) > 0)
        idle.push_back({Kind::kBushing, Tagged("fp:bushing", bushing.name), data.bonds[first + k].direction});
  }
  return idle;
}

std::vector<GivenForce> Weights(const Vehicle& vehicle, const ReducedVehicle& reduced, std::span<const double> values) {
  std::vector<GivenForce> weights;
  for (std::size_t i = 0; i < reduced.bodies().size(); ++i) {
    const CondensedBody& body = reduced.bodies()[i];
    const Scalar& mass = body.data().mass;
    const std::string element = Tagged("link", body.data().name);
    const int line = vehicle.links[i].line;
    weights.push_back(
        {GivenForce::Kind::kWeight, element, line, mass.At(values), {mass.parameter}, body.WeightPerMass(values)});
    for (std::size_t k = 0; k < 3 && !body.has_fixed_com(); ++k)
      weights.push_back({GivenForce::Kind::kWeight,
                         element,
                         line,
                         0,
                         {body.data().com[k].parameter},
                         mass.At(values) * body.WeightByCom(k)});
  }
  return weights;
}

/// Equilibrium: weight + sum of (spring tension) dL/ds + sum of (tyre force) d(deflection)/ds = 0.
void CheckAtRest(const Vehicle& vehicle, const ReducedVehicle& reduced, const std::vector<HeldPlace>& places) {
  const std::vector<double> values = vehicle.ParameterValues();
  StaticLoads loads{.forces = Weights(vehicle, reduced, values),
                    .holders = reduced.holders(),
                    .idle = IdleElements(vehicle, reduced.data(), places, values),
                    .links = reduced.LinkMotions(values)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ReducedData::Held& held = reduced.data().held[i];
    if (!held.IsGiven()) continue;
    std::optional<GivenForce::FreeSpring> free_spring;
    if (held.free_length) free_spring = {held.law.At(values), held.shape.value};
    loads.forces.push_back({GivenForce::Kind::kPreload, places[i].element, places[i].line, held.GivenAt(values),
                            PreloadParameters(held), held.shape.gradient, free_spring,
                            !IsStopOrGas(places[i].element)});
  }
  Diagnostics faults;
  CheckEquilibrium(vehicle, loads, faults);
  if (faults.HasErrors()) throw FaultyInput(faults);
}

}  // namespace

ReducedVehicle Condense(const Vehicle& vehicle) {
  Condenser condenser(vehicle);
  ReducedVehicle reduced(condenser.Take());
  CheckAtRest(vehicle, reduced, condenser.places());
  return reduced;
}

}  // namespace fourpost
