#pragma once

namespace fourpost {

/// Half width, in standard deviations, of the interval that holds 95 % of Student's distribution: 12.7 for one degree
/// of freedom, 1.96 for very many. Good to 1e-6. Throws std::invalid_argument below one degree.
double StudentT95(double degrees_of_freedom);

}  // namespace fourpost
