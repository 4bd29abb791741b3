#pragma once

#include <stdexcept>

namespace fourpost {

/// A simulation that cannot be computed: what() says of what, and from when on. The program's exit code 4 stands for it
/// and for nothing else.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace fourpost
