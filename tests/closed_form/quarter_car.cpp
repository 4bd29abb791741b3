#include "tests/closed_form/quarter_car.h"

#include <numbers>

#include "vehicles/laws/series_damper.h"

namespace fourpost {

Eigen::Matrix4d QuarterCar::StateMatrix() const {
  const double d = damper.MeanRate();
  Eigen::Matrix4d a;
  a << 0, 0, 1, 0,  //
      0, 0, 0, 1,   //
      -stiffness / sprung_mass, stiffness / sprung_mass, -d / sprung_mass, d / sprung_mass, stiffness / unsprung_mass,
      -(stiffness + tyre_stiffness) / unsprung_mass, d / unsprung_mass, -d / unsprung_mass;
  return a;
}

Eigen::Vector4d QuarterCar::InputVector() const { return {0, 0, 0, tyre_stiffness / unsprung_mass}; }

std::array<std::complex<double>, 2> QuarterCar::Response(double frequency_Hz) const {
  const double w = 2 * std::numbers::pi * frequency_Hz;
  const std::complex<double> strut(stiffness, w * damper.MeanRate());
  const std::complex<double> sprung = strut - w * w * sprung_mass;
  const std::complex<double> unsprung = strut + tyre_stiffness - w * w * unsprung_mass;
  // [sprung -strut; -strut unsprung] [z_s z_u]' = [0 tyre]' z_g.
  const std::complex<double> determinant = sprung * unsprung - strut * strut;
  return {strut * tyre_stiffness / determinant, sprung * tyre_stiffness / determinant};
}

Eigen::Matrix<double, 5, 1> QuarterCar::Derivative(const Eigen::Matrix<double, 5, 1>& state,
                                                   double ground_height) const {
  const double rate = state[2] - state[3];
  const SeriesDamper series{damper, {.stiffness = series_stiffness, .knees = {}}};
  const double tension = series_stiffness > 0 ? series.Force(state[4]) : damper.Force(rate);
  const double strut = stiffness * (state[0] - state[1]) + tension;
  Eigen::Matrix<double, 5, 1> out;
  out << state[2], state[3], -strut / sprung_mass,
      (strut - tyre_stiffness * (state[1] - ground_height)) / unsprung_mass,
      series_stiffness > 0 ? series.SpringRate(rate, state[4]) : 0;
  return out;
}

}  // namespace fourpost
