// Loop closures and elements at work in small mechanisms whose motion is known.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "tests/vehicles/element_car.h"
#include "vehicles/chart.h"
#include "vehicles/condensed_vehicle.h"
#include "vehicles/gravity.h"
#include "vehicles/harmonic_balance.h"
#include "vehicles/kinematics.h"
#include "vehicles/modes.h"
#include "vehicles/multibody.h"

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Multibody Resting(const Vehicle& vehicle) {
  Multibody multibody(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  return multibody;
}

/// An axle of 100 kg that may shift and heave, on a coil, with a level Panhard rod of 1 m.
const std::string kPanhard = R"(<robot name="panhard" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="carriage"/>
  <link name="axle"><inertial><mass value="100"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="shift" type="prismatic"><parent link="ground"/><child link="carriage"/><origin xyz="0 0 0.4"/>
    <axis xyz="0 1 0"/><limit effort="0" velocity="0"/></joint>
  <joint name="heave" type="prismatic"><parent link="carriage"/><child link="axle"/>
    <axis xyz="0 0 1"/><limit effort="0" velocity="0"/></joint>
  <fp:frame name="body" link="ground" xyz="0 0.5 0.4"/>
  <fp:frame name="eye" link="axle" xyz="0 -0.5 0"/>
  <fp:rod name="panhard" parent="body" child="eye"/>
  <fp:frame name="top" link="ground" xyz="0 0 0.8"/>
  <fp:spring name="coil" parent="top" child="axle"><linear stiffness="20 N/mm"/></fp:spring>
</robot>
)";

/// How far the axle is from where its rod lets it be at this heave: y = 1 m - sqrt(1 m^2 - z^2).
double OffTheCircle(const Multibody& multibody) {
  const Vector3d place = multibody.LinkPose(2).translation();
  const double z = place.z() - 0.4;
  return place.y() - (1 - std::sqrt(1 - z * z));
}

TEST(PanhardRod, LeadsTheAxleOnACircle) {
  Multibody multibody(VehicleOf(kPanhard));
  Chart chart(multibody);
  ASSERT_EQ(chart.size(), 1);
  for (const double heave : {-0.2, -0.05, 0.0, 0.03, 0.1, 0.3}) {
    chart.MoveTo(VectorXd::Constant(1, heave));
    EXPECT_NEAR(std::abs(multibody.LinkPose(2).translation().z() - 0.4), std::abs(heave), 1e-10);
    EXPECT_NEAR(OffTheCircle(multibody), 0, 1e-10);
  }
}

TEST(PanhardRod, LeadsTheAxleOnACircleInMotion) {
  const Vehicle vehicle = VehicleOf(kPanhard);
  Multibody multibody = Resting(vehicle);
  Multibody pose(vehicle);
  Chart chart(pose);
  chart.MoveTo(VectorXd::Constant(1, 0.1));
  VectorXd state = multibody.RestState();
  state.head(2) << pose.LinkPose(2).translation().y(), pose.LinkPose(2).translation().z() - 0.4;
  int count = 0;
  constexpr double kAccuracy = 1e-9;
  multibody.Integrate(
      state, 0, 0.01, kAccuracy,
      [&](double, const VectorXd& y, const VectorXd&) {
        pose.SetPose(y.head(2));
        // Simbody projects onto the loop within its accuracy.
        EXPECT_NEAR(OffTheCircle(pose), 0, kAccuracy);
        ++count;
      },
      [&] { return count > 100; });
}

/// An axle in the plane x z, its two links `upper` and `lower` as texts of tags between frames of these names.
std::string FourLink(const std::string& links) {
  return R"(<robot name="four_link" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="axle"><inertial><mass value="90"/>
    <inertia ixx="1" iyy="4" izz="4" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="plane" type="planar"><parent link="ground"/><child link="axle"/><origin xyz="0 0 0.35"/>
    <axis xyz="0 1 0"/></joint>
  <fp:frame name="lower_body" link="ground" xyz="-0.8 0 0.45"/>
  <fp:frame name="upper_body" link="ground" xyz="-0.6 0 0.7"/>
  <fp:frame name="lower" link="axle" xyz="-0.05 0 -0.05"/>
  <fp:frame name="upper" link="axle" xyz="-0.05 0 0.25"/>
  <fp:frame name="pivot_body" link="ground" xyz="-0.8 0 0.4" rpy="0 0.3 0"/>
  <fp:frame name="pivot" link="axle" xyz="-0.8 0 0.05"/>
  <fp:frame name="top" link="ground" xyz="0.05 0 0.8"/>
  <fp:frame name="seat" link="axle" xyz="0.1 0 0.05"/>
  <fp:spring name="coil" parent="top" child="seat"><linear stiffness="30 N/mm"/></fp:spring>
  <fp:damper name="shock" parent="top" child="seat"><linear rate="1 kN*s/m"/></fp:damper>
  <fp:tyre name="tyre" link="axle" xyz="0 0 0" radius="0.35 m" stiffness="200 kN/m" preload="3 kN"/>
  <fp:post name="post" under="tyre"/>
  <fp:sensor name="hop" type="accelerometer" link="axle" xyz="0 0 0"/>
  <fp:sensor name="surge" type="displacement" link="axle" xyz="0.1 0 0" axis="1 0 0"/>
  <fp:sensor name="pitch" type="gyro" link="axle" axis="0 1 0"/>
  )" + links +
         "</robot>\n";
}

/// Phasors of all sensors at 9 Hz, near the wheel hop.
Eigen::VectorXcd Response(const std::string& text) {
  const Vehicle vehicle = VehicleOf(text);
  const FrequencyResponse response = SolveHarmonicBalance(CondensedVehicle(vehicle).At(vehicle.ParameterValues()),
                                                          vehicle.sensors, {{9.0}, {0.001}, {1}})
                                         .response;
  Eigen::VectorXcd phasors(static_cast<Index>(response.channels.size()));
  for (Index i = 0; i < phasors.size(); ++i) phasors[i] = response.channels[static_cast<std::size_t>(i)].response[0];
  return phasors;
}

/// What yields by force / stiffness leaves an error that falls as the inverse of the stiffness, but for terms that fall
/// as its square: a thousandth of it here.
void ExpectFirstOrder(const std::string& rigid, const std::function<std::string(const std::string& stiffness)>& soft) {
  const Eigen::VectorXcd limit = Response(FourLink(rigid));
  const double at_1 = (Response(FourLink(soft("1000 MN/m"))) - limit).norm() / limit.norm();
  const double at_10 = (Response(FourLink(soft("10000 MN/m"))) - limit).norm() / limit.norm();
  EXPECT_LT(at_1, 0.01);
  EXPECT_NEAR(at_1 / at_10, 10, 0.05);
}

TEST(Rods, AreTheLimitOfStiffSprings) {
  ExpectFirstOrder(R"(<fp:rod name="lower" parent="lower_body" child="lower"/>
  <fp:rod name="upper" parent="upper_body" child="upper"/>)",
                   [](const std::string& stiffness) {
                     const auto link = [&](const std::string& name) {
                       return "<fp:spring name=\"" + name + "\" parent=\"" + name + "_body\" child=\"" + name +
                              "\"><linear stiffness=\"" + stiffness + "\"/></fp:spring>";
                     };
                     return link("lower") + link("upper");
                   });
}

TEST(Balls, AreTheLimitOfStiffBushings) {
  ExpectFirstOrder(R"(<fp:ball name="pivot" parent="pivot_body" child="pivot"/>)", [](const std::string& stiffness) {
    return R"(<fp:bushing name="pivot" parent="pivot_body" child="pivot" preload="equilibrium"><translation x=")" +
           stiffness + R"(" z=")" + stiffness + R"("/></fp:bushing>)";
  });
}

/// 200 kg on a coil and a hydraulic damper, which may move up and down.
const std::string kOnOil = R"(<robot name="on_oil" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="body"><inertial><mass value="200"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="heave" type="prismatic"><parent link="ground"/><child link="body"/><origin xyz="0 0 0.5"/>
    <axis xyz="0 0 1"/><limit effort="0" velocity="0"/></joint>
  <fp:spring name="coil" parent="body" child="ground"><linear stiffness="20 N/mm"/></fp:spring>
  <fp:damper name="oil" parent="body" child="ground">
    <hydraulic bleed="0.6 mm^2" rebound_valve="10 MPa*s/kg" bulk_modulus="100 MPa"/>
    <friction force="30 N" speed="20 mm/s"/>
  </fp:damper>
</robot>
)";

/// Position, velocity and pressures, and their rates by the damper's own equations.
std::array<double, 4> Rates(const HydraulicDamper& damper, const std::array<double, 4>& y) {
  const std::array<double, 2> pressures = {y[2], y[3]};
  const std::array<double, 2> rates = damper.PressureRates(y[0], y[1], pressures);
  return {y[1], (-20e3 * y[0] - damper.Force(y[1], pressures)) / 200, rates[0], rates[1]};
}

// Let go 40 mm above its rest: the multibody against Runge and Kutta's fourth order with steps of 5 us.
TEST(HydraulicDamper, MovesABodyByItsOwnEquations) {
  const Vehicle vehicle = VehicleOf(kOnOil);
  const HydraulicDamper damper = vehicle.dampers[0].HydraulicAt({});
  Multibody multibody = Resting(vehicle);
  VectorXd state = multibody.RestState();
  state[0] = 0.04;
  std::array<double, 4> y = {0.04, 0, damper.gas_pressure, damper.gas_pressure};
  constexpr double kStep = 5e-6;
  constexpr int kStepsPerSample = 1000;
  int samples = 0;
  double lowest = 0;
  multibody.Integrate(
      state, 0, kStep * kStepsPerSample, 1e-9,
      [&](double, const VectorXd& now, const VectorXd&) {
        // 1e-9 of about 1 (m, m/s, MPa), once per some hundred steps.
        for (Index i = 0; i < 2; ++i) EXPECT_NEAR(now[i], y[static_cast<std::size_t>(i)], 1e-7);
        for (Index i = 2; i < 4; ++i)
          EXPECT_NEAR(now[i], (y[static_cast<std::size_t>(i)] - damper.gas_pressure) / 1e6, 1e-6);
        lowest = std::min(lowest, now[2]);
        const auto along = [&](double h, const std::array<double, 4>& rates) {
          std::array<double, 4> moved = y;
          for (std::size_t i = 0; i < 4; ++i) moved[i] += h * rates[i];
          return moved;
        };
        for (int k = 0; k < kStepsPerSample; ++k) {
          const auto k1 = Rates(damper, y);
          const auto k2 = Rates(damper, along(kStep / 2, k1));
          const auto k3 = Rates(damper, along(kStep / 2, k2));
          const auto k4 = Rates(damper, along(kStep, k3));
          for (std::size_t i = 0; i < 4; ++i) y[i] += kStep / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        }
        ++samples;
      },
      [&] { return samples > 100; });
  EXPECT_LT(lowest, -0.1) << "the oil was not pressed";
}

/// The poles of a vehicle's linear model, by rising imaginary part.
VectorXd Poles(const Vehicle& vehicle) {
  const Eigen::EigenSolver<MatrixXd> solver(StateMatrix(CondensedVehicle(vehicle).At(vehicle.ParameterValues())),
                                            false);
  std::vector<double> sizes;
  for (const std::complex<double>& pole : solver.eigenvalues()) sizes.push_back(std::abs(pole));
  std::sort(sizes.begin(), sizes.end());
  return Eigen::Map<VectorXd>(sizes.data(), static_cast<Index>(sizes.size()));
}

Joint& JointOf(Vehicle& vehicle, const std::string& name) {
  for (Joint& joint : vehicle.joints)
    if (joint.name == name) return joint;
  throw std::invalid_argument(name);
}

// The wheel on its arm and the other arm on its pivot, as joints of the tree.
TEST(WeldsAndHinges, EqualJointsOfTheTree) {
  const Vehicle loops = ElementCar();
  Vehicle tree = loops;
  Joint& hub = JointOf(tree, "j_hub");
  hub.type = Joint::Type::kFixed;
  hub.parent = loops.welds[0].parent.link;
  hub.pose.translation() = loops.welds[0].parent.xyz;
  Joint& pivot = JointOf(tree, "j_hinged");
  pivot.type = Joint::Type::kRevolute;
  pivot.parent = loops.hinges[0].parent.link;
  pivot.pose.translation() = loops.hinges[0].parent.xyz;
  pivot.axis = loops.hinges[0].axis;
  // Parents before children.
  std::stable_partition(tree.joints.begin(), tree.joints.end(),
                        [&](const Joint& joint) { return joint.name != "j_hub" && joint.name != "j_hinged"; });
  tree.welds.clear();
  tree.hinges.clear();
  // Second derivatives along the loop's closed poses: 1e-10 of the lengths, see Chart.
  const VectorXd poles = Poles(loops);
  EXPECT_LT(((Poles(tree) - poles).array() / poles.array()).abs().maxCoeff(), 1e-8);
  const Preloads with_loops = CondensedVehicle(loops).PreloadsAt(loops.ParameterValues());
  const Preloads with_joints = CondensedVehicle(tree).PreloadsAt(tree.ParameterValues());
  for (std::size_t i = 0; i < with_loops.tyre.size(); ++i)
    EXPECT_NEAR(with_loops.tyre[i], with_joints.tyre[i], 1e-8);  // rounding of 10 kN
}

TEST(WeldsAndHinges, MoveAsJointsOfTheTree) {
  const Vehicle loops = ElementCar();
  Multibody multibody(loops);
  Chart chart(multibody);
  const Matrix3d hub = multibody.LinkPose(loops.welds[0].child.link).linear();
  const Matrix3d arm = multibody.LinkPose(loops.welds[0].parent.link).linear();
  for (int draw = 0; draw < 5; ++draw) {
    VectorXd s(chart.size());
    for (Index i = 0; i < s.size(); ++i) s[i] = 0.05 * std::sin(1.0 + draw + 1.3 * static_cast<double>(i));
    chart.MoveTo(s);
    const auto pose = [&](int link) { return multibody.LinkPose(link); };
    const auto gap = [&](const Point& a, const Point& b) {
      return (pose(a.link) * a.xyz - pose(b.link) * b.xyz).norm();
    };
    // What Chart leaves of a closed loop.
    constexpr double kClosed = 1e-12;
    for (const Weld& weld : loops.welds) {
      EXPECT_LT(gap(weld.parent, weld.child), kClosed);
      const Matrix3d turn = pose(weld.parent.link).linear().transpose() * pose(weld.child.link).linear();
      EXPECT_LT((turn - arm.transpose() * hub).norm(), kClosed);
    }
    for (const Hinge& hinge : loops.hinges) {
      EXPECT_LT(gap(hinge.parent, hinge.child), kClosed);
      // Both links were unturned.
      EXPECT_LT((pose(hinge.parent.link).linear() * hinge.axis - pose(hinge.child.link).linear() * hinge.axis).norm(),
                kClosed);
    }
    for (const Ball& ball : loops.balls) EXPECT_LT(gap(ball.parent, ball.child), kClosed);
  }
}

/// A car of all elements that nothing but gravity acts on from outside.
Vehicle FreeCar() {
  Vehicle car = ElementCar();
  for (Tyre& tyre : car.tyres) {
    tyre.stiffness = tyre.lateral = tyre.longitudinal = {};
    tyre.damping = tyre.lateral_damping = tyre.longitudinal_damping = {};
  }
  for (Damper& damper : car.dampers) {
    // Oil keeps an energy of its own; friction about rest would need short steps.
    if (damper.hydraulic) damper.law = {.compression = {1000}, .rebound = {2000}};
    damper.hydraulic.reset();
    if (damper.law.friction) damper.law.friction->speed = {0.05};
  }
  return car;
}

/// Momenta and energies of a vehicle from its links' poses and Jacobians alone.
class Balances {
 public:
  Balances(const Vehicle& vehicle, const Preloads& preloads)
      : vehicle_(vehicle), values_(vehicle.ParameterValues()), preloads_(preloads), multibody_(vehicle) {
    Pose(multibody_.design_pose());
    for (const Spring& spring : vehicle.springs) spring_length_.push_back(kinematics_->LineLength(spring.line).value);
    for (const AntiRollBar& bar : vehicle.antiroll_bars) twist_.push_back(kinematics_->Twist(bar).value);
    for (const Bushing& bushing : vehicle.bushings) {
      child_axes_.push_back(kinematics_->ChildAxes(bushing));
      bushing_place_.push_back(kinematics_->BushingPlace(bushing, child_axes_.back()));
    }
  }

  struct Sum {
    double mass = 0;
    Vector3d com = Vector3d::Zero();
    Vector3d momentum = Vector3d::Zero();
    /// About the centre of mass.
    Vector3d spin = Vector3d::Zero();
    double energy = 0;
    double dissipation = 0;
  };

  Sum At(const VectorXd& state) {
    const Index n = multibody_.coordinate_count();
    Pose(state.head(n));
    const VectorXd u = state.segment(n, n);
    Sum sum;
    for (std::size_t i = 0; i < vehicle_.links.size(); ++i) AddLink(static_cast<int>(i), u, sum);
    sum.com /= sum.mass;
    sum.spin -= sum.com.cross(sum.momentum);
    sum.energy += sum.mass * kGravity * sum.com.z();
    AddElements(state, u, sum);
    return sum;
  }

 private:
  void Pose(const VectorXd& q) {
    multibody_.SetPose(q);
    kinematics_.emplace(multibody_, MatrixXd::Identity(q.size(), q.size()));
  }

  void AddLink(int index, const VectorXd& u, Sum& sum) const {
    const Link& link = vehicle_.links[static_cast<std::size_t>(index)];
    const double mass = link.mass.At(values_);
    const Point com{index, link.ComAt(values_)};
    const Vector3d place = kinematics_->Location(com);
    const Vector3d velocity = kinematics_->PointJacobian(com) * u;
    std::array<double, 6> i{};
    for (std::size_t k = 0; k < i.size(); ++k) i[k] = link.inertia[k].At(values_);
    Matrix3d inertia;
    inertia << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
    const Matrix3d turn = kinematics_->Rotation(index);
    const Vector3d w = kinematics_->AngularJacobian(index) * u;
    const Vector3d spin = turn * inertia * turn.transpose() * w;
    sum.mass += mass;
    sum.com += mass * place;
    sum.momentum += mass * velocity;
    sum.spin += mass * place.cross(velocity) + spin;
    sum.energy += 0.5 * (mass * velocity.squaredNorm() + w.dot(spin));
  }

  void AddElements(const VectorXd& state, const VectorXd& u, Sum& sum) const {
    for (std::size_t i = 0; i < vehicle_.springs.size(); ++i) {
      const double x = kinematics_->LineLength(vehicle_.springs[i].line).value - spring_length_[i];
      sum.energy += preloads_.spring[i] * x + vehicle_.springs[i].law.At(values_).Energy(x);
    }
    for (std::size_t i = 0; i < vehicle_.antiroll_bars.size(); ++i) {
      const AntiRollBar& bar = vehicle_.antiroll_bars[i];
      const Coordinate twist = kinematics_->Twist(bar);
      sum.energy += 0.5 * bar.stiffness.At(values_) * std::pow(twist.value - twist_[i], 2);
      sum.dissipation += bar.damping.At(values_) * std::pow(twist.gradient.dot(u), 2);
    }
    for (std::size_t i = 0; i < vehicle_.bushings.size(); ++i) {
      const auto place = kinematics_->BushingPlace(vehicle_.bushings[i], child_axes_[i]);
      for (std::size_t k = 0; k < 6; ++k) {
        const double x = place[k].value - bushing_place_[i][k].value;
        sum.energy += 0.5 * vehicle_.bushings[i].stiffness[k].At(values_) * x * x;
        if (k < 3) sum.energy += preloads_.bushing[i][static_cast<Index>(k)] * x;
        sum.dissipation += vehicle_.bushings[i].DampingAt(k, values_) * std::pow(place[k].gradient.dot(u), 2);
      }
    }
    Index z = 2 * multibody_.coordinate_count();
    for (const Damper& damper : vehicle_.dampers) {
      const DashpotLaw law = damper.law.At(values_);
      if (damper.series) {
        const SpringLaw series = damper.series->At(values_);
        const double force = series.Force(state[z]);
        sum.energy += series.Energy(state[z]);
        sum.dissipation += force * law.Velocity(force);
        ++z;
      } else {
        const double rate = kinematics_->LineLength(damper.line).gradient.dot(u);
        sum.dissipation += law.Force(rate) * rate;
      }
    }
  }

  Vehicle vehicle_;
  std::vector<double> values_;
  Preloads preloads_;
  Multibody multibody_;
  std::optional<Kinematics> kinematics_;
  std::vector<double> spring_length_;
  std::vector<double> twist_;
  std::vector<Matrix3d> child_axes_;
  std::vector<std::array<Coordinate, 6>> bushing_place_;
};

// Dropped turning and tumbling from the design pose with its suspension strained by the weight it no longer carries.
TEST(FreeCar, KeepsItsMomentaAndItsEnergyButForWhatItsDampersTake) {
  const Vehicle car = FreeCar();
  const std::vector<double> values = car.ParameterValues();
  Preloads preloads = CondensedVehicle(ElementCar()).PreloadsAt(values);
  std::fill(preloads.tyre.begin(), preloads.tyre.end(), 0);
  Multibody multibody(car);
  multibody.SetParameters(values, preloads);
  Chart chart(multibody);
  const MatrixXd tangent = chart.MoveTo(VectorXd::Zero(chart.size()));
  VectorXd state = multibody.RestState();
  VectorXd rate(chart.size());
  for (Index i = 0; i < rate.size(); ++i) rate[i] = 0.3 * std::sin(1.0 + 1.3 * static_cast<double>(i));
  state.segment(multibody.coordinate_count(), multibody.coordinate_count()) = tangent * rate;

  Balances balances(car, preloads);
  const Balances::Sum start = balances.At(state);
  ASSERT_GT(start.spin.norm(), 10);
  // Samples for Simpson's rule.
  constexpr double kStep = 2.5e-4;
  constexpr int kSteps = 800;
  double lost = 0;
  double worst_energy = 0;
  double before = 0;
  double midway = 0;
  int count = 0;
  multibody.Integrate(
      state, 0, kStep, 1e-9,
      [&](double t, const VectorXd& y, const VectorXd&) {
        const Balances::Sum now = balances.At(y);
        // Integration at 1e-9 of about 1 over some thousand steps, times 1.3 t and 1 m.
        EXPECT_LT((now.momentum - start.momentum + Vector3d(0, 0, start.mass * kGravity * t)).norm(), 1e-4);
        EXPECT_LT((now.spin - start.spin).norm(), 1e-4);
        const Vector3d fall = start.com + start.momentum / start.mass * t - Vector3d(0, 0, 0.5 * kGravity * t * t);
        EXPECT_LT((now.com - fall).norm(), 1e-7);
        if (count > 0 && count % 2 == 0) {
          lost += kStep / 3 * (before + 4 * midway + now.dissipation);
          worst_energy = std::max(worst_energy, std::abs(start.energy - now.energy - lost));
        }
        (count % 2 == 0 ? before : midway) = now.dissipation;
        ++count;
      },
      [&] { return count > kSteps; });
  EXPECT_GT(lost, 100);
  EXPECT_LT(worst_energy, 1e-6 * lost);
}

}  // namespace
}  // namespace fourpost
