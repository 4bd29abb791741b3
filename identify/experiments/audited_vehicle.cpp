#include "identify/experiments/audited_vehicle.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

/// Of a sensor that is between two points nothing changes.
constexpr double kShift = 1e-3;

bool HasPlace(const Sensor& sensor) {
  return sensor.type == Sensor::Type::kAccelerometer || sensor.type == Sensor::Type::kDisplacement;
}

Device DeviceOf(Sensor::Type type) {
  switch (type) {
    case Sensor::Type::kAccelerometer: return Device::kAccelerometers;
    case Sensor::Type::kDisplacement: return Device::kDisplacements;
    case Sensor::Type::kStrut: return Device::kStruts;
    case Sensor::Type::kGyro: return Device::kGyros;
    case Sensor::Type::kLoadCell: break;
  }
  return Device::kLoadCells;
}

/// What a sensor reads over what its kind is normalised by.
Eigen::RowVectorXd MotionOf(const CondensedModel& model, Sensor::Type type, Eigen::Index row) {
  switch (type) {
    case Sensor::Type::kAccelerometer: return model.on_acceleration.row(row);
    case Sensor::Type::kGyro: return model.on_velocity.row(row);
    default: return model.on_position.row(row);
  }
}

/// With all sensors moved along an axis of their links.
CondensedModel Shifted(Vehicle vehicle, int axis) {
  for (Sensor& sensor : vehicle.sensors)
    if (HasPlace(sensor)) sensor.point.xyz[axis] += kShift;
  const std::vector<double> values = vehicle.ParameterValues();
  return CondensedVehicle(vehicle).At(values);
}

/// Vertical stiffness of tyres alone.
Eigen::MatrixXd TyreStiffness(const Vehicle& vehicle, const std::vector<AuditedTyre>& tyres,
                              const std::vector<double>& values, const CondensedModel& model) {
  const Eigen::Index n = model.mass.rows();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t t = 0; t < tyres.size(); ++t)
    stiffness +=
        vehicle.tyres[t].law.RateAt(values, model.preloads.tyre[t]) * tyres[t].foot.transpose() * tyres[t].foot;
  return stiffness;
}

/// The coordinates' velocity at which all links move as one body: vertical motion first, then turns and the rest as far
/// as the vehicle can.
Eigen::VectorXd WholeMotion(const std::vector<LinkMotion>& links, const Eigen::Vector3d& velocity,
                            const Eigen::Vector3d& turn, const Eigen::Vector3d& axis) {
  constexpr double kTurn = 1e-2;
  constexpr double kAside = 1e-7;
  const Eigen::Index n = links.front().com_jacobian.cols();
  Eigen::MatrixXd rows(6 * static_cast<Eigen::Index>(links.size()), n);
  Eigen::VectorXd wanted(rows.rows());
  Eigen::Index next = 0;
  for (const LinkMotion& link : links) {
    const Eigen::Vector3d moves = velocity + turn.cross(link.com - axis);
    rows.middleRows(next, 3) = link.com_jacobian;
    wanted.segment(next, 3) = moves;
    rows.middleRows(next, 2) *= kAside;
    wanted.segment(next, 2) *= kAside;
    rows.middleRows(next + 3, 3) = kTurn * link.spin_jacobian;
    wanted.segment(next + 3, 3) = kTurn * turn;
    next += 6;
  }
  return LeastNorm(rows, 1e-11).Solve(wanted);
}

bool IsWithoutInnerForces(const CondensedModel& model, const Eigen::MatrixXd& tyres, const Eigen::VectorXd& motion) {
  constexpr double kStill = 1e-6;
  // Gravity on a tilted car is a few per cent of what tyres do, a spring that gives way far more.
  constexpr double kGravity = 0.05;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots)
    if (std::abs(dashpot.direction.dot(motion)) > kStill) return false;
  for (const CondensedModel::Rubbing& friction : model.rubbings)
    if (std::abs(friction.direction.dot(motion)) > kStill) return false;
  const double of_tyres = motion.dot(tyres * motion);
  return of_tyres > 0 && std::abs(motion.dot(model.stiffness * motion) - of_tyres) < kGravity * of_tyres;
}

/// Roll moves masses sideways, against forces at the ground; a vehicle without such motion does not know them.
bool LacksSideways(const std::vector<LinkMotion>& links, const Eigen::Vector3d& turn, double axis_height,
                   const Eigen::VectorXd& motion) {
  constexpr double kSame = 1e-6;
  for (const LinkMotion& link : links)
    if (link.mass > 0 && std::abs(link.com_jacobian.row(1) * motion + turn.x() * (link.com.z() - axis_height)) > kSame)
      return true;
  return false;
}

Eigen::Vector3d CentreOfMass(const std::vector<LinkMotion>& links) {
  double mass = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const LinkMotion& link : links) {
    mass += link.mass;
    moment += link.mass * link.com;
  }
  return moment / mass;
}

/// Pitch is about the centre of mass, so that it needs no motion along the car, which no sensor sees and free wheels
/// allow; roll about the ground below it, where wheels do not slide.
struct NamedMotion {
  const char* name;
  Eigen::Vector3d velocity;
  Eigen::Vector3d turn;
  Eigen::Vector3d axis;
};

std::vector<std::pair<std::string, Eigen::VectorXd>> WholeMotions(const CondensedVehicle& vehicle,
                                                                  const CondensedModel& model,
                                                                  const Eigen::MatrixXd& tyres,
                                                                  const std::vector<double>& values, double ground) {
  const std::vector<LinkMotion> links = vehicle.LinkMotions(values);
  std::vector<std::pair<std::string, Eigen::VectorXd>> motions;
  if (links.empty()) return motions;
  const Eigen::Vector3d centre = CentreOfMass(links);
  Eigen::MatrixXd found(vehicle.size(), 0);
  for (const NamedMotion& one :
       {NamedMotion{"heave", {0, 0, 1}, {0, 0, 0}, centre}, NamedMotion{"pitch", {0, 0, 0}, {0, 1, 0}, centre},
        NamedMotion{"roll", {0, 0, 0}, {1, 0, 0}, {centre.x(), centre.y(), ground}}}) {
    const Eigen::VectorXd motion = WholeMotion(links, one.velocity, one.turn, one.axis);
    if (!IsWithoutInnerForces(model, tyres, motion) || LacksSideways(links, one.turn, one.axis.z(), motion)) continue;
    Eigen::MatrixXd with(found.rows(), found.cols() + 1);
    with << found, motion;
    if (LeastNorm(with, 1e-6).rank() < with.cols()) continue;
    found = with;
    motions.emplace_back(one.name, motion);
  }
  return motions;
}

/// Of the first tyre [m], with the axes of links along those of the ground, as they are in the design pose.
double FootHeight(const Vehicle& vehicle, const std::vector<LinkMotion>& links, const std::vector<double>& values) {
  const Tyre& tyre = vehicle.tyres.front();
  const Link& wheel = vehicle.links[static_cast<std::size_t>(tyre.point.link)];
  const auto found =
      std::find_if(links.begin(), links.end(), [&](const LinkMotion& link) { return link.name == wheel.name; });
  if (found == links.end()) return 0;
  return found->com.z() + tyre.point.xyz.z() - wheel.ComAt(values).z() - tyre.radius;
}

/// What parameters change of the whole car.
struct WholeCar {
  /// One per motion.
  std::vector<Eigen::RowVectorXd> inertia;
  std::vector<Eigen::RowVectorXd> gravity;
  Eigen::VectorXd loads;
};

WholeCar WholeCarAt(const CondensedVehicle& vehicle, const std::vector<AuditedTyre>& tyres,
                    const std::vector<std::pair<std::string, Eigen::VectorXd>>& motions,
                    const std::vector<double>& values) {
  const CondensedModel model = vehicle.At(values);
  const Eigen::MatrixXd rest = model.stiffness - TyreStiffness(vehicle.vehicle(), tyres, values, model);
  WholeCar whole;
  for (const auto& [name, motion] : motions) {
    whole.inertia.push_back(motion.transpose() * model.mass);
    whole.gravity.push_back(motion.transpose() * rest);
  }
  whole.loads = Eigen::Map<const Eigen::VectorXd>(model.preloads.tyre.data(),
                                                  static_cast<Eigen::Index>(model.preloads.tyre.size()));
  return whole;
}

/// How far a parameter may be from its value; 0: it is known.
double ReachOf(const Parameter& parameter) {
  return parameter.prior_sd.value_or(0.5 * std::max(0.0, parameter.upper - parameter.lower));
}

}  // namespace

AuditedVehicle::AuditedVehicle(const Subject& subject)
    : vehicle_(subject.vehicle()), model_(subject.Condensed()->At(subject.vehicle().ParameterValues())) {
  audited_.car.coordinates = subject.Condensed()->size();
  AddSensors(subject);
  AddTyres();
  AddInertia(subject);
  AddWheelpans();
}

void AuditedVehicle::AddSensors(const Subject&) {
  std::vector<CondensedModel> shifted;
  if (std::any_of(vehicle_.sensors.begin(), vehicle_.sensors.end(), HasPlace))
    for (int axis = 0; axis < 3; ++axis) shifted.push_back(Shifted(vehicle_, axis));
  for (std::size_t s = 0; s < vehicle_.sensors.size(); ++s) {
    const Sensor& sensor = vehicle_.sensors[s];
    const auto row = static_cast<Eigen::Index>(s);
    if (sensor.type == Sensor::Type::kLoadCell) {
      place_of_sensor_.push_back(sensor.tyre);
      continue;
    }
    AuditedSensor audited{.name = sensor.name,
                          .device = DeviceOf(sensor.type),
                          .motion = MotionOf(model_, sensor.type, row),
                          .tilt = Eigen::RowVectorXd::Zero(audited_.car.coordinates)};
    if (sensor.type == Sensor::Type::kAccelerometer) audited.tilt = model_.on_position.row(row);
    for (std::size_t axis = 0; axis < 3 && HasPlace(sensor); ++axis) {
      const Eigen::RowVectorXd moved = MotionOf(shifted[axis], sensor.type, row);
      audited.motion_by_place[axis] = (moved - audited.motion) / kShift;
    }
    place_of_sensor_.push_back(static_cast<int>(audited_.car.sensors.size()));
    audited_.car.sensors.push_back(std::move(audited));
  }
}

void AuditedVehicle::AddTyres() {
  const std::vector<double> values = vehicle_.ParameterValues();
  for (std::size_t t = 0; t < vehicle_.tyres.size(); ++t) {
    AuditedTyre tyre{.name = vehicle_.tyres[t].name};
    const auto post = std::find_if(vehicle_.posts.begin(), vehicle_.posts.end(),
                                   [&](const Post& one) { return one.tyre == static_cast<int>(t); });
    const double rate = vehicle_.tyres[t].law.RateAt(values, model_.preloads.tyre[t]);
    // Without a post, or without a rate, there is no audit of forces.
    if (post == vehicle_.posts.end() || !(rate > 0)) {
      audited_.car.tyres.clear();
      return;
    }
    tyre.post = static_cast<std::size_t>(post - vehicle_.posts.begin());
    tyre.foot = model_.post_stiffness.col(static_cast<Eigen::Index>(tyre.post)).transpose() / rate;
    tyre.compliance = 1 / rate;
    audited_.car.tyres.push_back(std::move(tyre));
  }
}

void AuditedVehicle::AddInertia(const Subject& subject) {
  std::vector<AuditedTyre>& tyres = audited_.car.tyres;
  if (tyres.empty()) return;
  const CondensedVehicle& vehicle = *subject.Condensed();
  std::vector<double> values = vehicle_.ParameterValues();
  const double ground = FootHeight(vehicle_, vehicle.LinkMotions(values), values);
  const std::vector<std::pair<std::string, Eigen::VectorXd>> motions =
      WholeMotions(vehicle, model_, TyreStiffness(vehicle_, tyres, values, model_), values, ground);
  if (motions.empty() || motions.front().first != "heave") return;
  const WholeCar here = WholeCarAt(vehicle, tyres, motions, values);
  AuditedBalance balance{.inertia = here.inertia.front(), .gravity = here.gravity.front()};
  balance.others.assign(here.inertia.begin() + 1, here.inertia.end());
  balance.lever.resize(static_cast<Eigen::Index>(tyres.size()));
  for (std::size_t t = 0; t < tyres.size(); ++t)
    balance.lever[static_cast<Eigen::Index>(t)] = tyres[t].foot.dot(motions.front().second.transpose());
  weight_.modelled = here.loads.sum();
  std::vector<double> reaches;
  std::vector<double> slopes;
  for (std::size_t j = 0; j < vehicle_.parameters.size(); ++j) {
    const double reach = ReachOf(vehicle_.parameters[j]);
    if (!(reach > 0)) continue;
    const double step = 1e-4 * reach;
    std::vector<double> moved = values;
    moved[j] += step;
    const WholeCar there = WholeCarAt(vehicle, tyres, motions, moved);
    const double change = std::max(std::abs(there.loads.sum() / here.loads.sum() - 1),
                                   (there.inertia.front() - balance.inertia).norm() / balance.inertia.norm());
    // Rounding changes them by less.
    if (change < 1e-10) continue;
    reaches.push_back(reach);
    slopes.push_back((there.loads.sum() - here.loads.sum()) / step);
    balance.inertia_slope.push_back((there.inertia.front() - balance.inertia) / step);
    balance.gravity_slope.push_back((there.gravity.front() - balance.gravity) / step);
  }
  audited_.car.balance = std::move(balance);
  audited_.car.reach = Eigen::Map<const Eigen::VectorXd>(reaches.data(), static_cast<Eigen::Index>(reaches.size()));
  weight_.slope = Eigen::Map<const Eigen::VectorXd>(slopes.data(), static_cast<Eigen::Index>(slopes.size()));
}

void AuditedVehicle::AddWheelpans() {
  wheelpan_slopes_.assign(vehicle_.sensors.size(), {});
  const std::vector<double> values = vehicle_.ParameterValues();
  for (std::size_t j = 0; j < vehicle_.parameters.size(); ++j) {
    const double reach = ReachOf(vehicle_.parameters[j]);
    std::vector<double> moved = values;
    moved[j] += reach;
    const auto change = [&](const Sensor& sensor) {
      return reach > 0 ? (sensor.wheelpan.At(moved) - sensor.wheelpan.At(values)) / reach : 0.0;
    };
    if (std::all_of(vehicle_.sensors.begin(), vehicle_.sensors.end(), [&](const Sensor& s) { return change(s) == 0; }))
      continue;
    const Eigen::Index count = audited_.car.reach.size() + 1;
    audited_.car.reach.conservativeResize(count);
    audited_.car.reach[count - 1] = reach;
    for (std::size_t s = 0; s < vehicle_.sensors.size(); ++s) {
      wheelpan_slopes_[s].conservativeResizeLike(Eigen::VectorXd::Zero(count));
      wheelpan_slopes_[s][count - 1] = change(vehicle_.sensors[s]);
    }
    if (!audited_.car.balance) continue;
    AuditedBalance& balance = *audited_.car.balance;
    balance.inertia_slope.emplace_back(Eigen::RowVectorXd::Zero(audited_.car.coordinates));
    balance.gravity_slope.emplace_back(Eigen::RowVectorXd::Zero(audited_.car.coordinates));
    weight_.slope.conservativeResizeLike(Eigen::VectorXd::Zero(count));
  }
}

AuditedRun AuditedVehicle::Blank(std::string name, std::vector<double> frequency_Hz) const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto points = static_cast<Eigen::Index>(frequency_Hz.size());
  const auto sensors = static_cast<Eigen::Index>(audited_.car.sensors.size());
  const auto tyres = static_cast<Eigen::Index>(audited_.car.tyres.size());
  return {.name = std::move(name),
          .frequency_Hz = std::move(frequency_Hz),
          .posts = Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(vehicle_.posts.size()), points),
          .motions = Eigen::MatrixXcd::Constant(sensors, points, kNone),
          .motion_sd = Eigen::MatrixXd::Zero(sensors, points),
          .forces = Eigen::MatrixXcd::Constant(tyres, points, kNone),
          .force_sd = Eigen::MatrixXd::Zero(tyres, points)};
}

void AuditedVehicle::Put(AuditedRun& run, std::size_t sensor, std::size_t frequency, std::complex<double> reading,
                         double sd) {
  const Sensor::Type type = vehicle_.sensors[sensor].type;
  const auto row = static_cast<Eigen::Index>(place_of_sensor_[sensor]);
  const auto f = static_cast<Eigen::Index>(frequency);
  const double omega = 2 * std::numbers::pi * run.frequency_Hz[frequency];
  if (type == Sensor::Type::kLoadCell) {
    if (row < 0 || row >= run.forces.rows()) return;
    AuditedTyre& tyre = audited_.car.tyres[static_cast<std::size_t>(row)];
    tyre.cell = vehicle_.sensors[sensor].name;
    tyre.wheelpan = vehicle_.sensors[sensor].wheelpan.At(vehicle_.ParameterValues());
    tyre.wheelpan_slope = wheelpan_slopes_[sensor];
    run.forces(row, f) = reading + omega * omega * tyre.wheelpan * run.posts(static_cast<Eigen::Index>(tyre.post), f);
    run.force_sd(row, f) = sd;
    return;
  }
  const std::complex<double> unit =
      type == Sensor::Type::kGyro ? std::complex<double>(0, omega) : std::complex<double>(1, 0);
  run.motions(row, f) = reading / unit;
  run.motion_sd(row, f) = sd / std::abs(unit);
}

void AuditedVehicle::Add(AuditedRun run, const std::vector<double>& amplitude_m) {
  constexpr double kShare = 0.9;
  for (Eigen::Index t = 0; t < run.forces.rows(); ++t) {
    const double most = kShare * model_.preloads.tyre[static_cast<std::size_t>(t)];
    std::vector<Eigen::Index> lifted;
    for (Eigen::Index f = 0; f < run.forces.cols(); ++f)
      if (std::abs(run.forces(t, f)) * amplitude_m[static_cast<std::size_t>(f)] > most) lifted.push_back(f);
    if (2 * std::ssize(lifted) > run.forces.cols()) continue;
    for (const Eigen::Index f : lifted) run.forces(t, f) = std::numeric_limits<double>::quiet_NaN();
  }
  audited_.runs.push_back(std::move(run));
}

void AuditedVehicle::AddLoad(double load, double sd) {
  weight_.measured += load;
  weight_.sd = std::hypot(weight_.sd, sd);
  ++loads_;
  // The file's places of masses say how it is shared; only the sum is sure.
  if (loads_ == audited_.car.tyres.size() && audited_.car.balance) audited_.weight = weight_;
}

}  // namespace fourpost
