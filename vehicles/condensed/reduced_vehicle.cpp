#include "vehicles/condensed/reduced_vehicle.h"

#include <optional>
#include <utility>

#include "analysis/text/count_check.h"
#include "vehicles/laws/hydraulic_oil.h"

namespace fourpost {
namespace {

/// Adds the stiffness of a rate along a direction.
void AddRate(double rate, const Eigen::VectorXd& direction, Eigen::MatrixXd& matrix) {
  if (rate != 0) matrix.noalias() += (rate * direction) * direction.transpose();
}

Eigen::MatrixXd HoldersOf(const ReducedData& data) {
  Eigen::MatrixXd holders(data.coordinates, 0);
  for (const ReducedData::Held& element : data.held) {
    if (element.IsGiven()) continue;
    holders.conservativeResize(Eigen::NoChange, holders.cols() + 1);
    holders.rightCols<1>() = element.shape.gradient;
  }
  return holders;
}

}  // namespace

double ReducedData::Held::GivenAt(std::span<const double> parameters) const {
  if (preload) return preload->At(parameters);
  return -law.At(parameters).Force(free_length->At(parameters) - shape.value);
}

ReducedVehicle::ReducedVehicle(ReducedData data)
    : data_(std::move(data)), holders_(HoldersOf(data_)), preload_map_(holders_) {
  for (const ReducedData::Body& body : data_.bodies) bodies_.emplace_back(body);
}

void ReducedVehicle::RequireAll(std::span<const double> parameters) const {
  RequireCount("ReducedVehicle", "parameters", data_.parameters.size(), parameters.size());
}

Eigen::VectorXd ReducedVehicle::GivenForces(std::span<const double> parameters) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(data_.coordinates);
  for (const CondensedBody& body : bodies_)
    if (const double mass = body.data().mass.At(parameters); mass != 0) force += mass * body.WeightPerMass(parameters);
  for (const ReducedData::Held& element : data_.held)
    if (element.IsGiven()) force += element.GivenAt(parameters) * element.shape.gradient;
  return force;
}

/// The rate that changes with the load; nullptr: it does not.
const TyreDescription* ReducedVehicle::CurveOf(std::size_t held) const {
  if (held < data_.springs || held >= data_.springs + data_.tyres.size()) return nullptr;
  const std::optional<TyreDescription>& curve = data_.tyres[held - data_.springs].curve;
  return curve ? &*curve : nullptr;
}

/// Of what has its preload from equilibrium, in the design pose; tyres under these preloads.
HolderTangents ReducedVehicle::TangentsAt(std::span<const double> parameters, const Eigen::VectorXd& preloads) const {
  HolderTangents tangents{Eigen::VectorXd(holders_.cols()), {}};
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < data_.held.size(); ++i) {
    if (data_.held[i].IsGiven()) continue;
    const Eigen::Index k = next++;
    const TyreDescription* curve = CurveOf(i);
    if (!curve) {
      tangents.rates[k] = data_.held[i].law.RateAt(parameters);
      continue;
    }
    const LoadedTyre tyre = curve->At(parameters).Under(preloads[k]);
    if (tangents.slack.size() == 0) tangents.slack.setZero(preloads.size());
    tangents.rates[k] = tyre.Rate(0);
    tangents.slack[k] = preloads[k] + tyre.Rate(0) * tyre.Liftoff();
  }
  return tangents;
}

std::vector<double> ReducedVehicle::HeldPreloads(std::span<const double> parameters) const {
  const Eigen::VectorXd set = preload_map_.At(
      GivenForces(parameters), [&](const Eigen::VectorXd& preloads) { return TangentsAt(parameters, preloads); });
  std::vector<double> preloads;
  Eigen::Index next = 0;
  for (const ReducedData::Held& element : data_.held)
    preloads.push_back(element.IsGiven() ? element.GivenAt(parameters) : set[next++]);
  return preloads;
}

Preloads ReducedVehicle::PreloadsAt(std::span<const double> parameters) const {
  RequireAll(parameters);
  const std::vector<double> held = HeldPreloads(parameters);
  const auto tyres = held.begin() + static_cast<std::ptrdiff_t>(data_.springs);
  auto next = tyres + static_cast<std::ptrdiff_t>(data_.tyres.size());
  Preloads preloads{.spring = {held.begin(), tyres}, .tyre = {tyres, next}, .bushing = {}};
  for (const bool holds : data_.bushings) {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (Eigen::Index k = 0; k < 3 && holds; ++k) force[k] = *next++;
    preloads.bushing.push_back(force);
  }
  return preloads;
}

std::vector<LinkMotion> ReducedVehicle::LinkMotions(std::span<const double> parameters) const {
  RequireAll(parameters);
  std::vector<LinkMotion> motions;
  for (const CondensedBody& body : bodies_) {
    const double mass = body.data().mass.At(parameters);
    const Eigen::Vector3d inertia = body.Moments(parameters);
    if (mass == 0 && inertia.isZero()) continue;
    motions.push_back({body.data().name, mass, inertia, body.Place(parameters), body.ComJacobian(parameters),
                       body.data().spin_jacobian});
  }
  return motions;
}

CondensedModel ReducedVehicle::At(std::span<const double> parameters) const {
  CondensedModel model;
  model.preloads = PreloadsAt(parameters);
  const Eigen::Index n = data_.coordinates;
  const auto posts = static_cast<Eigen::Index>(data_.posts.size());
  const auto sensors = static_cast<Eigen::Index>(data_.sensors.size());
  model.on_position = data_.on_position;
  model.on_velocity = data_.on_velocity;
  model.on_acceleration = data_.on_acceleration;
  model.on_post_height.setZero(sensors, posts);
  model.on_post_velocity.setZero(sensors, posts);
  model.on_post_acceleration.setZero(sensors, posts);
  model.mass.setZero(n, n);
  model.damping.setZero(n, n);
  model.stiffness.setZero(n, n);
  model.post_stiffness.setZero(n, posts);
  model.post_damping.setZero(n, posts);
  model.actuators = data_.actuators;
  for (const CondensedBody& body : bodies_) body.AddTo(parameters, model.mass, model.stiffness);
  AddSprings(parameters, model);
  AddTyres(parameters, model);
  for (const ReducedData::Bond& bond : data_.bonds) {
    const double stiffness = bond.stiffness.At(parameters);
    AddRate(stiffness, bond.direction, model.stiffness);
    AddRate(bond.damping.At(parameters) + bond.loss_time.At(parameters) * stiffness, bond.direction, model.damping);
  }
  AddDashpots(parameters, model);
  AddLoadCells(parameters, model);
  return model;
}

void ReducedVehicle::AddSprings(std::span<const double> parameters, CondensedModel& model) const {
  for (std::size_t i = 0; i < data_.springs; ++i) {
    const DesignShape& length = data_.held[i].shape;
    const SpringLaw law = data_.held[i].law.At(parameters);
    AddRate(law.Slope(0), length.gradient, model.stiffness);
    if (!law.IsLinear()) model.stiffenings.push_back({length.gradient, law});
    model.stiffness += model.preloads.spring[i] * length.curvature;
  }
  std::size_t next = data_.springs + data_.tyres.size();
  for (std::size_t i = 0; i < data_.bushings.size(); ++i)
    for (Eigen::Index k = 0; k < 3 && data_.bushings[i]; ++k)
      model.stiffness += model.preloads.bushing[i][k] * data_.held[next++].shape.curvature;
}

void ReducedVehicle::AddTyres(std::span<const double> parameters, CondensedModel& model) const {
  for (std::size_t i = 0; i < data_.tyres.size(); ++i) {
    const ReducedData::Tyre& tyre = data_.tyres[i];
    const DesignShape& squeeze = data_.held[data_.springs + i].shape;
    const double stiffness = TyreRate(i, parameters, model.preloads);
    const double damping = tyre.damping.At(parameters);
    AddRate(stiffness, squeeze.gradient, model.stiffness);
    AddRate(damping, squeeze.gradient, model.damping);
    model.stiffness += model.preloads.tyre[i] * squeeze.curvature;
    if (tyre.curve)
      model.curved_tyres.push_back({.direction = squeeze.gradient,
                                    .post = tyre.post,
                                    .law = tyre.curve->At(parameters).Under(model.preloads.tyre[i]),
                                    .damping = damping,
                                    .load_cells = LoadCellsUnder(i)});
    else if (tyre.lifts_off)
      model.liftoffs.push_back({.direction = squeeze.gradient,
                                .post = tyre.post,
                                .preload = model.preloads.tyre[i],
                                .stiffness = stiffness,
                                .damping = damping,
                                .load_cells = LoadCellsUnder(i)});
    if (tyre.post < 0) continue;
    model.post_stiffness.col(tyre.post) = -stiffness * squeeze.gradient;
    model.post_damping.col(tyre.post) = -damping * squeeze.gradient;
  }
}

/// In the design pose [N/m].
double ReducedVehicle::TyreRate(std::size_t tyre, std::span<const double> parameters, const Preloads& preloads) const {
  const std::optional<TyreDescription>& curve = data_.tyres[tyre].curve;
  if (curve) return curve->RateAt(parameters, preloads.tyre[tyre]);
  return data_.held[data_.springs + tyre].law.stiffness.At(parameters);
}

std::vector<int> ReducedVehicle::LoadCellsUnder(std::size_t tyre) const {
  std::vector<int> cells;
  for (std::size_t i = 0; i < data_.sensors.size(); ++i)
    if (data_.sensors[i].type == Sensor::Type::kLoadCell && data_.sensors[i].tyre == static_cast<int>(tyre))
      cells.push_back(static_cast<int>(i));
  return cells;
}

void ReducedVehicle::AddDashpots(std::span<const double> parameters, CondensedModel& model) const {
  for (const ReducedData::Damper& damper : data_.dampers) {
    if (const std::optional<DahlFriction> friction = damper.law.StickingAt(parameters))
      model.rubbings.push_back({damper.direction, *friction});
    if (damper.hydraulic) {
      AddHydraulic(damper, parameters, model);
      continue;
    }
    CondensedModel::Dashpot dashpot{.direction = damper.direction, .law = damper.law.At(parameters)};
    if (damper.series) dashpot.series = damper.series->At(parameters);
    model.dashpots.push_back(std::move(dashpot));
  }
}

void ReducedVehicle::AddHydraulic(const ReducedData::Damper& damper, std::span<const double> parameters,
                                  CondensedModel& model) const {
  const Eigen::VectorXd& direction = damper.direction;
  MountedHydraulicDamper law{.damper = damper.hydraulic->At(parameters), .mount = {}};
  law.damper.friction = 0;
  if (damper.series) law.mount = damper.series->At(parameters);
  const HydraulicOil::LinearShare share = HydraulicOil(law).Linear();
  AddRate(share.stiffness, direction, model.stiffness);
  model.hydraulics.push_back({.direction = direction, .law = std::move(law), .dashpot = model.dashpots.size()});
  model.dashpots.push_back({.direction = direction,
                            .law = DashpotLaw(share.rate, share.rate),
                            .series = {.stiffness = share.series, .cubic = 0, .knees = {}}});
  if (!damper.law.friction || damper.law.Sticks()) return;
  // It acts between the ends of damper and mount.
  const DashpotDescription friction{.friction = damper.law.friction};
  model.dashpots.push_back({.direction = direction, .law = friction.At(parameters)});
}

void ReducedVehicle::AddLoadCells(std::span<const double> parameters, CondensedModel& model) const {
  for (std::size_t i = 0; i < data_.sensors.size(); ++i) {
    const Sensor& sensor = data_.sensors[i];
    if (sensor.type != Sensor::Type::kLoadCell) continue;
    const auto row = static_cast<Eigen::Index>(i);
    const auto place = static_cast<std::size_t>(sensor.tyre);
    const ReducedData::Tyre& tyre = data_.tyres[place];
    const Eigen::VectorXd& squeeze = data_.held[data_.springs + place].shape.gradient;
    const double stiffness = TyreRate(place, parameters, model.preloads);
    const double damping = tyre.damping.At(parameters);
    model.on_position.row(row) = stiffness * squeeze;
    model.on_velocity.row(row) = damping * squeeze;
    if (tyre.post < 0) continue;
    model.on_post_height(row, tyre.post) = stiffness;
    model.on_post_velocity(row, tyre.post) = damping;
    model.on_post_acceleration(row, tyre.post) = sensor.wheelpan.At(parameters);
  }
}

}  // namespace fourpost
