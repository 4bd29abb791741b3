#pragma once

#include <algorithm>
#include <cstddef>

#include "analysis/text/option_check.h"

namespace fourpost {

/// The middle one of `values` (a std::vector or std::array of numbers), the mean of the two middle ones of an even
/// count; infinite ones count. Throws std::invalid_argument without any.
template <typename Values>
double Median(Values values) {
  RequireOption(!values.empty(), "Median: values", 0, "one at least");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace fourpost
