#include "identify/problems/coil_spring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fourpost {
namespace {

// Every constraint is g <= 0; `scale` makes violations of all of them comparable.
struct Constraint {
  double g = 0;
  double scale = 1;
};

Evaluation Volume(const Eigen::VectorXd& design) {
  const double coils = design[0];
  const double wire = kSpringWires_in.at(static_cast<std::size_t>(std::lround(design[1])) - 1);
  const double diameter = design[2];
  const double max_load = 1000, preload = 300, longest = 14, strength = 189000, shear_modulus = 11.5e6;
  const double index = diameter / wire;
  const double stress_factor = (4 * index - 1) / (4 * index - 4) + 0.615 / index;
  const double stress = 8 * stress_factor * max_load * diameter / (std::numbers::pi * std::pow(wire, 3));
  const double rate = shear_modulus * std::pow(wire, 4) / (8 * coils * std::pow(diameter, 3));
  const double solid = 1.05 * (coils + 2) * wire;
  const double free_length = max_load / rate + solid;
  const std::array<Constraint, 8> constraints = {{
      {stress - strength, strength},
      {free_length - longest, longest},
      {0.2 - wire, 0.2},
      {diameter - 3, 3},
      {3 - index, 3},
      {preload / rate - 6, 6},
      // Zero by definition, but for rounding.
      {preload / rate + (max_load - preload) / rate + solid - free_length - 1e-9, longest},
      {1.25 - (max_load - preload) / rate, 1.25},
  }};
  double violation = 0;
  bool violated = false;
  for (const auto& [g, scale] : constraints) {
    violated = violated || !(g <= 0);
    // An index below 1 makes the stress factor negative or infinite: that alone is no less violation.
    violation += std::clamp(g / scale, 0.0, 1e6);
  }
  if (violated) return Infeasible(violation, "a constraint is violated");
  Evaluation evaluation;
  const double volume = std::pow(std::numbers::pi, 2) * diameter * wire * wire * (coils + 2) / 4;
  evaluation.residuals = Eigen::VectorXd::Constant(1, std::sqrt(volume));
  return evaluation;
}

}  // namespace

Problem CoilSpringProblem(double diameter_step) {
  return {Lattice({{.name = "coils", .lower = 1, .upper = 70, .precision = 1, .discrete = true},
                   {.name = "wire", .lower = 1, .upper = 42, .precision = 1, .discrete = true},
                   {.name = "diameter", .lower = 0.6, .upper = 3, .precision = diameter_step}}),
          Volume, 1};
}

}  // namespace fourpost
