#include "tests/fuzz/fuzz_target.h"

#include <stdexcept>

namespace fourpost {

void Require(bool condition, const std::string& claim, const std::string& details) {
  if (!condition) throw std::logic_error("not so: " + claim + (details.empty() ? "" : "\n" + details));
}

}  // namespace fourpost
