#pragma once

#include <stdexcept>

namespace fourpost {

/// A simulation that cannot be computed: what() names the simulation and the time. It alone causes the program's exit
/// code 4.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace fourpost
