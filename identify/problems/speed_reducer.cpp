#include "identify/problems/speed_reducer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fourpost {
namespace {

Evaluation Weight(const Eigen::VectorXd& design) {
  const double face = design[0], module = design[1], teeth = design[2];
  const double first_length = design[3], second_length = design[4], first = design[5], second = design[6];
  const auto stress = [&](double length, double constant) {
    return std::sqrt(std::pow(745 * length / (module * teeth), 2) + constant);
  };
  // Each at most 1.
  const std::array<double, 11> used = {
      27 / (face * module * module * teeth),
      397.5 / (face * module * module * teeth * teeth),
      1.93 * std::pow(first_length, 3) / (module * teeth * std::pow(first, 4)),
      1.93 * std::pow(second_length, 3) / (module * teeth * std::pow(second, 4)),
      stress(first_length, 16.9e6) / (110 * std::pow(first, 3)),
      stress(second_length, 157.5e6) / (85 * std::pow(second, 3)),
      module * teeth / 40,
      5 * module / face,
      face / (12 * module),
      (1.5 * first + 1.9) / first_length,
      (1.1 * second + 1.9) / second_length,
  };
  // At the best design the module is at its bound and so is its ratio to the face width, but for rounding.
  constexpr double kRounding = 1e-12;
  double violation = 0;
  for (const double share : used) violation += std::max(0.0, share - 1 - kRounding);
  if (violation > 0) return Infeasible(violation, "a constraint is violated");
  const double weight = 0.7854 * face * module * module * (3.3333 * teeth * teeth + 14.9334 * teeth - 43.0934) -
                        1.508 * face * (first * first + second * second) +
                        7.4777 * (std::pow(first, 3) + std::pow(second, 3)) +
                        0.7854 * (first_length * first * first + second_length * second * second);
  Evaluation evaluation;
  evaluation.residuals = Eigen::VectorXd::Constant(1, std::sqrt(weight));
  return evaluation;
}

LatticeAxis Length(const char* name, double lower, double upper) {
  return {.name = name, .lower = lower, .upper = upper, .precision = 1e-6};
}

}  // namespace

Problem SpeedReducerProblem() {
  return {Lattice({Length("face_width", 2.6, 3.6),
                   Length("module", 0.7, 0.8),
                   {.name = "teeth", .lower = 17, .upper = 28, .precision = 1, .discrete = true},
                   Length("first_length", 7.3, 8.3),
                   Length("second_length", 7.3, 8.3),
                   Length("first_diameter", 2.9, 3.9),
                   Length("second_diameter", 5, 5.5)}),
          Weight, 1};
}

}  // namespace fourpost
