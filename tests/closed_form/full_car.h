#pragma once

#include <array>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/laws/dashpot_law.h"

namespace fourpost {

/// Model 3 of the thesis, closed form: body heave, roll and pitch, heave and roll of two beam axles,
///   q = (z_s, phi_s, theta, z_f, phi_f, z_r, phi_r)
/// of the centres of mass from static equilibrium, z up, roll left side up, theta nose down. With s, d and t the y of
/// spring, damper and tyre of corner i, and a its axle:
///   delta = z_s + (s - y_s) phi_s - x theta - z_a - (s - y_a) phi_a, eta' alike with d for s
///   F_k = k delta, F_d = f(eta'), F_t = k_t (z_a + (t - y_a) phi_a - z_g)
///   m_s z_s'' = -sum (F_k + F_d)                  m_a z_a'' = sum (F_k + F_d - F_t)
///   I_xx phi_s'' = -sum [(s - y_s) F_k + (d - y_s) F_d]
///   I_yy theta'' = sum x (F_k + F_d)              I_a phi_a'' = sum [(s - y_a) F_k + (d - y_a) F_d - (t - y_a) F_t]
/// Corners in the order FL FR RL RR. The thesis's appendix C, in axes x forward, y left, z up and with the centres of
/// mass as origins, where gravity has no part.
struct FullCar {
  struct Axle {
    double mass = 0;            // kg
    double roll_inertia = 0;    // kg m^2
    double offset = 0;          // m, y of the centre of mass
    double x = 0;               // m, ahead of the body's centre of mass
    double spring_station = 0;  // m, y of the left spring; the right one mirrors it
    double damper_station = 0;  // m
    double tyre_station = 0;    // m
    DashpotLaw damper;          // N s/m, each side's
  };

  double sprung_mass = 0;                  // kg
  double roll_inertia = 0;                 // kg m^2
  double pitch_inertia = 0;                // kg m^2
  double offset = 0;                       // m, y of the body's centre of mass
  std::array<double, 4> stiffness{};       // N/m
  std::array<double, 4> tyre_stiffness{};  // N/m
  Axle front;
  Axle rear;

  /// Matrices of M q'' + K q + sum d_i f_i = B z_g; no sensors.
  CondensedModel Model() const;

  /// q'' for q, q' and ground heights.
  Eigen::Vector<double, 7> Acceleration(const Eigen::Vector<double, 7>& q, const Eigen::Vector<double, 7>& rate,
                                        const Eigen::Vector4d& ground) const;
};

}  // namespace fourpost
