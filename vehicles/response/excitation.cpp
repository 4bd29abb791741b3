#include "vehicles/response/excitation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/text/count_check.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// Cheap while all is well: it is asked once per evaluation of a fit.
template <typename Test>
void RequireEach(const char* field, const std::vector<double>& values, Test is_good, const char* bound) {
  const auto bad = std::find_if_not(values.begin(), values.end(), is_good);
  if (bad == values.end()) return;
  RequireOption(false, "Excitation: " + std::string(field) + "[" + std::to_string(bad - values.begin()) + "]", *bad,
                bound);
}

bool IsPositive(double value) { return value > 0 && std::isfinite(value); }

bool IsFinite(double value) { return std::isfinite(value); }

}  // namespace

void Excitation::Validate(std::size_t post_count) const {
  RequireCount("Excitation: amplitude_m", "frequencies", frequency_Hz.size(), amplitude_m.size());
  RequireCount("Excitation: shape", "posts", post_count, shape.size());
  RequireEach("frequency_Hz", frequency_Hz, IsPositive, "positive and finite");
  RequireEach("amplitude_m", amplitude_m, IsPositive, "positive and finite");
  RequireEach("shape", shape, IsFinite, "finite");
}

}  // namespace fourpost
