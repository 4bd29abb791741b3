#include "vehicles/ride/ride_geometry.h"

#include <cmath>

namespace fourpost {
namespace {

using Travel = std::optional<WheelTravel>;

WheelRates::Rates RatesOf(const Travel& travel, std::size_t wheel, double tyre) {
  if (!travel) return {.ride_Npm = tyre};
  const double rate = travel->force[static_cast<Eigen::Index>(wheel)];
  return {rate, rate == 0 ? 0 : rate * tyre / (rate + tyre)};
}

AxleRates RollOf(const Suspension& suspension, const Axle& axle, const Travel& roll) {
  if (!roll || !axle.HasTwoSides(suspension.wheels)) return {};
  return {roll->force.dot(roll->rise)};
}

double MeanRate(const Damper& damper, std::span<const double> parameters) {
  return damper.hydraulic ? damper.HydraulicAt(parameters).MeanRate() : damper.law.At(parameters).MeanRate();
}

/// Ratios of elements to the wheels, from the travels found once.
class Ratios {
 public:
  Ratios(const Suspension& suspension, std::vector<Travel> alone, std::vector<Travel> together)
      : suspension_(suspension), alone_(std::move(alone)), together_(std::move(together)) {}

  StrutGeometry Of(const Coordinate& length, double rate) const {
    StrutGeometry strut{.length_m = length.value, .rate = rate};
    double most = kUnmoved;
    for (std::size_t a = 0; a < suspension_.axles.size(); ++a)
      for (const std::size_t i : suspension_.axles[a].wheels) {
        const double share = std::abs(Compression(length, alone_[i] ? alone_[i] : together_[a]));
        // Of equals the first: rounding shall not choose.
        if (share <= most * (1 + kUnmoved)) continue;
        most = share;
        strut.wheel = static_cast<int>(i);
        strut.alone = RatioOf(length, alone_[i]);
        strut.together = RatioOf(length, together_[a]);
      }
    return strut;
  }

 private:
  /// A micrometre of an element per metre of a wheel: rounding is far below.
  static constexpr double kUnmoved = 1e-6;

  static std::optional<double> RatioOf(const Coordinate& length, const Travel& travel) {
    if (!travel) return std::nullopt;
    return -length.gradient.dot(travel->motion);
  }
  static double Compression(const Coordinate& length, const Travel& travel) {
    return RatioOf(length, travel).value_or(0);
  }

  const Suspension& suspension_;
  std::vector<Travel> alone_;
  std::vector<Travel> together_;
};

std::optional<double> UnsprungMass(const Suspension& suspension, const HeldChassis& held) {
  const Travel all = held.MoveAll();
  if (suspension.wheels.empty() || !all) return std::nullopt;
  double mass = 0;
  for (const BodyMotion& body : suspension.bodies) mass += body.mass.mass * body.com_jacobian.row(2).dot(all->motion);
  return mass;
}

}  // namespace

RideGeometry RideGeometryOf(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension,
                            const HeldChassis& held, std::span<const double> tyre_loads,
                            std::span<const double> parameters) {
  RideGeometry ride;
  std::vector<Travel> alone;
  std::vector<Travel> together;
  for (std::size_t i = 0; i < suspension.wheels.size(); ++i) alone.push_back(held.MoveOne(i));
  ride.wheels.resize(suspension.wheels.size());
  for (const Axle& axle : suspension.axles) {
    together.push_back(held.MoveTogether(axle));
    ride.axles.push_back(RollOf(suspension, axle, held.Roll(axle)));
    for (const std::size_t i : axle.wheels) {
      const double tyre = vehicle.tyres[i].law.RateAt(parameters, tyre_loads[i]);
      ride.wheels[i] = {tyre, RatesOf(alone[i], i, tyre), RatesOf(together.back(), i, tyre)};
    }
  }
  const Ratios ratios(suspension, std::move(alone), std::move(together));
  for (const Spring& spring : vehicle.springs)
    ride.springs.push_back(ratios.Of(pose.LineLength(spring.line), spring.law.At(parameters).Slope(0)));
  for (const Damper& damper : vehicle.dampers)
    ride.dampers.push_back(ratios.Of(pose.LineLength(damper.line), MeanRate(damper, parameters)));
  for (const AntiRollBar& bar : vehicle.antiroll_bars)
    ride.antiroll_bars.push_back(ratios.Of(pose.Twist(bar), bar.stiffness.At(parameters)));
  ride.unsprung_mass_kg = UnsprungMass(suspension, held);
  return ride;
}

}  // namespace fourpost
