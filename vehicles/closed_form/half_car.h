#pragma once

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/laws/dashpot_law.h"

namespace fourpost {

/// Model 1 of the thesis (5.1-5.14), closed form: body heave and pitch on two unsprung masses, q = (z_s, theta, z_f,
/// z_r) from static equilibrium, z up, theta nose down. Front and rear rates are sums of both sides.
struct HalfCar {
  double sprung_mass = 0;           // kg
  double pitch_inertia = 0;         // kg m^2
  double front_mass = 0;            // kg, unsprung
  double rear_mass = 0;             // kg, unsprung
  double front_stiffness = 0;       // N/m
  double rear_stiffness = 0;        // N/m
  double front_tyre_stiffness = 0;  // N/m
  double rear_tyre_stiffness = 0;   // N/m
  DashpotLaw front_damper;          // N s/m
  DashpotLaw rear_damper;           // N s/m
  double front_length = 0;          // m, centre of mass to front axle
  double rear_length = 0;           // m, centre of mass to rear axle

  /// Matrices of M q'' + K q + sum d_k f_k = B (z_gf, z_gr); no sensors.
  CondensedModel Model() const;

  /// q'' for q, q' and ground heights (front, rear).
  Eigen::Vector4d Acceleration(const Eigen::Vector4d& q, const Eigen::Vector4d& rate,
                               const Eigen::Vector2d& ground) const;
};

/// The same for numbers T that may carry derivatives, of a car with HalfCar's members and dampers with Force(rate).
template <typename T, typename Car>
Eigen::Vector<T, 4> HalfCarAcceleration(const Car& car, const Eigen::Vector<T, 4>& q, const Eigen::Vector<T, 4>& rate,
                                        const Eigen::Vector2d& ground) {
  const T front_rate = rate[0] - car.front_length * rate[1] - rate[2];
  const T rear_rate = rate[0] + car.rear_length * rate[1] - rate[3];
  const T front = car.front_stiffness * (q[0] - car.front_length * q[1] - q[2]) + car.front_damper.Force(front_rate);
  const T rear = car.rear_stiffness * (q[0] + car.rear_length * q[1] - q[3]) + car.rear_damper.Force(rear_rate);
  return {-(front + rear) / car.sprung_mass, (car.front_length * front - car.rear_length * rear) / car.pitch_inertia,
          (front - car.front_tyre_stiffness * (q[2] - ground[0])) / car.front_mass,
          (rear - car.rear_tyre_stiffness * (q[3] - ground[1])) / car.rear_mass};
}

}  // namespace fourpost
