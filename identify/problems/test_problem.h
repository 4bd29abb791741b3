#pragma once

#include <array>
#include <string_view>

#include "identify/search/evaluation.h"

namespace fourpost {

/// A problem whose optimum is known, to compare search methods on.
struct TestProblem {
  Problem problem;
  /// A cost at which it counts as solved.
  double target_cost = 0;
};

/// What a study may ask for by `problem:`.
inline constexpr std::array<std::string_view, 8> kTestProblems = {
    "oscillator",    "gear_train", "coil_spring",        "pressure_vessel",
    "speed_reducer", "half_car",   "half_car_frequency", "half_car_out_of_bounds"};

/// One of kTestProblems. Throws std::invalid_argument for another name.
TestProblem MakeTestProblem(std::string_view name);

}  // namespace fourpost
