// The balances of momentum and energy of a car of all elements that nothing holds.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/gravity.h"
#include "vehicles/loops/chart.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost::free_car_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A car of all elements that nothing but gravity acts on from outside.
Vehicle FreeCar() {
  Vehicle car = ElementCar();
  for (Tyre& tyre : car.tyres) {
    tyre.law = {};
    tyre.lateral = tyre.longitudinal = {};
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
}  // namespace fourpost::free_car_test
