#pragma once

#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "identify/residuals/vehicle_objective.h"

namespace fourpost {

/// Residuals of a curve with parameters p0, p1, ... that each start at 1, between 0.2 and 5, all free.
/// `model`: its N residuals. `accuracy`: see Problem.
inline VehicleObjective ToyObjective(std::size_t parameters, Eigen::Index count, double accuracy,
                                     std::function<Eigen::VectorXd(const std::vector<double>&)> model) {
  Vehicle vehicle;
  for (std::size_t i = 0; i < parameters; ++i) {
    Parameter parameter;
    parameter.name = "p" + std::to_string(i);
    parameter.value = 1;
    parameter.lower = 0.2;
    parameter.upper = 5;
    parameter.precision = 1e-3;
    vehicle.parameters.push_back(parameter);
  }
  std::vector<std::size_t> free(parameters);
  std::iota(free.begin(), free.end(), 0);
  ResidualBlock block{.name = "toy", .count = count, .accuracy = accuracy};
  block.evaluate = [model = std::move(model)](const std::vector<double>& values, const Deadline&) {
    return Evaluation{.residuals = model(values)};
  };
  return {std::move(vehicle), std::move(free), {std::move(block)}};
}

/// In [-1, 1), a jump at every whole number.
inline double Sawtooth(double x) { return 2 * (x - std::floor(x)) - 1; }

}  // namespace fourpost
