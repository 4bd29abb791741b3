#include "vehicles/condensed/condensed_vehicle.h"

#include <numbers>

#include "analysis/text/count_check.h"
#include "vehicles/condensed/equilibrium.h"
#include "vehicles/condensed/findings.h"
#include "vehicles/condensed/sensor_rows.h"
#include "vehicles/laws/hydraulic_oil.h"
#include "vehicles/loops/chart.h"

namespace fourpost {
namespace {

std::string Tagged(const char* tag, const std::string& name) { return std::string(tag) + " '" + name + "'"; }

/// Among the springs: their preloads are not set by a file.
bool IsStopOrGas(const std::string& element) {
  return element.starts_with("fp:stop") || element.starts_with("the gas of");
}

/// Adds the stiffness of a rate along a direction.
void AddRate(double rate, const Eigen::VectorXd& direction, Eigen::MatrixXd& matrix) {
  if (rate != 0) matrix.noalias() += (rate * direction) * direction.transpose();
}

}  // namespace

CondensedVehicle::CondensedVehicle(const Vehicle& vehicle)
    : vehicle_(vehicle), post_of_tyre_(vehicle.tyres.size(), -1) {
  Multibody multibody(vehicle);
  Chart chart(multibody);
  size_ = chart.size();
  if (size_ == 0) Refuse(kNothingMoves, {vehicle.file});
  const Kinematics undisturbed(multibody, chart.MoveTo(Eigen::VectorXd::Zero(size_)));

  std::vector<GeometricScalar> scalars;
  const auto hold = [this](const std::string& element, int line, const SpringDescription& law) -> Held& {
    Held held;
    held.element = element;
    held.source_line = line;
    held.law = law;
    return held_.emplace_back(std::move(held));
  };
  for (const Spring& spring : vehicle.springs) {
    scalars.push_back([&](const Kinematics& pose) { return pose.LineLength(spring.line); });
    Held& held = hold(spring.Element(), spring.source_line, spring.law);
    held.preload = spring.preload;
    held.free_length = spring.free_length;
  }
  for (const Tyre& tyre : vehicle.tyres) {
    scalars.push_back([&](const Kinematics& pose) { return pose.FootPosition(tyre, -Eigen::Vector3d::UnitZ()); });
    hold(Tagged("fp:tyre", tyre.name), tyre.source_line, {.stiffness = tyre.stiffness, .cubic = {}, .knees = {}})
        .preload = tyre.preload;
  }
  for (const Bushing& bushing : vehicle.bushings) {
    const Eigen::Matrix3d child_axes = undisturbed.ChildAxes(bushing);
    for (std::size_t k = 0; k < 3 && bushing.holds; ++k) {
      scalars.push_back(
          [&bushing, child_axes, k](const Kinematics& pose) { return pose.BushingPlace(bushing, child_axes)[k]; });
      hold(Tagged("fp:bushing", bushing.name), bushing.source_line,
           {.stiffness = bushing.stiffness[k], .cubic = {}, .knees = {}});
    }
  }
  const std::size_t first_height = scalars.size();
  for (std::size_t i = 0; i < vehicle.links.size(); ++i)
    for (const Point& point : CondensedBody::HeightPoints(vehicle.links[i], static_cast<int>(i)))
      scalars.push_back([point](const Kinematics& pose) { return pose.Position(point, Eigen::Vector3d::UnitZ()); });

  const std::vector<DesignShape> shapes = DesignShapes(multibody, chart, scalars);
  for (std::size_t i = 0; i < held_.size(); ++i) held_[i].shape = shapes[i];
  std::size_t height = first_height;
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const int index = static_cast<int>(i);
    const std::size_t count = CondensedBody::HeightPoints(vehicle.links[i], index).size();
    bodies_.emplace_back(vehicle.links[i], index, undisturbed, std::span(shapes).subspan(height, count));
    height += count;
  }
  for (const Damper& damper : vehicle.dampers)
    damper_directions_.push_back(undisturbed.LineLength(damper.line).gradient);
  actuators_.resize(size_, static_cast<Eigen::Index>(vehicle.actuators.size()));
  for (std::size_t i = 0; i < vehicle.actuators.size(); ++i)
    actuators_.col(static_cast<Eigen::Index>(i)) = -undisturbed.LineLength(vehicle.actuators[i].line).gradient;
  for (std::size_t i = 0; i < vehicle.posts.size(); ++i)
    post_of_tyre_[static_cast<std::size_t>(vehicle.posts[i].tyre)] = static_cast<int>(i);
  AddBonds(undisturbed);
  sensors_ = SensorRows(undisturbed, vehicle, size_);
  SolvePreloads();
}

void CondensedVehicle::AddBonds(const Kinematics& pose) {
  for (const Tyre& tyre : vehicle_.tyres) {
    bonds_.push_back(
        {tyre.longitudinal, tyre.longitudinal_damping, {}, pose.FootPosition(tyre, Eigen::Vector3d::UnitX()).gradient});
    bonds_.push_back(
        {tyre.lateral, tyre.lateral_damping, {}, pose.FootPosition(tyre, Eigen::Vector3d::UnitY()).gradient});
  }
  for (const Bushing& bushing : vehicle_.bushings) {
    const std::array<Coordinate, 6> place = pose.BushingPlace(bushing, pose.ChildAxes(bushing));
    Scalar loss_time = bushing.loss_factor;
    const double per_factor = 1 / (2 * std::numbers::pi * bushing.loss_frequency_Hz);
    loss_time.value *= per_factor;
    loss_time.factor *= per_factor;
    for (std::size_t k = 0; k < place.size(); ++k)
      bonds_.push_back({bushing.stiffness[k], bushing.damping[k], loss_time, place[k].gradient});
  }
  for (const AntiRollBar& bar : vehicle_.antiroll_bars)
    bonds_.push_back({bar.stiffness, bar.damping, {}, pose.Twist(bar).gradient});
}

double CondensedVehicle::Held::GivenAt(std::span<const double> parameters) const {
  if (preload) return preload->At(parameters);
  return -law.At(parameters).Force(free_length->At(parameters) - shape.value);
}

std::vector<int> CondensedVehicle::Held::Parameters() const {
  if (preload) return {preload->parameter};
  std::vector<int> indices = {free_length->parameter, law.stiffness.parameter, law.cubic.parameter};
  for (const SpringDescription::Knee& knee : law.knees)
    indices.insert(indices.end(), {knee.at.parameter, knee.rate.parameter, knee.cubic.parameter});
  return indices;
}

std::vector<IdleElement> CondensedVehicle::IdleElements(std::span<const double> parameters) const {
  using Kind = IdleElement::Kind;
  std::vector<IdleElement> idle;
  for (std::size_t i = 0; i < vehicle_.dampers.size(); ++i)
    idle.push_back({Kind::kDamper, Tagged("fp:damper", vehicle_.dampers[i].name), damper_directions_[i]});
  for (const Held& element : held_)
    if (element.element.starts_with("fp:stop")) idle.push_back({Kind::kStop, element.element, element.shape.gradient});
  for (std::size_t i = 0; i < vehicle_.bushings.size(); ++i) {
    const Bushing& bushing = vehicle_.bushings[i];
    const std::size_t first = 2 * vehicle_.tyres.size() + 6 * i;
    for (std::size_t k = 0; k < 3 && !bushing.holds; ++k)
      if (bushing.stiffness[k].At(parameters) > 0)
        idle.push_back({Kind::kBushing, Tagged("fp:bushing", bushing.name), bonds_[first + k].direction});
  }
  return idle;
}

/// Equilibrium: weight + sum of (spring tension) dL/ds + sum of (tyre force) d(deflection)/ds = 0.
void CondensedVehicle::SolvePreloads() {
  const std::vector<double> values = vehicle_.ParameterValues();
  StaticLoads loads{.forces = {}, .holders = {}, .idle = IdleElements(values), .links = LinkMotions(values)};
  std::vector<GivenForce>& given = loads.forces;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const CondensedBody& body = bodies_[i];
    const double mass = body.mass().At(values);
    const std::string element = Tagged("link", body.name());
    const int line = vehicle_.links[i].line;
    given.push_back(
        {GivenForce::Kind::kWeight, element, line, mass, {body.mass().parameter}, body.WeightPerMass(values)});
    for (std::size_t k = 0; k < 3 && !body.has_fixed_com(); ++k)
      given.push_back(
          {GivenForce::Kind::kWeight, element, line, 0, {body.com()[k].parameter}, mass * body.WeightByCom(k)});
  }
  Eigen::MatrixXd& holders = loads.holders;
  holders.resize(size_, 0);
  for (Held& element : held_) {
    if (element.IsGiven()) {
      std::optional<GivenForce::FreeSpring> free_spring;
      if (element.free_length) free_spring = {element.law.At(values), element.shape.value};
      given.push_back({GivenForce::Kind::kPreload, element.element, element.source_line, element.GivenAt(values),
                       element.Parameters(), element.shape.gradient, free_spring, !IsStopOrGas(element.element)});
      continue;
    }
    element.unknown = holders_++;
    holders.conservativeResize(Eigen::NoChange, holders.cols() + 1);
    holders.rightCols<1>() = element.shape.gradient;
  }
  preload_map_ = PreloadMap(holders);
  Diagnostics faults;
  CheckEquilibrium(vehicle_, loads, faults);
  if (faults.HasErrors()) throw FaultyInput(faults);
}

Eigen::VectorXd CondensedVehicle::GivenForces(std::span<const double> parameters) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(size_);
  for (const CondensedBody& body : bodies_)
    if (const double mass = body.mass().At(parameters); mass != 0) force += mass * body.WeightPerMass(parameters);
  for (const Held& element : held_)
    if (element.IsGiven()) force += element.GivenAt(parameters) * element.shape.gradient;
  return force;
}

/// Of what has its preload from equilibrium, in the design pose.
Eigen::VectorXd CondensedVehicle::HolderRates(std::span<const double> parameters) const {
  Eigen::VectorXd rates(holders_);
  for (const Held& element : held_)
    if (!element.IsGiven()) rates[element.unknown] = element.law.stiffness.At(parameters);
  return rates;
}

double CondensedVehicle::PreloadOf(const Held& element, const Eigen::VectorXd& held,
                                   std::span<const double> parameters) const {
  return element.IsGiven() ? element.GivenAt(parameters) : held[element.unknown];
}

Preloads CondensedVehicle::PreloadsAt(std::span<const double> parameters) const {
  RequireCount("CondensedVehicle", "parameters", vehicle_.parameters.size(), parameters.size());
  const Eigen::VectorXd held = preload_map_.At(GivenForces(parameters), HolderRates(parameters));
  Preloads preloads;
  std::size_t next = 0;
  for (std::size_t i = 0; i < vehicle_.springs.size(); ++i)
    preloads.spring.push_back(PreloadOf(held_[next++], held, parameters));
  for (std::size_t i = 0; i < vehicle_.tyres.size(); ++i)
    preloads.tyre.push_back(PreloadOf(held_[next++], held, parameters));
  for (const Bushing& bushing : vehicle_.bushings) {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (Eigen::Index k = 0; k < 3 && bushing.holds; ++k) force[k] = PreloadOf(held_[next++], held, parameters);
    preloads.bushing.push_back(force);
  }
  return preloads;
}

std::vector<LinkMotion> CondensedVehicle::LinkMotions(std::span<const double> parameters) const {
  RequireCount("CondensedVehicle", "parameters", vehicle_.parameters.size(), parameters.size());
  std::vector<LinkMotion> motions;
  for (const CondensedBody& body : bodies_) {
    const double mass = body.mass().At(parameters);
    const Eigen::Vector3d inertia = body.Moments(parameters);
    if (mass == 0 && inertia.isZero()) continue;
    motions.push_back(
        {body.name(), mass, inertia, body.Place(parameters), body.ComJacobian(parameters), body.spin_jacobian()});
  }
  return motions;
}

CondensedModel CondensedVehicle::At(std::span<const double> parameters) const {
  CondensedModel model = sensors_;
  model.preloads = PreloadsAt(parameters);
  const auto posts = static_cast<Eigen::Index>(vehicle_.posts.size());
  model.mass.setZero(size_, size_);
  model.damping.setZero(size_, size_);
  model.stiffness.setZero(size_, size_);
  model.post_stiffness.setZero(size_, posts);
  model.post_damping.setZero(size_, posts);
  model.actuators = actuators_;
  for (const CondensedBody& body : bodies_) body.AddTo(parameters, model.mass, model.stiffness);
  AddSprings(parameters, model);
  AddTyres(parameters, model);
  for (const Bond& bond : bonds_) {
    const double stiffness = bond.stiffness.At(parameters);
    AddRate(stiffness, bond.direction, model.stiffness);
    AddRate(bond.damping.At(parameters) + bond.loss_time.At(parameters) * stiffness, bond.direction, model.damping);
  }
  AddDashpots(parameters, model);
  AddLoadCells(parameters, model);
  return model;
}

void CondensedVehicle::AddSprings(std::span<const double> parameters, CondensedModel& model) const {
  for (std::size_t i = 0; i < vehicle_.springs.size(); ++i) {
    const SpringLaw law = vehicle_.springs[i].law.At(parameters);
    AddRate(law.Slope(0), held_[i].shape.gradient, model.stiffness);
    if (!law.IsLinear()) model.stiffenings.push_back({held_[i].shape.gradient, law});
    model.stiffness += model.preloads.spring[i] * held_[i].shape.curvature;
  }
  std::size_t next = vehicle_.springs.size() + vehicle_.tyres.size();
  for (std::size_t i = 0; i < vehicle_.bushings.size(); ++i)
    for (Eigen::Index k = 0; k < 3 && vehicle_.bushings[i].holds; ++k)
      model.stiffness += model.preloads.bushing[i][k] * held_[next++].shape.curvature;
}

void CondensedVehicle::AddTyres(std::span<const double> parameters, CondensedModel& model) const {
  for (std::size_t i = 0; i < vehicle_.tyres.size(); ++i) {
    const DesignShape& squeeze = held_[vehicle_.springs.size() + i].shape;
    const double stiffness = vehicle_.tyres[i].stiffness.At(parameters);
    const double damping = vehicle_.tyres[i].damping.At(parameters);
    AddRate(stiffness, squeeze.gradient, model.stiffness);
    AddRate(damping, squeeze.gradient, model.damping);
    model.stiffness += model.preloads.tyre[i] * squeeze.curvature;
    if (vehicle_.tyres[i].lifts_off)
      model.liftoffs.push_back({.direction = squeeze.gradient,
                                .post = post_of_tyre_[i],
                                .preload = model.preloads.tyre[i],
                                .stiffness = stiffness,
                                .damping = damping,
                                .load_cells = LoadCellsUnder(i)});
    if (post_of_tyre_[i] < 0) continue;
    model.post_stiffness.col(post_of_tyre_[i]) = -stiffness * squeeze.gradient;
    model.post_damping.col(post_of_tyre_[i]) = -damping * squeeze.gradient;
  }
}

std::vector<int> CondensedVehicle::LoadCellsUnder(std::size_t tyre) const {
  std::vector<int> cells;
  for (std::size_t i = 0; i < vehicle_.sensors.size(); ++i)
    if (vehicle_.sensors[i].type == Sensor::Type::kLoadCell && vehicle_.sensors[i].tyre == static_cast<int>(tyre))
      cells.push_back(static_cast<int>(i));
  return cells;
}

void CondensedVehicle::AddDashpots(std::span<const double> parameters, CondensedModel& model) const {
  for (std::size_t i = 0; i < vehicle_.dampers.size(); ++i) {
    const Damper& damper = vehicle_.dampers[i];
    if (damper.hydraulic) {
      AddHydraulic(damper, damper_directions_[i], parameters, model);
      continue;
    }
    CondensedModel::Dashpot dashpot{.direction = damper_directions_[i], .law = damper.law.At(parameters)};
    if (damper.series) dashpot.series = damper.series->At(parameters);
    model.dashpots.push_back(std::move(dashpot));
  }
}

void CondensedVehicle::AddHydraulic(const Damper& damper, const Eigen::VectorXd& direction,
                                    std::span<const double> parameters, CondensedModel& model) const {
  MountedHydraulicDamper law{.damper = damper.hydraulic->At(parameters), .mount = {}};
  law.damper.friction = 0;
  if (damper.series) law.mount = damper.series->At(parameters);
  const HydraulicOil::LinearShare share = HydraulicOil(law).Linear();
  AddRate(share.stiffness, direction, model.stiffness);
  model.hydraulics.push_back({.direction = direction, .law = std::move(law), .dashpot = model.dashpots.size()});
  model.dashpots.push_back({.direction = direction,
                            .law = DashpotLaw(share.rate, share.rate),
                            .series = {.stiffness = share.series, .cubic = 0, .knees = {}}});
  if (!damper.law.friction) return;
  // It acts between the ends of damper and mount.
  const DashpotDescription friction{.friction = damper.law.friction};
  model.dashpots.push_back({.direction = direction, .law = friction.At(parameters)});
}

void CondensedVehicle::AddLoadCells(std::span<const double> parameters, CondensedModel& model) const {
  for (std::size_t i = 0; i < vehicle_.sensors.size(); ++i) {
    const Sensor& sensor = vehicle_.sensors[i];
    if (sensor.type != Sensor::Type::kLoadCell) continue;
    const auto row = static_cast<Eigen::Index>(i);
    const auto tyre = static_cast<std::size_t>(sensor.tyre);
    const Eigen::VectorXd& squeeze = held_[vehicle_.springs.size() + tyre].shape.gradient;
    const double stiffness = vehicle_.tyres[tyre].stiffness.At(parameters);
    const double damping = vehicle_.tyres[tyre].damping.At(parameters);
    model.on_position.row(row) = stiffness * squeeze;
    model.on_velocity.row(row) = damping * squeeze;
    const int post = post_of_tyre_[tyre];
    if (post < 0) continue;
    model.on_post_height(row, post) = stiffness;
    model.on_post_velocity(row, post) = damping;
    model.on_post_acceleration(row, post) = sensor.wheelpan.At(parameters);
  }
}

}  // namespace fourpost
