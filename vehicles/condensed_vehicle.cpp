#include "vehicles/condensed_vehicle.h"

#include <array>

#include "analysis/diagnostics.h"
#include "vehicles/chart.h"
#include "vehicles/count_check.h"
#include "vehicles/equilibrium.h"
#include "vehicles/gravity.h"
#include "vehicles/kinematics.h"

namespace fourpost {
namespace {

/// Everything whose second derivative is needed, in one pose.
struct Gradients {
  std::vector<Eigen::VectorXd> springs;
  std::vector<Eigen::VectorXd> tyres;
  std::vector<Eigen::VectorXd> heights;
};

struct Curvatures {
  std::vector<Eigen::MatrixXd> springs;
  std::vector<Eigen::MatrixXd> tyres;
  std::vector<Eigen::MatrixXd> heights;
};

Gradients GradientsIn(const Kinematics& pose, const Vehicle& vehicle) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  Gradients gradients;
  for (const Spring& spring : vehicle.springs) gradients.springs.push_back(pose.LineLength(spring.line).gradient);
  for (const Tyre& tyre : vehicle.tyres) gradients.tyres.push_back(-pose.Position(tyre.point, up).gradient);
  for (std::size_t i = 0; i < vehicle.links.size(); ++i)
    gradients.heights.push_back(pose.Position({static_cast<int>(i), vehicle.links[i].com}, up).gradient);
  return gradients;
}

/// Adds `weight` times the gradients as column `column` of the curvatures.
void Accumulate(const std::vector<Eigen::VectorXd>& gradients, double weight, Eigen::Index column,
                std::vector<Eigen::MatrixXd>& curvatures) {
  curvatures.resize(gradients.size());
  for (std::size_t i = 0; i < gradients.size(); ++i) {
    if (curvatures[i].size() == 0) curvatures[i].setZero(gradients[i].size(), gradients[i].size());
    curvatures[i].col(column) += weight * gradients[i];
  }
}

void Symmetrise(std::vector<Eigen::MatrixXd>& curvatures) {
  for (Eigen::MatrixXd& curvature : curvatures) curvature = (0.5 * (curvature + curvature.transpose())).eval();
}

/// Second derivatives by four-point central differences of the exact gradients.
Curvatures CurvaturesOf(Multibody& multibody, Chart& chart) {
  // Truncation h^4 and rounding eps/h meet near 1e-3; both stay below 1e-12 for lengths of about a metre.
  constexpr double kStep = 1e-3;
  constexpr std::array<std::pair<double, double>, 4> kStencil = {
      {{-2, 1.0 / 12}, {-1, -8.0 / 12}, {1, 8.0 / 12}, {2, -1.0 / 12}}};
  Curvatures curvatures;
  for (Eigen::Index column = 0; column < chart.size(); ++column) {
    for (const auto& [offset, weight] : kStencil) {
      const Eigen::MatrixXd tangent = chart.MoveTo(offset * kStep * Eigen::VectorXd::Unit(chart.size(), column));
      const Gradients gradients = GradientsIn(Kinematics(multibody, tangent), multibody.vehicle());
      Accumulate(gradients.springs, weight / kStep, column, curvatures.springs);
      Accumulate(gradients.tyres, weight / kStep, column, curvatures.tyres);
      Accumulate(gradients.heights, weight / kStep, column, curvatures.heights);
    }
  }
  Symmetrise(curvatures.springs);
  Symmetrise(curvatures.tyres);
  Symmetrise(curvatures.heights);
  return curvatures;
}

/// Mass matrices per unit of each inertia component, in the order of Link::inertia.
std::array<Eigen::MatrixXd, 6> InertiaMatrices(const Eigen::MatrixXd& spin) {
  constexpr std::array<std::pair<int, int>, 6> kComponents = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  std::array<Eigen::MatrixXd, 6> matrices;
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    Eigen::Matrix3d unit = Eigen::Matrix3d::Zero();
    unit(kComponents[k].first, kComponents[k].second) = 1;
    unit(kComponents[k].second, kComponents[k].first) = 1;
    matrices[k] = spin.transpose() * unit * spin;
  }
  return matrices;
}

/// Change of an accelerometer's reading with position: the share of gravity that a tilted axis sees.
Eigen::VectorXd GravityTilt(const Kinematics& pose, const Sensor& sensor) {
  const Eigen::Vector3d axis = pose.Rotation(sensor.point.link) * sensor.axis;
  return kGravity * (pose.AngularJacobian(sensor.point.link).transpose() * axis.cross(Eigen::Vector3d::UnitZ()));
}

CondensedModel SensorRows(const Kinematics& pose, const Vehicle& vehicle, Eigen::Index n) {
  const Eigen::Index sensors = static_cast<Eigen::Index>(vehicle.sensors.size());
  const Eigen::Index posts = static_cast<Eigen::Index>(vehicle.posts.size());
  CondensedModel rows;
  rows.on_position.setZero(sensors, n);
  rows.on_velocity.setZero(sensors, n);
  rows.on_acceleration.setZero(sensors, n);
  rows.on_post_height.setZero(sensors, posts);
  rows.on_post_velocity.setZero(sensors, posts);
  for (Eigen::Index i = 0; i < sensors; ++i) {
    const Sensor& sensor = vehicle.sensors[static_cast<std::size_t>(i)];
    switch (sensor.type) {
      case Sensor::Type::kAccelerometer:
        rows.on_acceleration.row(i) =
            pose.Position(sensor.point, pose.Rotation(sensor.point.link) * sensor.axis).gradient;
        rows.on_position.row(i) = GravityTilt(pose, sensor);
        break;
      case Sensor::Type::kDisplacement:
        rows.on_position.row(i) = pose.Position(sensor.point, pose.Rotation(sensor.point.link) * sensor.axis).gradient;
        break;
      case Sensor::Type::kStrut: rows.on_position.row(i) = pose.LineLength(sensor.line).gradient; break;
      case Sensor::Type::kLoadCell: break;
    }
  }
  return rows;
}

Diagnostics RigidityFault(const Vehicle& vehicle) {
  Diagnostics faults;
  faults.Error(
      vehicle.file, 0,
      "nothing can move: the vehicle has no joint but fixed ones, or fp:rod and fp:ball take all freedom away");
  return faults;
}

}  // namespace

CondensedVehicle::CondensedVehicle(const Vehicle& vehicle)
    : parameter_count_(vehicle.parameters.size()), post_count_(static_cast<Eigen::Index>(vehicle.posts.size())) {
  Multibody multibody(vehicle);
  Chart chart(multibody);
  size_ = chart.size();
  if (size_ == 0) throw FaultyInput(RigidityFault(vehicle));
  const Curvatures curvatures = CurvaturesOf(multibody, chart);
  const Kinematics pose(multibody, chart.MoveTo(Eigen::VectorXd::Zero(size_)));
  const Gradients gradients = GradientsIn(pose, vehicle);

  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const Link& link = vehicle.links[i];
    const int index = static_cast<int>(i);
    const Eigen::MatrixXd com = pose.PointJacobian({index, link.com});
    const Eigen::MatrixXd spin = pose.Rotation(index).transpose() * pose.AngularJacobian(index);
    bodies_.push_back({link.name, link.mass, link.inertia, pose.Location({index, link.com}), com, spin,
                       com.transpose() * com, InertiaMatrices(spin), kGravity * gradients.heights[i],
                       kGravity * curvatures.heights[i]});
  }
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i)
    springs_.push_back(
        {vehicle.springs[i].stiffness, gradients.springs[i], curvatures.springs[i], vehicle.springs[i].preload});
  for (std::size_t i = 0; i < vehicle.tyres.size(); ++i)
    tyres_.push_back({{vehicle.tyres[i].stiffness, gradients.tyres[i], curvatures.tyres[i], vehicle.tyres[i].preload},
                      vehicle.tyres[i].damping});
  for (std::size_t i = 0; i < vehicle.posts.size(); ++i)
    tyres_[static_cast<std::size_t>(vehicle.posts[i].tyre)].post = static_cast<int>(i);
  for (const Damper& damper : vehicle.dampers)
    dampers_.push_back(
        {pose.LineLength(damper.line).gradient, damper.compression, damper.rebound, damper.series_stiffness});
  sensors_ = SensorRows(pose, vehicle, size_);
  for (std::size_t i = 0; i < vehicle.sensors.size(); ++i)
    if (vehicle.sensors[i].type == Sensor::Type::kLoadCell)
      load_cells_.emplace_back(static_cast<Eigen::Index>(i), vehicle.sensors[i].tyre);
  SolvePreloads(vehicle);
}

/// Equilibrium: weight + sum of (spring tension) dL/ds + sum of (tyre force) d(compression)/ds = 0.
void CondensedVehicle::SolvePreloads(const Vehicle& vehicle) {
  std::vector<GivenForce> given;
  std::vector<Eigen::VectorXd> held;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    given.push_back({GivenForce::Kind::kWeight, "link '" + bodies_[i].name + "'", vehicle.links[i].line,
                     bodies_[i].mass, bodies_[i].weight});
  const auto sort = [&](Stiff& element, const std::string& name, int line) {
    if (element.preload) {
      given.push_back({GivenForce::Kind::kPreload, name, line, *element.preload, element.direction});
      return;
    }
    element.unknown = static_cast<int>(held.size());
    held.push_back(element.direction);
  };
  for (std::size_t i = 0; i < springs_.size(); ++i)
    sort(springs_[i], "fp:spring '" + vehicle.springs[i].name + "'", vehicle.springs[i].source_line);
  for (std::size_t i = 0; i < tyres_.size(); ++i)
    sort(tyres_[i], "fp:tyre '" + vehicle.tyres[i].name + "'", vehicle.tyres[i].source_line);
  Eigen::MatrixXd holders(size_, static_cast<Eigen::Index>(held.size()));
  for (std::size_t i = 0; i < held.size(); ++i) holders.col(static_cast<Eigen::Index>(i)) = held[i];
  preload_map_ = PreloadMap(holders);
  Diagnostics faults;
  CheckEquilibrium(vehicle, given, holders, faults);
  if (faults.HasErrors()) throw FaultyInput(faults);
}

Eigen::VectorXd CondensedVehicle::Weight(std::span<const double> parameters) const {
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(size_);
  for (const Body& body : bodies_) weight += body.mass.At(parameters) * body.weight;
  for (const Stiff& spring : springs_)
    if (spring.preload) weight += spring.preload->At(parameters) * spring.direction;
  for (const Tyred& tyre : tyres_)
    if (tyre.preload) weight += tyre.preload->At(parameters) * tyre.direction;
  return weight;
}

Preloads CondensedVehicle::PreloadsAt(std::span<const double> parameters) const {
  RequireCount("CondensedVehicle", "parameters", parameter_count_, parameters.size());
  const Eigen::VectorXd held = preload_map_ * Weight(parameters);
  Preloads preloads;
  for (const Stiff& spring : springs_)
    preloads.spring.push_back(spring.preload ? spring.preload->At(parameters) : held[spring.unknown]);
  for (const Tyred& tyre : tyres_)
    preloads.tyre.push_back(tyre.preload ? tyre.preload->At(parameters) : held[tyre.unknown]);
  return preloads;
}

std::vector<CondensedVehicle::LinkMotion> CondensedVehicle::LinkMotions(std::span<const double> parameters) const {
  RequireCount("CondensedVehicle", "parameters", parameter_count_, parameters.size());
  std::vector<LinkMotion> motions;
  for (const Body& body : bodies_) {
    const double mass = body.mass.At(parameters);
    const Eigen::Vector3d inertia(body.inertia[0].At(parameters), body.inertia[1].At(parameters),
                                  body.inertia[2].At(parameters));
    if (mass == 0 && inertia.isZero()) continue;
    motions.push_back({body.name, mass, inertia, body.com, body.com_jacobian, body.spin_jacobian});
  }
  return motions;
}

CondensedModel CondensedVehicle::At(std::span<const double> parameters) const {
  RequireCount("CondensedVehicle", "parameters", parameter_count_, parameters.size());
  CondensedModel model = sensors_;
  model.preloads = PreloadsAt(parameters);
  model.mass.setZero(size_, size_);
  model.damping.setZero(size_, size_);
  model.stiffness.setZero(size_, size_);
  model.post_stiffness.setZero(size_, post_count_);
  model.post_damping.setZero(size_, post_count_);

  for (const Body& body : bodies_) {
    const double mass = body.mass.At(parameters);
    if (mass != 0) {
      model.mass += mass * body.mass_matrix;
      model.stiffness += mass * body.weight_stiffness;
    }
    for (std::size_t k = 0; k < body.inertia.size(); ++k)
      if (const double inertia = body.inertia[k].At(parameters); inertia != 0)
        model.mass += inertia * body.inertia_matrix[k];
  }
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    const Stiff& spring = springs_[i];
    model.stiffness += spring.stiffness.At(parameters) * spring.direction * spring.direction.transpose() +
                       model.preloads.spring[i] * spring.curvature;
  }
  for (std::size_t i = 0; i < tyres_.size(); ++i) {
    const Tyred& tyre = tyres_[i];
    const double stiffness = tyre.stiffness.At(parameters);
    const double damping = tyre.damping.At(parameters);
    model.stiffness +=
        stiffness * tyre.direction * tyre.direction.transpose() + model.preloads.tyre[i] * tyre.curvature;
    model.damping += damping * tyre.direction * tyre.direction.transpose();
    if (tyre.post < 0) continue;
    model.post_stiffness.col(tyre.post) = -stiffness * tyre.direction;
    model.post_damping.col(tyre.post) = -damping * tyre.direction;
  }
  for (const Damped& damper : dampers_)
    model.dashpots.push_back({damper.direction,
                              {damper.compression.At(parameters), damper.rebound.At(parameters)},
                              damper.series_stiffness ? damper.series_stiffness->At(parameters) : 0});
  for (const auto& [sensor, index] : load_cells_) {
    const Tyred& tyre = tyres_[static_cast<std::size_t>(index)];
    const double stiffness = tyre.stiffness.At(parameters);
    const double damping = tyre.damping.At(parameters);
    model.on_position.row(sensor) = stiffness * tyre.direction;
    model.on_velocity.row(sensor) = damping * tyre.direction;
    if (tyre.post < 0) continue;
    model.on_post_height(sensor, tyre.post) = stiffness;
    model.on_post_velocity(sensor, tyre.post) = damping;
  }
  return model;
}

}  // namespace fourpost
