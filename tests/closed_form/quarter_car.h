#pragma once

#include <array>
#include <complex>

#include <Eigen/Core>

#include "vehicles/laws/dashpot_law.h"

namespace fourpost {

/// Quarter car in closed form, coordinates from static equilibrium, up positive (thesis 4.5-4.10):
///   sprung z_s'' = -stiffness (z_s - z_u) - f_d
///   unsprung z_u'' = stiffness (z_s - z_u) + f_d - tyre (z_u - z_g)
/// f_d: tension of the damper at the rate z_s' - z_u'.
struct QuarterCar {
  double sprung_mass = 0;       // kg
  double unsprung_mass = 0;     // kg
  double stiffness = 0;         // N/m
  double tyre_stiffness = 0;    // N/m
  DashpotLaw damper;            // equal rates: the linear model
  double series_stiffness = 0;  // N/m; 0: none

  /// Of [z_s z_u z_s' z_u'] with the dashpot at its mean rate. Thesis eq. 4.12 misprints the last row; this one follows
  /// from the equations above.
  Eigen::Matrix4d StateMatrix() const;

  /// Input column of StateMatrix for the ground height z_g: [0 0 0 tyre/unsprung]'.
  Eigen::Vector4d InputVector() const;

  /// z_s / z_g and z_u / z_g with the dashpot at its mean rate, no series spring.
  std::array<std::complex<double>, 2> Response(double frequency_Hz) const;

  /// Rate of [z_s z_u z_s' z_u' x], x the extension of the series spring (0 without one).
  Eigen::Matrix<double, 5, 1> Derivative(const Eigen::Matrix<double, 5, 1>& state, double ground_height) const;
};

}  // namespace fourpost
