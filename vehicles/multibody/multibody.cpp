#include "vehicles/multibody/multibody.h"

#include <algorithm>
#include <stdexcept>

#include "analysis/text/count_check.h"
#include "analysis/text/diagnostics.h"
#include "vehicles/description/gravity.h"
#include "vehicles/multibody/findings.h"
#include "vehicles/multibody/multibody_impl.h"
#include "vehicles/multibody/simulation_error.h"

namespace fourpost {
namespace {

using SimTK::MobilizedBody;
using SimTK::Vec3;

void SetHydraulic(const Damper& damper, std::span<const double> parameters, HydraulicData& data) {
  data.damper.damper = damper.HydraulicAt(parameters);
  if (damper.series) data.damper.mount = damper.series->At(parameters);
}

Vec3 StationAcceleration(const SensorData& sensor, const SimTK::State& at, const SimTK::SpatialVec& of_body) {
  const Vec3 arm = sensor.body.getBodyRotation(at) * sensor.station;
  const Vec3 spin = sensor.body.getBodyAngularVelocity(at);
  return of_body[1] + of_body[0] % arm + spin % (spin % arm);
}

bool AreEqual(const SimTK::MassProperties& a, const SimTK::MassProperties& b) {
  return a.getMass() == b.getMass() && a.getMassCenter() == b.getMassCenter() &&
         a.getUnitInertia().toMat33() == b.getUnitInertia().toMat33();
}

}  // namespace

/// Whether that changes any.
bool Multibody::Impl::SetMasses(std::span<const double> parameters) {
  bool changes = false;
  for (const Joint& joint : vehicle.joints) {
    MobilizedBody& body = Body(joint.child);
    const SimTK::MassProperties mass =
        MassPropertiesAt(vehicle.links[static_cast<std::size_t>(joint.child)], parameters);
    if (AreEqual(mass, body.getDefaultMassProperties())) continue;
    body.setDefaultMassProperties(mass);
    changes = true;
  }
  return changes;
}

void Multibody::Impl::SetState(double t, const Eigen::VectorXd& y) {
  RequireCount("Multibody: state", "states", static_cast<std::size_t>(state.getNY()),
               static_cast<std::size_t>(y.size()));
  state.setTime(t);
  SimTK::Vector& target = state.updY();
  for (int i = 0; i < y.size(); ++i) target[i] = y[i];
}

void Multibody::Impl::SetPose(const Eigen::VectorXd& q) {
  RequireCount("Multibody: pose", "coordinates", static_cast<std::size_t>(state.getNQ()),
               static_cast<std::size_t>(q.size()));
  for (int i = 0; i < q.size(); ++i) state.updQ()[i] = q[i];
  state.updU() = 0;
  system.realize(state, SimTK::Stage::Velocity);
}

void Multibody::Impl::Realize(SimTK::Stage stage) {
  try {
    system.realize(state, stage);
  } catch (const SimTK::Exception::Base& failure) {
    throw SimulationError(kNotEvaluated, {std::to_string(state.getTime()) + " s", failure.getMessage()});
  }
}

const Platforms& Multibody::Impl::PlatformsAt(double t) {
  if (post_motion && t != platform_time) {
    post_motion(t, posts);
    platform_time = t;
  }
  return posts;
}

double Multibody::Impl::LoadCell(const SensorData& sensor, const SimTK::State& at) {
  const TyreData& tyre = tyres[static_cast<std::size_t>(sensor.tyre)];
  const Platforms& now = PlatformsAt(at.getTime());
  const double acceleration = tyre.post < 0 ? 0 : now[static_cast<std::size_t>(tyre.post)].acceleration;
  return TyreForce::Compression(tyre, now, at) - tyre.vertical.load + sensor.wheelpan * acceleration;
}

double Multibody::Impl::Reading(const SensorData& sensor, const SimTK::State& at, const BodyMotions& accelerations) {
  switch (sensor.type) {
    case Sensor::Type::kAccelerometer: {
      const SimTK::SpatialVec& of_body = accelerations[sensor.body.getMobilizedBodyIndex()];
      const Vec3 specific_force = StationAcceleration(sensor, at, of_body) + Vec3(0, 0, kGravity);
      return SimTK::dot(sensor.body.getBodyRotation(at) * sensor.axis, specific_force) - sensor.rest;
    }
    case Sensor::Type::kDisplacement:
      return SimTK::dot(sensor.axis, sensor.body.findStationLocationInGround(at, sensor.station)) - sensor.rest;
    case Sensor::Type::kStrut: return Extension(sensor.line, at);
    case Sensor::Type::kLoadCell: return LoadCell(sensor, at);
    case Sensor::Type::kGyro:
      return SimTK::dot(sensor.body.getBodyRotation(at) * sensor.axis, sensor.body.getBodyAngularVelocity(at));
  }
  throw std::logic_error("sensor type without a reading");
}

Eigen::VectorXd Multibody::Impl::Readings(const SimTK::State& at, const BodyMotions& accelerations) {
  Eigen::VectorXd readings(sensors.size());
  for (std::size_t i = 0; i < sensors.size(); ++i)
    readings[static_cast<Eigen::Index>(i)] = Reading(sensors[i], at, accelerations);
  return readings;
}

/// Those that the forces cause. Needs Stage::Acceleration.
BodyMotions Multibody::Impl::AccelerationsAt(const SimTK::State& at) const {
  BodyMotions accelerations(matter.getNumBodies());
  for (SimTK::MobilizedBodyIndex b(0); b < matter.getNumBodies(); ++b)
    accelerations[b] = matter.getMobilizedBody(b).getBodyAcceleration(at);
  return accelerations;
}

Multibody::Multibody(const Vehicle& vehicle) : impl_(std::make_unique<Impl>(vehicle)) {}
Multibody::~Multibody() = default;
Multibody::Multibody(Multibody&&) noexcept = default;
Multibody& Multibody::operator=(Multibody&&) noexcept = default;

const Vehicle& Multibody::vehicle() const { return impl_->vehicle; }

int Multibody::coordinate_count() const { return impl_->state.getNQ(); }

int Multibody::state_size() const { return impl_->state.getNY(); }

const Eigen::VectorXd& Multibody::design_pose() const { return impl_->design_pose; }

void Multibody::SetParameters(std::span<const double> parameters, const Preloads& preloads) {
  Impl& m = *impl_;
  RequireCount("Multibody::SetParameters", "parameters", m.vehicle.parameters.size(), parameters.size());
  RequireCount("Multibody::SetParameters: preloads", "springs", m.springs.size(), preloads.spring.size());
  RequireCount("Multibody::SetParameters: preloads", "tyres", m.tyres.size(), preloads.tyre.size());
  RequireCount("Multibody::SetParameters: preloads", "bushings", m.bushings.size(), preloads.bushing.size());
  for (std::size_t i = 0; i < m.springs.size(); ++i) {
    m.springs[i].law = m.vehicle.springs[i].law.At(parameters);
    m.springs[i].preload = preloads.spring[i];
  }
  for (std::size_t i = 0; i < m.antiroll_bars.size(); ++i) {
    m.antiroll_bars[i].stiffness = m.vehicle.antiroll_bars[i].stiffness.At(parameters);
    m.antiroll_bars[i].damping = m.vehicle.antiroll_bars[i].damping.At(parameters);
  }
  for (std::size_t i = 0; i < m.dampers.size(); ++i) {
    const Damper& damper = m.vehicle.dampers[m.damper_index[i]];
    m.dampers[i].dashpot = damper.law.At(parameters);
    if (damper.series) m.dampers[i].series = damper.series->At(parameters);
  }
  for (std::size_t i = 0; i < m.hydraulics.size(); ++i)
    SetHydraulic(m.vehicle.dampers[m.hydraulic_index[i]], parameters, m.hydraulics[i]);
  for (std::size_t i = 0; i < m.frictions.size(); ++i)
    m.frictions[i].law = *m.vehicle.dampers[m.friction_index[i]].law.StickingAt(parameters);
  for (std::size_t i = 0; i < m.bushings.size(); ++i) {
    const Bushing& bushing = m.vehicle.bushings[i];
    for (std::size_t k = 0; k < 6; ++k) {
      m.bushings[i].stiffness[k] = bushing.stiffness[k].At(parameters);
      m.bushings[i].damping[k] = bushing.DampingAt(k, parameters);
    }
    m.bushings[i].preload = preloads.bushing[i];
  }
  for (std::size_t i = 0; i < m.tyres.size(); ++i) {
    const Tyre& tyre = m.vehicle.tyres[i];
    m.tyres[i].vertical = tyre.law.At(parameters).Under(preloads.tyre[i]);
    m.tyres[i].damping = tyre.damping.At(parameters);
    m.tyres[i].lateral = tyre.lateral.At(parameters);
    m.tyres[i].longitudinal = tyre.longitudinal.At(parameters);
    m.tyres[i].lateral_damping = tyre.lateral_damping.At(parameters);
    m.tyres[i].longitudinal_damping = tyre.longitudinal_damping.At(parameters);
  }
  for (std::size_t i = 0; i < m.sensors.size(); ++i)
    m.sensors[i].wheelpan = m.vehicle.sensors[i].wheelpan.At(parameters);
  const Eigen::VectorXd pose = ToEigen(m.state.getQ());
  // Simbody keeps mass properties with the topology; realizing it again reuses every body and element (~50 us), but
  // makes a state of its own: the pose has to be set again.
  if (m.SetMasses(parameters)) m.CreateState();
  m.SetPose(pose);
}

void Multibody::SetPostMotion(PostMotion motion) {
  impl_->post_motion = std::move(motion);
  impl_->platform_time = std::numeric_limits<double>::quiet_NaN();
  std::fill(impl_->posts.begin(), impl_->posts.end(), PostState());
  impl_->state.invalidateAllCacheAtOrAbove(SimTK::Stage::Dynamics);
}

void Multibody::SetPose(const Eigen::VectorXd& q) { impl_->SetPose(q); }

Eigen::Isometry3d Multibody::LinkPose(int link) const {
  return ToEigen(impl_->Body(link).getBodyTransform(impl_->state));
}

// Each joint between the link and the ground moves the link as if both were one body.
Eigen::MatrixXd Multibody::LinkJacobian(int link) const {
  const SimTK::State& state = impl_->state;
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(6, coordinate_count());
  const Eigen::Vector3d origin = ToEigen(impl_->Body(link).getBodyOriginLocation(state));
  for (MobilizedBody body = impl_->Body(link); !body.isGround(); body = body.getParentMobilizedBody()) {
    const Eigen::Vector3d arm = origin - ToEigen(body.getBodyOriginLocation(state));
    const int first = body.getFirstUIndex(state);
    for (int k = 0; k < body.getNumU(state); ++k) {
      const SimTK::SpatialVec motion = body.getHCol(state, SimTK::MobilizerUIndex(k));
      const Eigen::Vector3d turn = ToEigen(motion[0]);
      jacobian.block<3, 1>(0, first + k) = turn;
      jacobian.block<3, 1>(3, first + k) = ToEigen(motion[1]) + turn.cross(arm);
    }
  }
  return jacobian;
}

Eigen::VectorXd Multibody::MemoryExtensions() const {
  Eigen::VectorXd extensions(impl_->hydraulics.size() + impl_->frictions.size());
  Eigen::Index next = 0;
  for (const HydraulicData& damper : impl_->hydraulics) extensions[next++] = Extension(damper.line, impl_->state);
  for (const FrictionData& friction : impl_->frictions) extensions[next++] = Extension(friction.line, impl_->state);
  return extensions;
}

const std::vector<LoopClosure>& Multibody::loop_closures() const { return impl_->loops; }

Eigen::VectorXd Multibody::LoopError() const { return ToEigen(impl_->state.getQErr()); }

Eigen::MatrixXd Multibody::LoopJacobian() const {
  // By the constraints' forces, one pass a row: there are fewer rows than columns.
  SimTK::Matrix transposed;
  impl_->matter.calcGTranspose(impl_->state, transposed);
  return ToEigen(transposed).transpose();
}

Eigen::VectorXd Multibody::LoopForces(const Eigen::VectorXd& of_loops) const {
  const SimTK::Vector multipliers(static_cast<int>(of_loops.size()), of_loops.data(), true);
  SimTK::Vector forces;
  impl_->matter.multiplyByGTranspose(impl_->state, multipliers, forces);
  return ToEigen(forces);
}

Eigen::VectorXd Multibody::StateDerivative(double t, const Eigen::VectorXd& state) {
  impl_->SetState(t, state);
  impl_->system.realize(impl_->state, SimTK::Stage::Acceleration);
  return ToEigen(impl_->state.getYDot());
}

void Multibody::SetState(double t, const Eigen::VectorXd& state) {
  impl_->SetState(t, state);
  impl_->Realize(SimTK::Stage::Velocity);
}

Eigen::VectorXd Multibody::LoopBias() const {
  SimTK::Vector bias;
  impl_->matter.calcBiasForAccelerationConstraints(impl_->state, bias);
  return ToEigen(bias);
}

Eigen::VectorXd Multibody::Residual(double t, const Eigen::VectorXd& state, const Eigen::VectorXd& derivative) {
  SetState(t, state);
  return Residual(derivative);
}

Eigen::VectorXd Multibody::Residual(const Eigen::VectorXd& derivative) {
  Impl& m = *impl_;
  m.Realize(SimTK::Stage::Dynamics);
  const int n = coordinate_count();
  const SimTK::Vector& z = m.state.getZ();
  const SimTK::Vector acceleration(n, derivative.data() + n, true);
  SimTK::Vector lacking;
  m.matter.calcResidualForceIgnoringConstraints(m.state, m.system.getMobilityForces(m.state, SimTK::Stage::Dynamics),
                                                m.system.getRigidBodyForces(m.state, SimTK::Stage::Dynamics),
                                                acceleration, lacking);
  Eigen::VectorXd residual(state_size() - n);
  for (int i = 0; i < n; ++i) residual[i] = lacking[i];
  // Place among the states z.
  int i = 0;
  for (const DamperData& damper : m.dampers) {
    if (!damper.in_series) continue;
    const double rate = Motion(damper.line, m.state).rate;
    residual[n + i] = damper.series.Force(z[i]) - damper.dashpot.Force(rate - derivative[2 * n + i]);
    ++i;
  }
  for (const HydraulicData& damper : m.hydraulics) {
    const std::array<double, 2> rates = HydraulicRates(damper, Motion(damper.line, m.state), {z[i], z[i + 1]});
    for (const double rate : rates) {
      residual[n + i] = derivative[2 * n + i] - rate;
      ++i;
    }
  }
  for (const FrictionData& friction : m.frictions) {
    residual[n + i] = derivative[2 * n + i] - FrictionRate(friction, Motion(friction.line, m.state), z[i]);
    ++i;
  }
  return residual;
}

Eigen::VectorXd Multibody::Readings(double t, const Eigen::VectorXd& state) {
  impl_->SetState(t, state);
  impl_->Realize(SimTK::Stage::Acceleration);
  return impl_->Readings(impl_->state, impl_->AccelerationsAt(impl_->state));
}

Eigen::VectorXd Multibody::Readings(const Eigen::VectorXd& derivative) {
  Impl& m = *impl_;
  const int n = coordinate_count();
  BodyMotions accelerations;
  m.matter.calcBodyAccelerationFromUDot(m.state, SimTK::Vector(n, derivative.data() + n, true), accelerations);
  return m.Readings(m.state, accelerations);
}

Eigen::VectorXd Multibody::RestState() const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(state_size());
  y.head(design_pose().size()) = design_pose();
  return y;
}

void Multibody::Integrate(const Eigen::VectorXd& state, double start, double step, double accuracy,
                          const MarchSink& sink, const std::function<bool()>& done) {
  Impl& m = *impl_;
  m.SetState(start, state);
  SimTK::RungeKuttaMersonIntegrator integrator(m.system);
  integrator.setAccuracy(accuracy);
  try {
    SimTK::State initial = m.state;
    integrator.initialize(initial);
    for (long k = 0;; ++k) {
      const double until = start + static_cast<double>(k) * step;
      // The first call returns at once, at the start of the first interval.
      while (integrator.getTime() < until) integrator.stepTo(until);
      const SimTK::State& now = integrator.getState();
      m.system.realize(now, SimTK::Stage::Acceleration);
      sink(now.getTime(), ToEigen(now.getY()), m.Readings(now, m.AccelerationsAt(now)));
      if (done()) return;
    }
  } catch (const SimTK::Exception::Base& failure) {
    throw SimulationError(kSimulationFailed, {std::to_string(integrator.getTime()) + " s", failure.getMessage()});
  }
}

}  // namespace fourpost
