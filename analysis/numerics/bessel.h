#pragma once

namespace fourpost {

/// Modified Bessel function of the second kind and first order K1(x), x > 0, to rounding: std::cyl_bessel_k, which not
/// every standard library has.
double BesselK1(double x);

}  // namespace fourpost
