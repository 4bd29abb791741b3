#include "vehicles/ride/chassis_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "analysis/numerics/decompositions.h"
#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

double Square(double value) { return value * value; }

std::optional<double> NaturalHz(double stiffness, const std::optional<double>& mass) {
  if (!mass || !(*mass > 0) || !(stiffness > 0) || !std::isfinite(stiffness)) return std::nullopt;
  return std::sqrt(stiffness / *mass) / (2 * std::numbers::pi);
}

/// Force over speed of a damper in bump or rebound.
double RateAt(const Damper& damper, double speed, std::span<const double> parameters) {
  if (damper.hydraulic) {
    HydraulicDamper hydraulic = damper.HydraulicAt(parameters);
    hydraulic.friction = 0;
    return hydraulic.SteadyForce(speed) / speed;
  }
  DashpotDescription law = damper.law;
  law.friction.reset();
  return law.At(parameters).Force(speed) / speed;
}

class Numbers {
 public:
  Numbers(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension, const HeldChassis& held,
          const RideGeometry& ride, std::span<const double> loads, const MassProperties& whole,
          std::span<const double> parameters)
      : vehicle_(vehicle),
        pose_(pose),
        suspension_(suspension),
        held_(held),
        ride_(ride),
        loads_(loads),
        whole_(whole),
        parameters_(parameters) {}

  ChassisNumbers All() {
    for (std::size_t a = 0; a < suspension_.axles.size(); ++a) numbers_.axles.push_back(AxleOf(a));
    for (std::size_t i = 0; i < suspension_.wheels.size(); ++i) numbers_.corners.push_back(CornerOf(i));
    if (suspension_.axles.size() == 2) {
      const double wheelbase = Middle(0).x() - Middle(1).x();
      numbers_.wheelbase_m = wheelbase;
      numbers_.com_height_m = whole_.com.z() - GroundHeight();
      AddWeights();
      if (!StandsOnFeet()) return numbers_;
      if (IsFree({1, 2, 3})) AddRoll();
      if (IsFree({0, 2, 4})) AddPitch();
    }
    return numbers_;
  }

 private:
  const Axle& At(std::size_t a) const { return suspension_.axles[a]; }
  double Count(std::size_t a) const { return static_cast<double>(At(a).wheels.size()); }

  template <typename Number>
  double Sum(std::size_t a, const Number& number) const {
    double sum = 0;
    for (const std::size_t i : At(a).wheels) sum += number(i);
    return sum;
  }

  /// Whether heights above the feet are heights above the ground, as they are not of tyres at the wheel centres.
  bool StandsOnFeet() const {
    constexpr double kOnGround_m = 0.05;
    return std::all_of(suspension_.wheels.begin(), suspension_.wheels.end(),
                       [](const Wheel& wheel) { return std::abs(wheel.foot.z()) < kOnGround_m; });
  }

  /// Whether the chassis moves freely along and about these axes: its wheels carry all forces, no joint to the ground.
  bool IsFree(const std::array<Eigen::Index, 3>& directions) const {
    constexpr double kStopped = 1e-6;
    if (suspension_.chassis < 0) return false;
    const BodyMotion& chassis = suspension_.bodies[static_cast<std::size_t>(suspension_.chassis)];
    Eigen::MatrixXd all(6, chassis.com_jacobian.cols());
    all << chassis.com_jacobian, chassis.spin_jacobian;
    Eigen::MatrixXd rows(3, all.cols());
    for (Eigen::Index k = 0; k < 3; ++k) rows.row(k) = all.row(directions[static_cast<std::size_t>(k)]);
    return (SingularValuesOf(rows, SingularValues::kLeft).values.array() > kStopped).count() == 3;
  }

  /// Of the feet.
  Eigen::Vector3d Middle(std::size_t a) const {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::size_t i : At(a).wheels) middle += suspension_.wheels[i].foot / Count(a);
    return middle;
  }

  std::size_t AxleWith(std::size_t wheel) const {
    std::size_t a = 0;
    while (std::find(At(a).wheels.begin(), At(a).wheels.end(), wheel) == At(a).wheels.end()) ++a;
    return a;
  }

  AxleNumbers AxleOf(std::size_t a) const {
    AxleNumbers axle;
    axle.load_N = Sum(a, [&](std::size_t i) { return loads_[i]; });
    axle.is_beam = IsBeam(a);
    const std::optional<WheelTravel> together = held_.MoveTogether(At(a));
    if (together) {
      double mass = 0;
      for (const BodyMotion& body : suspension_.bodies)
        mass += body.mass.mass * body.com_jacobian.row(2).dot(together->motion);
      axle.unsprung_kg = mass;
      axle.sprung_kg = axle.load_N / kGravity - mass;
      axle.ride_Hz =
          NaturalHz(Sum(a, [&](std::size_t i) { return ride_.wheels[i].together.ride_Npm; }), axle.sprung_kg);
      axle.hop_Hz = NaturalHz(
          Sum(a, [&](std::size_t i) { return ride_.wheels[i].together.wheel_Npm + ride_.wheels[i].tyre_Npm; }),
          axle.unsprung_kg);
      AddSupport(a, *together, axle);
    }
    const std::optional<WheelTravel> roll = held_.Roll(At(a));
    if (roll && ride_.axles[a].roll_Nm) {
      axle.elastic_roll_Nm = ElasticEnergy(roll->motion);
      const double on_tyres = Sum(a, [&](std::size_t i) {
        return ride_.wheels[i].tyre_Npm * Square(suspension_.wheels[i].foot.y() - Middle(a).y());
      });
      const double springs = *ride_.axles[a].roll_Nm;
      axle.roll_on_tyres_Nm = springs * on_tyres / (springs + on_tyres);
      // The wheels roll with their left side up: the ground turns about the roll centre.
      axle.roll_centre_m = Sum(a, [&](std::size_t i) {
        return pose_.FootPosition(vehicle_.tyres[i], Eigen::Vector3d::UnitY()).gradient.dot(roll->motion) / Count(a);
      });
    }
    return axle;
  }

  bool IsBeam(std::size_t a) const {
    if (At(a).wheels.size() < 2) return false;
    for (const BodyMotion& body : suspension_.bodies) {
      const double carried = Sum(a, [&](std::size_t i) {
        return std::find(body.links.begin(), body.links.end(), suspension_.wheels[i].carrier) != body.links.end();
      });
      if (carried == Count(a)) return true;
    }
    return false;
  }

  /// Twice the energy of all springs, bars and bushes: s' K s without preloads and tyres.
  double ElasticEnergy(const Eigen::VectorXd& motion) const {
    double energy = 0;
    for (const Spring& spring : vehicle_.springs)
      energy += spring.law.At(parameters_).Slope(0) * Square(pose_.LineLength(spring.line).gradient.dot(motion));
    for (const AntiRollBar& bar : vehicle_.antiroll_bars)
      energy += bar.stiffness.At(parameters_) * Square(pose_.Twist(bar).gradient.dot(motion));
    for (const Bushing& bushing : vehicle_.bushings) {
      const std::array<Coordinate, 6> place = pose_.BushingPlace(bushing, pose_.ChildAxes(bushing));
      for (std::size_t k = 0; k < place.size(); ++k)
        energy += bushing.stiffness[k].At(parameters_) * Square(place[k].gradient.dot(motion));
    }
    return energy;
  }

  /// How far forward the carrier's point goes, which is at the foot or at the wheel's centre.
  double Forward(std::size_t wheel, bool at_foot, const Eigen::VectorXd& motion) const {
    const int carrier = suspension_.wheels[wheel].carrier;
    const Eigen::Vector3d place =
        at_foot ? suspension_.wheels[wheel].foot : pose_.Location(vehicle_.tyres[wheel].point);
    const Eigen::Vector3d arm = place - pose_.Location({carrier, Eigen::Vector3d::Zero()});
    const Point point{carrier, pose_.Rotation(carrier).transpose() * arm};
    return pose_.PointJacobian(point).row(0).dot(motion);
  }

  void AddSupport(std::size_t a, const WheelTravel& together, AxleNumbers& axle) const {
    const auto forward = [&](bool at_foot) {
      return Sum(a, [&](std::size_t i) { return Forward(i, at_foot, together.motion) / Count(a); });
    };
    // In front, braking lowers the body and driving lifts it; in the rear it is the other way about.
    const bool is_front = a == 0;
    axle.braking_support = (is_front ? 1 : -1) * forward(true);
    axle.driving_support = (is_front ? 1 : -1) * forward(axle.is_beam);
  }

  CornerNumbers CornerOf(std::size_t wheel) const {
    constexpr double kSpeed = 0.1;  // m/s
    CornerNumbers corner;
    const std::size_t a = AxleWith(wheel);
    if (const std::optional<double>& unsprung = numbers_.axles[a].unsprung_kg)
      corner.sprung_kg = loads_[wheel] / kGravity - *unsprung / Count(a);
    for (std::size_t d = 0; d < vehicle_.dampers.size(); ++d) {
      const StrutGeometry& strut = ride_.dampers[d];
      if (strut.wheel != static_cast<int>(wheel) || !strut.together) continue;
      const double square = Square(*strut.together);
      // A damper that lengthens in bump works the other way.
      const double bump = *strut.together > 0 ? -kSpeed : kSpeed;
      corner.bump_Nspm += square * RateAt(vehicle_.dampers[d], bump, parameters_);
      corner.rebound_Nspm += square * RateAt(vehicle_.dampers[d], -bump, parameters_);
    }
    const double rate = ride_.wheels[wheel].together.wheel_Npm;
    if (!corner.sprung_kg || !(*corner.sprung_kg > 0) || !(rate > 0) || !std::isfinite(rate)) return corner;
    const double critical = 2 * std::sqrt(rate * *corner.sprung_kg);
    corner.bump_ratio = corner.bump_Nspm / critical;
    corner.rebound_ratio = corner.rebound_Nspm / critical;
    return corner;
  }

  void AddWeights() {
    double all = 0;
    double left = 0;
    double cross = 0;
    for (std::size_t a = 0; a < 2; ++a)
      for (const std::size_t i : At(a).wheels) {
        const int side = suspension_.wheels[i].side;
        if (At(a).wheels.size() != 2 || side == 0) return;
        all += loads_[i];
        if (side > 0) left += loads_[i];
        if ((a == 0) == (side < 0)) cross += loads_[i];
      }
    numbers_.left_share = left / all;
    numbers_.cross_weight = cross / all;
  }

  void AddRoll() {
    for (const AxleNumbers& axle : numbers_.axles)
      if (!axle.unsprung_kg || !axle.roll_on_tyres_Nm || !axle.roll_centre_m) return;
    numbers_.roll_arm_m = RollArm();
    // Per roll of the ground against the chassis, left side up, about the roll axis.
    const Eigen::VectorXd turns[2] = {held_.Roll(At(0))->motion, held_.Roll(At(1))->motion};
    double stiffness = 0;
    for (const AxleNumbers& axle : numbers_.axles) stiffness += *axle.roll_on_tyres_Nm;
    double moment = 0;
    double weight_moment = 0;
    double of_links[2] = {0, 0};
    for (const BodyMotion& body : suspension_.bodies) {
      double lever = body.mass.com.z() - GroundHeight();
      double lean = 1;
      for (std::size_t a = 0; a < 2; ++a) {
        const double links =
            ShareOf(a, body.mass.com.x()) * *numbers_.axles[a].roll_centre_m - body.com_jacobian.row(1).dot(turns[a]);
        of_links[a] += body.mass.mass * links;
        lever -= links;
        lean -= body.spin_jacobian.row(0).dot(turns[a]);
      }
      moment += body.mass.mass * lever;
      weight_moment += body.mass.mass * kGravity * lever * lean;
    }
    // Beyond this the springs do not hold the body.
    if (!(stiffness > weight_moment)) return;
    numbers_.roll_gradient = moment / (stiffness - weight_moment);
    double transfer = 0;
    for (std::size_t a = 0; a < 2; ++a) {
      AxleNumbers& axle = numbers_.axles[a];
      axle.load_transfer = (*axle.roll_on_tyres_Nm * *numbers_.roll_gradient + of_links[a]) / Track(a);
      transfer += *axle.load_transfer;
    }
    for (AxleNumbers& axle : numbers_.axles) axle.load_transfer_share = *axle.load_transfer / transfer;
  }

  double GroundHeight() const { return (Middle(0).z() + Middle(1).z()) / 2; }

  /// Of a force at this place along the car, how much the axle carries.
  double ShareOf(std::size_t a, double x) const {
    const double rear = (Middle(0).x() - x) / *numbers_.wheelbase_m;
    return a == 0 ? 1 - rear : rear;
  }

  double RollArm() const {
    double mass = whole_.mass;
    double height = whole_.mass * *numbers_.com_height_m;
    double place = whole_.mass * whole_.com.x();
    for (std::size_t a = 0; a < 2; ++a) {
      const double unsprung = *numbers_.axles[a].unsprung_kg;
      mass -= unsprung;
      height -= unsprung * CentreHeight(a);
      place -= unsprung * Middle(a).x();
    }
    const double axis = ShareOf(0, place / mass) * *numbers_.axles[0].roll_centre_m +
                        ShareOf(1, place / mass) * *numbers_.axles[1].roll_centre_m;
    return height / mass - axis;
  }

  /// Of the wheel centres above the feet.
  double CentreHeight(std::size_t a) const {
    return Sum(a, [&](std::size_t i) {
      return (pose_.Location(vehicle_.tyres[i].point).z() - suspension_.wheels[i].foot.z()) / Count(a);
    });
  }
  double Track(std::size_t a) const {
    // Of pairs of sides; pairs of tyres count with their mean.
    return 2 *
           Sum(a, [&](std::size_t i) { return std::abs(suspension_.wheels[i].foot.y() - Middle(a).y()) / Count(a); });
  }

  void AddPitch() {
    // A hundred wheelbases away.
    constexpr double kParallel = 0.01;
    const double slenderness = *numbers_.wheelbase_m / *numbers_.com_height_m;
    double load = 0;
    for (const AxleNumbers& axle : numbers_.axles) load += axle.load_N;
    for (AxleNumbers& axle : numbers_.axles) {
      if (!axle.unsprung_kg || !(*numbers_.com_height_m > 0) || !(load > 0)) return;
      axle.anti_braking = axle.braking_support * slenderness * axle.load_N / load;
      axle.anti_driving = axle.driving_support * slenderness;
    }
    // z = z_foot - forward (x - x_foot), forward: of the foot per rise.
    const double front = numbers_.axles[0].braking_support;
    const double rear = -numbers_.axles[1].braking_support;
    if (std::abs(front - rear) < kParallel) return;
    const double offset = Middle(0).z() - Middle(1).z() + front * Middle(0).x() - rear * Middle(1).x();
    const double x = offset / (front - rear);
    numbers_.pitch_centre = {x, Middle(0).z() - front * (x - Middle(0).x())};
  }

  const Vehicle& vehicle_;
  const Kinematics& pose_;
  const Suspension& suspension_;
  const HeldChassis& held_;
  const RideGeometry& ride_;
  std::span<const double> loads_;
  const MassProperties& whole_;
  std::span<const double> parameters_;
  ChassisNumbers numbers_;
};

}  // namespace

ChassisNumbers ChassisNumbersOf(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension,
                                const HeldChassis& held, const RideGeometry& ride, std::span<const double> loads_N,
                                const MassProperties& whole, std::span<const double> parameters) {
  return Numbers(vehicle, pose, suspension, held, ride, loads_N, whole, parameters).All();
}

}  // namespace fourpost
