#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/text/found.h"

namespace fourpost {

/// A simulation that cannot be computed: what() names it or the time. It alone causes the program's exit
/// code 4.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  explicit SimulationError(const Finding& kind, const std::vector<std::string>& words = {})
      : std::runtime_error(Found{&kind, words}.Text()) {}
};

}  // namespace fourpost
