#include "vehicles/closed_form/half_car.h"

#include <algorithm>
#include <array>
#include <complex>
#include <vector>

#include <gmock/gmock.h>
#include <Eigen/Eigenvalues>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost::half_car_test {
namespace {

void Lower(Point& point, int link, double by) {
  if (point.link == link) point.xyz.z() -= by;
}

/// Turns an arm until it is level; the axle stays where it is.
void LevelArm(Vehicle& vehicle, Joint& joint) {
  const double drop = vehicle.links[static_cast<std::size_t>(joint.child)].com[2].value;
  joint.pose.translation().z() += drop;
  vehicle.links[static_cast<std::size_t>(joint.child)].com[2].value -= drop;
  for (Spring& spring : vehicle.springs) Lower(spring.line.child, joint.child, drop);
  for (Damper& damper : vehicle.dampers) Lower(damper.line.child, joint.child, drop);
  for (Tyre& tyre : vehicle.tyres) Lower(tyre.point, joint.child, drop);
  for (Sensor& sensor : vehicle.sensors) {
    Lower(sensor.point, joint.child, drop);
    Lower(sensor.line.child, joint.child, drop);
  }
}

/// The linkage car with level arms and both dampers beside their springs (specification 2.5).
Vehicle LevelCar() {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  for (Joint& joint : vehicle.joints) {
    const std::string& link = vehicle.links[static_cast<std::size_t>(joint.child)].name;
    if (link == "front_axle" || link == "rear_axle") LevelArm(vehicle, joint);
  }
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i) vehicle.dampers[i].line = vehicle.springs[i].line;
  return vehicle;
}

// Axles below the body's centre of mass, specification 2.5 [m].
constexpr double kFrontDepth = 0.447;
constexpr double kRearDepth = 0.457;

/// Model 1 with the parameters of the vehicle, both sides together, and Is + sum of m h^2.
HalfCar EquivalentHalfCar(const Vehicle& vehicle) {
  HalfCar car;
  car.sprung_mass = ValueOf(vehicle, "m_sprung");
  car.front_mass = ValueOf(vehicle, "m_front");
  car.rear_mass = ValueOf(vehicle, "m_rear");
  car.pitch_inertia = ValueOf(vehicle, "I_pitch") + car.front_mass * kFrontDepth * kFrontDepth +
                      car.rear_mass * kRearDepth * kRearDepth;
  car.front_stiffness = 2 * ValueOf(vehicle, "k_front");
  car.rear_stiffness = 2 * ValueOf(vehicle, "k_rear");
  car.front_tyre_stiffness = 2 * ValueOf(vehicle, "kt_front");
  car.rear_tyre_stiffness = 2 * ValueOf(vehicle, "kt_rear");
  car.front_damper = {2 * ValueOf(vehicle, "c_front_bump"), 2 * ValueOf(vehicle, "c_front_rebound")};
  car.rear_damper = {2 * ValueOf(vehicle, "c_rear_bump"), 2 * ValueOf(vehicle, "c_rear_rebound")};
  car.front_length = 1.456;
  car.rear_length = 1.338;
  return car;
}

/// Model 1 with what gravity adds, which it leaves out: the springs carry the body above their ends on the axles, so a
/// pitched body leans over and its weight takes (sum of spring loads times depth) from the pitch stiffness.
CondensedModel WithGravity(const HalfCar& car, const Preloads& preloads) {
  CondensedModel model = car.Model();
  model.stiffness(1, 1) += preloads.spring[0] * kFrontDepth + preloads.spring[1] * kRearDepth;  // tension positive
  return model;
}

/// Adds the sensors of the vehicle that Model 1 has too: q = (z_s, theta, z_f, z_r).
CondensedModel WithSensors(CondensedModel model, const HalfCar& car, const std::vector<Sensor>& sensors) {
  const auto count = static_cast<Eigen::Index>(sensors.size());
  model.on_position.setZero(count, 4);
  model.on_velocity.setZero(count, 4);
  model.on_acceleration.setZero(count, 4);
  model.on_post_height.setZero(count, 2);
  model.on_post_velocity.setZero(count, 2);
  model.on_post_acceleration.setZero(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::string& name = sensors[static_cast<std::size_t>(i)].name;
    if (name == "a_body_front") model.on_acceleration.row(i) << 1, -car.front_length, 0, 0;
    if (name == "a_body_rear") model.on_acceleration.row(i) << 1, car.rear_length, 0, 0;
    if (name == "a_axle_front") model.on_acceleration.row(i) << 0, 0, 1, 0;
    if (name == "a_axle_rear") model.on_acceleration.row(i) << 0, 0, 0, 1;
    if (name == "s_strut_front") model.on_position.row(i) << 1, -car.front_length, -1, 0;
    if (name == "s_strut_rear") model.on_position.row(i) << 1, car.rear_length, 0, -1;
    if (name == "F_tyre_front") {
      model.on_position(i, 2) = -car.front_tyre_stiffness;
      model.on_post_height(i, 0) = car.front_tyre_stiffness;
    }
    if (name == "F_tyre_rear") {
      model.on_position(i, 3) = -car.rear_tyre_stiffness;
      model.on_post_height(i, 1) = car.rear_tyre_stiffness;
    }
  }
  return model;
}

std::vector<std::complex<double>> Poles(const CondensedModel& model) {
  const Eigen::VectorXcd eigenvalues = StateMatrix(model).eigenvalues();
  std::vector<std::complex<double>> poles;
  for (const std::complex<double> pole : eigenvalues)
    if (pole.imag() > 0) poles.push_back(pole);
  std::sort(poles.begin(), poles.end(), [](auto a, auto b) { return std::abs(a) < std::abs(b); });
  return poles;
}

Excitation Rig(std::vector<double> shape) {
  Excitation excitation;
  for (double f = 0.5; f <= 30; f *= 1.2) {
    excitation.frequency_Hz.push_back(f);
    excitation.amplitude_m.push_back(0.01 / f);
  }
  excitation.shape = std::move(shape);
  return excitation;
}

// The matrices differ only by rounding and by second derivatives taken from differences: 1e-12 per metre of weight.
constexpr double kRounding = 1e-9;

void ExpectEqualPoles(const CondensedModel& a, const CondensedModel& b) {
  const auto linkage = Poles(a);
  const auto closed = Poles(b);
  ASSERT_EQ(linkage.size(), 4u);
  ASSERT_EQ(closed.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(std::abs(linkage[i] / closed[i] - 1.0), kRounding);
}

void ExpectEqualResponses(const CondensedModel& linkage, const CondensedModel& closed, const Vehicle& vehicle) {
  for (const double rear : {1.0, -1.0}) {
    const Excitation excitation = Rig({1, rear});
    // So many harmonics for both.
    constexpr HarmonicBalanceOptions kAlike{.error = 1e9, .tolerance = 1e-12};
    const FrequencyResponse a = SolveHarmonicBalance(linkage, vehicle.sensors, excitation, kAlike).response;
    const FrequencyResponse b = SolveHarmonicBalance(closed, vehicle.sensors, excitation, kAlike).response;
    for (const char* name : {"a_body_front", "a_body_rear", "a_axle_front", "a_axle_rear", "s_strut_front",
                             "s_strut_rear", "F_tyre_front", "F_tyre_rear"})
      for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
        const std::complex<double> expected = b.Find(name)->response[i];
        ASSERT_GT(std::abs(expected), 0);
        // Both end within the iteration's tolerance.
        EXPECT_LT(std::abs(a.Find(name)->response[i] / expected - 1.0), kRounding) << name;
      }
  }
}

/// The model without weight, hence without preloads: the stiffness is that of a car without mass, whose rates are the
/// same.
CondensedModel Weightless(const Vehicle& vehicle) {
  const CondensedVehicle condensed(vehicle);
  CondensedModel model = condensed.At(vehicle.ParameterValues());
  Vehicle massless = vehicle;
  for (const char* mass : {"m_sprung", "m_front", "m_rear"}) Set(massless, mass, 0);
  model.stiffness = condensed.At(massless.ParameterValues()).stiffness;
  return model;
}

// The theorem of specification 2.5: with level arms and point masses Model 2 linearises exactly to Model 1 with
// Is + sum of m h^2. It speaks of rates and masses alone; what weight adds follows below.
TEST(HalfCar, IsTheLinkageCarWithLevelArmsWithoutWeight) {
  const Vehicle vehicle = LevelCar();
  const CondensedModel weightless = Weightless(vehicle);
  const HalfCar car = EquivalentHalfCar(vehicle);
  ExpectEqualPoles(weightless, car.Model());
  ExpectEqualResponses(weightless, WithSensors(car.Model(), car, vehicle.sensors), vehicle);
}

TEST(HalfCar, LinkageCarWithLevelArmsHasItsPoles) {
  const Vehicle vehicle = LevelCar();
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  ExpectEqualPoles(model, WithGravity(EquivalentHalfCar(vehicle), model.preloads));
}

TEST(HalfCar, LinkageCarWithLevelArmsHasItsResponse) {
  const Vehicle vehicle = LevelCar();
  const CondensedModel linkage = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const HalfCar car = EquivalentHalfCar(vehicle);
  ExpectEqualResponses(linkage, WithSensors(WithGravity(car, linkage.preloads), car, vehicle.sensors), vehicle);
}

TEST(HalfCar, WithoutTheAxlesDepthThePolesDiffer) {
  const Vehicle vehicle = LevelCar();
  HalfCar car = EquivalentHalfCar(vehicle);
  car.pitch_inertia = ValueOf(vehicle, "I_pitch");
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const auto linkage = Poles(model);
  const auto closed = Poles(WithGravity(car, model.preloads));
  EXPECT_GT(std::abs(linkage[1] / closed[1] - 1.0), 1e-3);
}

TEST(HalfCar, AccelerationFollowsItsMatrices) {
  HalfCar car = EquivalentHalfCar(ShippedVehicle("landrover110_linkage"));
  car.front_damper = {2000, 2000};
  car.rear_damper = {2500, 2500};
  const Eigen::Vector4d q(0.01, -0.02, 0.003, -0.004);
  const Eigen::Vector4d rate(-0.1, 0.2, 0.3, -0.4);
  const Eigen::Vector2d ground(0.005, -0.002);
  const CondensedModel model = car.Model();
  Eigen::Vector4d force = model.post_stiffness * ground - model.stiffness * q;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots)
    force -= dashpot.direction * dashpot.law.Force(dashpot.direction.dot(rate));
  const Eigen::Vector4d expected = model.mass.diagonal().cwiseInverse().cwiseProduct(force);
  // Rounding of sums of forces of some kN.
  EXPECT_LT((car.Acceleration(q, rate, ground) - expected).norm(), 1e-12 * expected.norm());
}

}  // namespace
}  // namespace fourpost::half_car_test
